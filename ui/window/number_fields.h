#pragma once

#include "core/base/vec3.h"

namespace kerf {

// Fields for numbers that are typed: a value counts once its field is left or Enter is pressed.
class NumberFields {
 public:
  // A row of a panel (see property.h) with three fields, as landmarks "NAME 0" to "NAME 2". Returns whether a
  // finite number was entered, which `values` then holds.
  bool vector(const char* name, Vec3& values, const char* format, const char* meaning);
  // The same with one field, as landmark "NAME".
  bool number(const char* name, double& value, const char* format, const char* meaning);

 private:
  bool field(double& value, const char* format, const char* meaning);

  double typed_ = 0;  // in the field that is being edited
};

}  // namespace kerf
