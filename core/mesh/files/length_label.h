#pragma once

#include <string>

#include "core/base/length_text.h"
#include "core/mesh/files/file_frame.h"

namespace kerf {

// Lengths for people in the unit in which the open work is shown. They are given in the numbers of the file.

// "2.75 mm", "0.3 in", with three significant digits.
std::string length_label(double length, FileUnit unit);
// The unit of that label, with its size in the numbers of the file.
LengthUnit label_unit(double length, FileUnit unit);

}  // namespace kerf
