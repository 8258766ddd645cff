#pragma once

#include <cstddef>
#include <string>

namespace kerf {

// A number with grouped digits: "12 345 678".
std::string grouped(size_t number);

// A number in a printf format with one conversion: "%.1f MB".
std::string text_of(const char* format, double value);

// An area in a unit that suits its size: "2.75 cm²".
std::string area_text(double square_metres);

}  // namespace kerf
