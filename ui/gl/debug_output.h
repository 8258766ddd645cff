#pragma once

namespace kerf::gl {

// Where assertions are fatal (core/base/assert.h), so is each error that the driver reports for the context
// that is current: it is printed on standard error, and the program ends by a signal. Does nothing elsewhere,
// or where the context has no debug output.
void report_gl_errors();

}  // namespace kerf::gl
