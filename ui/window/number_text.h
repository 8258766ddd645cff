#pragma once

#include <string>
#include <string_view>

#include "core/base/number_format.h"
#include "core/base/result.h"

namespace kerf {

// The printf format of a number in a widget, with at most one conversion: "%.1f MB". Checked at compile
// time, like a format attribute, which widgets that receive a pointer to their number cannot have.
// `conversions` are the letters that suit the type of the number.
class NumberFormat {
 public:
  const char* c_str() const { return text_; }
  // The text after the number: "MB" of "%.1f MB", without the space.
  std::string unit() const;

 protected:
  consteval NumberFormat(const char* text, std::string_view conversions) : text_(text) {
    if (!is_format(text, conversions)) throw "This is not a format of one number.";
  }

 private:
  static consteval bool is_format(std::string_view text, std::string_view conversions) {
    size_t found = 0;
    for (size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '%') continue;
      ++i;
      if (i < text.size() && text[i] == '%') continue;
      while (i < text.size() && std::string_view("+-#.0123456789").find(text[i]) != std::string_view::npos)
        ++i;
      if (i == text.size() || conversions.find(text[i]) == std::string_view::npos) return false;
      ++found;
    }
    return found <= 1;
  }

  const char* text_;
};

struct RealFormat : NumberFormat {
  consteval RealFormat(const char* text) : NumberFormat(text, "aefgAEFG") {}
};

struct WholeFormat : NumberFormat {
  consteval WholeFormat(const char* text) : NumberFormat(text, "d") {}
};

// Formats like printf, with compile-time checks. Truncates beyond 255 bytes.
[[gnu::format(printf, 1, 2)]] std::string text_of(const char* format, ...);

// Formats one number. Shows a number as 0 if it is noise compared with `scale`, the magnitude of the
// quantity, e.g. the length of the vector or the extent of the world; 0 never has a sign.
std::string number_text(double value, const RealFormat& format, double scale = 0);
// Returns true if rounding alone explains a number that should be 0: it is less than 1e-12 of the scale.
bool is_noise(double value, double scale);

// Formats an area in a unit that suits its size: "2.75 cm²"; "none" for 0.
std::string area_text(double square_metres);

enum class Quantity {
  kPlain,   // no unit except that of the field
  kLength,  // mm, cm, m, in, ft, and others from nm to km
  kAngle,   // °, deg, rad
  kPower,   // W, kW
};

struct NumberUnit {
  Quantity quantity = Quantity::kPlain;
  double size = 1;        // of one unit in metres, radians or watts, > 0
  std::string name = {};  // as the field shows it, e.g. "mm", "K"; accepted for every quantity
  std::string per = {};   // follows the units of the quantity, e.g. "/s" of a speed; optional
};

// Returns the unit of a field for lengths. Precondition: `name` is a length unit of evaluate_number().
NumberUnit length_unit(std::string name, std::string per = "");
inline const NumberUnit kDegrees{Quantity::kAngle, 1.7453292519943295e-2};  // without a name
inline const NumberUnit kWatts{Quantity::kPower};

// Evaluates the text of a number field in the unit of the field: numbers with or without digits in groups
// of three ("4 000"), + - * / and brackets, then optionally one unit, which applies to the whole expression
// ("1/4 in"). Units are case-insensitive. Operations use double, from left to right. Fails with the reason,
// a clause such as "\"abc\" is not a number", for any other text, or if the value or an intermediate one is
// not finite. O(size of the text); brackets nest at most kMaxBrackets deep.
inline constexpr int kMaxBrackets = 50;
Result<double> evaluate_number(std::string_view text, const NumberUnit& unit = {});

}  // namespace kerf
