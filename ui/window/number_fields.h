#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/base/number_format.h"
#include "ui/window/number_text.h"
#include "ui/window/status_message.h"

namespace kerf {

// Sets the message line for refused or limited entries of fields and sliders; nullptr: none. It must
// outlive the drawn frames.
void report_entries_to(Message* message);

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
  // Begins the edit with this text in the next field drawn, which was activated elsewhere.
  void begin(std::string shown) { begun_ = std::move(shown); }

 private:
  std::array<char, 128> typed_{};
  std::string begun_;  // text before the edit
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

 private:
  bool field(double& value, const NumberEntry& entry, const char* meaning);

  EditedText text_;
};

}  // namespace kerf
