#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/number_format.h"
#include "core/base/result.h"
#include "ui/window/status_message.h"

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

// Sets the message line for refused or limited entries of fields and sliders; nullptr: none. It must
// outlive the drawn frames.
void report_entries_to(Message* message);
// Reports a number that its field accepts but that does not fit other numbers, by a sentence as of a field:
// "From stays 3 mm: it must be less than To".
void report_refused_entry(std::string sentence);

// The format and limits of a number in a text field.
struct NumberEntry {
  const char* name;  // in messages
  RealFormat format;
  NumberUnit unit = {};  // its name follows the number, after the text of the format
  NumberRange range = kFinite;
  double scale = 0;  // of the quantity, for number_text()

  std::string shown(double value) const;
  // Returns the value of a text, limited to the range; nullopt if it is no number. Reports either case.
  // `present` is the value that stays if nullopt is returned.
  std::optional<double> entered(std::string_view text, double present) const;
};

// A text field being edited; there is one at a time.
class EditedText {
 public:
  // Draws the field, which shows `fitted`, or `shown` while it is active. Returns the entered text if it
  // differs from the one shown.
  std::optional<std::string> draw(const char* id, const std::string& shown, const std::string& fitted);
  // Begins the edit of the field with this ID of ImGui, which was activated elsewhere and has this text.
  void begin(uint32_t id, std::string shown);
  // Returns true if this field was edited in the last frame. If another item has become active since, call
  // draw() once more, which reports the entry.
  bool was_active(uint32_t id) const;
  // Returns true if a field was edited in the last frame and has not reported its entry since.
  bool is_active() const;

 private:
  struct Edit {
    uint32_t id = 0;  // of ImGui
    std::string text;
  };
  std::array<char, 128> typed_{};
  int typed_at_ = -1;  // frame of ImGui in which the field was active
  // Fields with their texts before the edit. A field that becomes active before the last one is drawn begins
  // its edit before the other one ends.
  Edit begun_, before_;
};

// Text fields for numbers with units and arithmetic (see evaluate_number()). A value is entered when the
// field loses the focus or on Enter; Esc restores the text. Text that is no number is refused with a
// message, and the value stays.
class NumberFields {
 public:
  // A row of a panel (see property_rows.h) with three fields, as landmarks "NAME 0" to "NAME 2". Returns
  // true if a number was entered, and stores it in `values`. `scale`: the magnitude of the quantity, e.g.
  // the size of the world, if that exceeds the length of the vector.
  bool vector(const char* name, Vec3& values, const RealFormat& format, const char* meaning,
              const NumberUnit& unit = {}, double scale = 0);
  // A row with one field, as landmark "NAME". The name of the unit follows the number.
  bool number(const char* name, double& value, const RealFormat& format, const char* meaning,
              const NumberUnit& unit = {}, const NumberRange& range = kFinite);
  // A row with one field for an integer within a range, shown with grouped digits; grouping is optional in
  // the entry. Rounds the entry.
  bool count(const char* name, size_t& value, const char* meaning, size_t least, size_t most);
  // Returns true if a field is being edited, so that its entry is still to come.
  bool is_active() const { return text_.is_active(); }

 private:
  bool field(double& value, const NumberEntry& entry, const char* meaning);

  EditedText text_;
};

}  // namespace kerf
