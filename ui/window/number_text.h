#pragma once

#include <cstddef>
#include <string>

namespace kerf {

// A number with grouped digits: "12 345 678".
std::string grouped(size_t number);

// A text in a printf format, which the compiler checks. Of more than 255 bytes the rest is left out.
[[gnu::format(printf, 1, 2)]] std::string text_of(const char* format, ...);

// An area in a unit that suits its size: "2.75 cm²".
std::string area_text(double square_metres);

}  // namespace kerf
