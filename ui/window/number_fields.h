#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/vec3.h"
#include "ui/window/number_format.h"

namespace kerf {

// The whole number from 1 on that a text gives, with or without grouped digits, or nothing.
std::optional<size_t> count_in(std::string text);

// Fields for numbers that are typed: a value counts once its field is left or Enter is pressed.
class NumberFields {
 public:
  // A row of a panel (see property.h) with three fields, as landmarks "NAME 0" to "NAME 2". Returns whether a
  // finite number was entered, which `values` then holds.
  bool vector(const char* name, Vec3& values, const RealFormat& format, const char* meaning);
  // A row with one field, as landmark "NAME"; `unit` follows the number.
  bool number(const char* name, double& value, const RealFormat& format, const char* meaning,
              std::string_view unit = "");

  // A row with one field for a whole number from 1 on, which is shown with grouped digits and may be typed
  // with or without them.
  bool count(const char* name, size_t& value, const char* meaning);

 private:
  bool field(double& value, const std::string& format, const char* meaning);

  double typed_ = 0;                   // in the field that is being edited
  std::array<char, 32> typed_text_{};  // in one for a count
};

}  // namespace kerf
