#pragma once

namespace kerf::gl {

// In debug builds prints what the driver complains about to standard error; otherwise, or where the context
// cannot tell, does nothing.
void report_gl_errors();

}  // namespace kerf::gl
