#pragma once

#include <functional>
#include <span>
#include <string>

#include "ui/editor/shared/viewport.h"
#include "ui/render/view/view_options.h"
#include "ui/window/number_text.h"

namespace kerf {

// Returns the key bound to an action; empty if it has none.
std::string shortcut_of(const ViewState& view, const std::string& action);

// Inserts the key of an action, if any, in brackets before the full stop of a sentence: "Hides it (H)."
std::string with_shortcut(const ViewState& view, std::string sentence, const std::string& action);

// Draws a view switch as a check box, or as radio buttons if it has more than two states, with its key and
// tooltip. `label` replaces its own label. Returns true if its state changed.
bool draw_switch(ViewState& view, SwitchId id, const char* label = nullptr);

// Draws a row for a length in file units, shown and typed in a display unit (see label_unit), which is
// followed by `per`: "2.75 mm/s" with "/s". The range applies to `length`. Returns true if a number was
// entered.
bool length_field(NumberFields& fields, const char* name, double& length, const LengthUnit& unit,
                  const char* meaning, const std::string& per = "", const NumberRange& range = kFinite);

// The unit of fields for coordinates in file units, which do not show it.
inline NumberUnit file_unit(FileUnit unit) { return {Quantity::kLength, metres_per_unit(unit)}; }

// Draws a row that selects one of several values from a list, by a click or by Up, Down and Enter. `names`
// are those of the values 0, 1, ..., each terminated by a zero. `landmark` is its name in tests and
// `meaning` its tooltip; either may be null. Returns true if a value was selected.
bool choice_row(const char* label, const char* id, int& choice, const char* names, const char* landmark,
                const char* meaning);
template <typename Choice>
bool choice_row(const char* label, const char* id, Choice& choice, const char* names, const char* landmark,
                const char* meaning) {
  int number = static_cast<int>(choice);
  const bool selected = choice_row(label, id, number, names, landmark, meaning);
  choice = static_cast<Choice>(number);
  return selected;
}

// Like choice_row(), with an array of names. Each name in the open list has a landmark, too: that of the
// row, with its index.
bool marked_choice_row(const char* label, const char* id, int& choice, std::span<const char* const> names,
                       const char* landmark, const char* meaning);
template <typename Choice>
bool marked_choice_row(const char* label, const char* id, Choice& choice, std::span<const char* const> names,
                       const char* landmark, const char* meaning) {
  int number = static_cast<int>(choice);
  const bool selected = marked_choice_row(label, id, number, names, landmark, meaning);
  choice = static_cast<Choice>(number);
  return selected;
}

// Draws the context menu of the last item, which resets the value to its default. Returns true if it did.
bool reset_item(double& value, double standard);

void secondary_text(const std::string& text);

// Scrolling tables: the height that shows a number of rows, drawing of the visible rows by index, and
// scrolling that centres a row in that height.
float height_of_rows(size_t rows);
void draw_rows_in_sight(size_t rows, const std::function<void(size_t)>& draw);
void scroll_to_row(size_t row, float height);

}  // namespace kerf
