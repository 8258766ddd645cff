#pragma once

#include <string>

#include "ui/editor/shared/file_frames.h"
#include "ui/window/number_fields.h"

namespace kerf {

// A row with a field for a length in the numbers of the file, shown and typed in a unit (see label_unit),
// with the name of this unit and what follows it: "2.75 mm/s" with "/s". Returns whether a number was
// entered.
bool length_field(NumberFields& fields, const char* name, double& length, const LengthUnit& unit,
                  const char* meaning, const std::string& per = "");

}  // namespace kerf
