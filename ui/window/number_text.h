#pragma once

#include <string>

#include "core/base/count_text.h"

namespace kerf {

// A text in a printf format, which the compiler checks. Of more than 255 bytes the rest is left out.
[[gnu::format(printf, 1, 2)]] std::string text_of(const char* format, ...);

// An area in a unit that suits its size: "2.75 cm²"; "none" for 0.
std::string area_text(double square_metres);

}  // namespace kerf
