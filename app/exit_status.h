#pragma once

#include "core/base/result.h"

namespace kerf {

// Prints the error on standard error and returns the exit status: 2 for bad input, 1 for any other failure.
int report_error(const Error& error);

}  // namespace kerf
