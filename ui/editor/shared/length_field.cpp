#include "ui/editor/shared/length_field.h"

namespace kerf {

bool length_field(NumberFields& fields, const char* name, double& length, const LengthUnit& unit,
                  const char* meaning, const std::string& per) {
  double shown = length / unit.metres;
  if (!fields.number(name, shown, "%.4g ", meaning, unit.name + per)) return false;
  length = shown * unit.metres;
  return true;
}

}  // namespace kerf
