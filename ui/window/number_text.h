#pragma once

#include <string>

#include "core/base/count_text.h"
#include "ui/window/number_format.h"

namespace kerf {

// A text in a printf format, which the compiler checks. Of more than 255 bytes the rest is left out.
[[gnu::format(printf, 1, 2)]] std::string text_of(const char* format, ...);

// A number in the format of one number. One that is noise beside `scale`, the size of the quantity, e.g. the
// length of the vector or the extent of the world, is shown as 0, and 0 never has a sign.
std::string number_text(double value, const RealFormat& format, double scale = 0);
// Whether rounding alone explains a number that ought to be 0: it is less than 1e-12 of the scale.
bool is_noise(double value, double scale);

// An area in a unit that suits its size: "2.75 cm²"; "none" for 0.
std::string area_text(double square_metres);

}  // namespace kerf
