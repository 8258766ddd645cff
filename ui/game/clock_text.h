#pragma once

#include <string>

namespace kerf {

// Seconds as "2:05"; less than none are none.
std::string clock_text(double seconds);

}  // namespace kerf
