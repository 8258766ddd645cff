#pragma once

#include "core/base/result.h"

namespace kerf {

// Says the one sentence on standard error and gives the exit status: 2 for bad input, 1 for what could not be
// done.
int report_error(const Error& error);

}  // namespace kerf
