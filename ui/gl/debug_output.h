#pragma once

namespace kerf::gl {

// In debug builds, prints errors that the driver reports to standard error. Does nothing in other builds, or
// if the context does not support debug output.
void report_gl_errors();

}  // namespace kerf::gl
