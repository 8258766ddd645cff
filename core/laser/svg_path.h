#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/laser/drawing.h"

namespace kerf {

// An error in the value of an attribute: the position of its byte in the value, and what is wrong there.
struct SvgFault {
  size_t at = 0;
  std::string what;
};

// Reads numbers and words of the value of an attribute: of paths, lists of points, and transforms.
class SvgValue {
 public:
  explicit SvgValue(std::string_view text) : text_(text) {}

  size_t position() const { return at_; }
  // Skips blanks and, if there is one, a comma. Returns true if the value ends there.
  bool at_end();
  // Reads a finite number after blanks and a comma, at most 1e30 in magnitude; nullopt if there is none.
  std::optional<double> number();
  // Reads a flag of an arc, one digit 0 or 1; a blank after it is optional.
  std::optional<bool> flag();
  // Reads letters after blanks; empty if there are none.
  std::string_view word();
  // Reads one letter; 0 if there is none.
  char letter();
  // Reads this character after blanks; false if another one is there.
  bool consume(char c);
  // Reads the rest of the value without surrounding blanks.
  std::string_view rest();
  SvgFault fault(const std::string& what) const { return {at_, what}; }

 private:
  void skip_blanks();

  std::string_view text_;
  size_t at_ = 0;
};

// Adds the lines of path data (the attribute d), mapped to the drawing. Returns the first error. All commands
// of SVG 1.1: M, L, H, V, C, S, Q, T, A and Z, absolute and relative.
std::optional<SvgFault> add_svg_path(std::string_view data, const PlaneMap& map, DrawingBuilder& builder);

// Parses the attribute transform, a list of matrix, translate, scale, rotate, skewX and skewY.
std::optional<SvgFault> parse_svg_transform(std::string_view text, PlaneMap& map);

}  // namespace kerf
