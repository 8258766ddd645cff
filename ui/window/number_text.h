#pragma once

#include <cstddef>
#include <string>

namespace kerf {

// 12345678 as "12 345 678".
std::string grouped(size_t number);

// By a format of printf with one number in it: "%.1f MB".
std::string text_of(const char* format, double value);

// Square metres in the unit in which they read best: "2.75 cm²".
std::string area_text(double square_metres);

}  // namespace kerf
