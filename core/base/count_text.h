#pragma once

#include <cstddef>
#include <string>

namespace kerf {

// A number with grouped digits: "12 345 678".
std::string grouped(size_t number);

// "1 stroke", "3 strokes", "1 234 faces", for a word of which the plural ends in "s".
std::string count_text(size_t count, const std::string& word);

}  // namespace kerf
