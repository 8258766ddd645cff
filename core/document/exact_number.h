#pragma once

#include <string>

namespace kerf {

// Appends the shortest decimal number that reads back as the same double, the sign of zero included; always
// with a point or an exponent, so that JSON takes it for no integer. x is finite.
void append_number(std::string& text, double x);

}  // namespace kerf
