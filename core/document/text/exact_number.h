#pragma once

#include <string>

namespace kerf {

// Appends the shortest decimal number that is read back as the same double, including the sign of zero. It
// always has a point or an exponent, so that JSON does not treat it as an integer. Precondition: x is finite.
void append_number(std::string& text, double x);

}  // namespace kerf
