#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// The physical quantity of a number in a text field.
enum class Quantity {
  kPlain,   // no unit but that of the field
  kLength,  // mm, cm, m, in, ft, and others from nm to km
  kAngle,   // °, deg, rad
  kPower,   // W, kW
};

// The unit of the number in a text field.
struct NumberUnit {
  Quantity quantity = Quantity::kPlain;
  double size = 1;        // of one unit in metres, radians or watts, > 0
  std::string name = {};  // as the field shows it, e.g. "mm", "K"; it is read for every quantity
  std::string per = {};   // follows the units of the quantity, e.g. "/s" of a speed; may be left out
};

// The unit of a field that shows lengths in a unit that evaluate_number() reads. Precondition: it is one.
NumberUnit length_unit(std::string name, std::string per = "");
inline const NumberUnit kDegrees{Quantity::kAngle, 1.7453292519943295e-2};  // without a name
inline const NumberUnit kWatts{Quantity::kPower};

// Evaluates the text of a number field in the unit of the field: numbers with or without digits in groups of
// three ("4 000"), + - * / and brackets, then optionally one unit, which holds for the whole expression
// ("1/4 in"). The case of units does not matter. Operations are those of double, from left to right. Fails
// with the reason, a clause such as "\"abc\" is not a number", if the text is anything else, or if the value
// or an intermediate one is not finite. O(size of the text); brackets nest kMaxBrackets deep at most.
inline constexpr int kMaxBrackets = 50;
Result<double> evaluate_number(std::string_view text, const NumberUnit& unit = {});

}  // namespace kerf
