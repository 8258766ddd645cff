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

// Where fields and sliders report what was refused or limited; nullptr: nowhere. It must outlive the frames
// that are drawn.
void report_entries_to(Message* message);

// What a text field for a number shows and takes.
struct NumberEntry {
  const char* name;  // in messages
  RealFormat format;
  NumberUnit unit = {};  // its name follows the number, after the text of the format
  NumberRange range = kFinite;
  double scale = 0;  // of the quantity, for number_text()

  std::string shown(double value) const;
  // The value that a text gives, limited to the range. Reports a text that is no number, and a limit that was
  // applied. `present` is the value that stays where nothing is returned.
  std::optional<double> entered(std::string_view text, double present) const;
};

// A text field while it is edited, of which there is one at a time.
class EditedText {
 public:
  // Draws the field, which shows `fitted` until it is active and `shown` then. Returns the text that was
  // entered if it is not the one that the field showed.
  std::optional<std::string> draw(const char* id, const std::string& shown, const std::string& fitted);
  // The field that is drawn next was activated elsewhere, and shows this text.
  void begin(std::string shown) { begun_ = std::move(shown); }

 private:
  std::array<char, 128> typed_{};
  std::string begun_;  // what the field showed before
};

// Text fields for numbers, which take units and arithmetic (see evaluate_number()). A value counts once its
// field is left or Enter is pressed; Esc restores the text. What is no number is refused with a message, and
// the value stays.
class NumberFields {
 public:
  // A row of a panel (see property.h) with three fields, as landmarks "NAME 0" to "NAME 2". Returns whether a
  // number was entered, which `values` then holds. `scale`: the size of what the vector measures, e.g. of the
  // world, if that is more than its own length.
  bool vector(const char* name, Vec3& values, const RealFormat& format, const char* meaning,
              const NumberUnit& unit = {}, double scale = 0);
  // A row with one field, as landmark "NAME". The name of the unit follows the number.
  bool number(const char* name, double& value, const RealFormat& format, const char* meaning,
              const NumberUnit& unit = {}, const NumberRange& range = kFinite);
  // A row with one field for a whole number within a range, which is shown with grouped digits and may be
  // typed with or without them. What is typed is rounded.
  bool count(const char* name, size_t& value, const char* meaning, size_t least, size_t most);

 private:
  bool field(double& value, const NumberEntry& entry, const char* meaning);

  EditedText text_;
};

}  // namespace kerf
