#pragma once

#include <functional>
#include <span>
#include <string>

#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/view_switches.h"
#include "ui/window/number_fields.h"

namespace kerf {

// The key of an action as it is bound at the moment; empty if it has none.
std::string shortcut_of(const ViewState& view, const std::string& action);

// A sentence with the key of an action in brackets before its full stop, if it has a key: "Hides it (H)."
std::string with_shortcut(const ViewState& view, std::string sentence, const std::string& action);

// Draws a switch of the view as a check box, or as radio buttons where it has more than two states, with its
// key and its tooltip. `label` replaces its own label in a row that has a name already. Returns whether its
// state was changed.
bool draw_switch(ViewState& view, SwitchId id, const char* label = nullptr);

// A row with a field for a length in the numbers of the file, shown and typed in a unit (see label_unit),
// with the name of this unit and what follows it: "2.75 mm/s" with "/s". The range is one of `length`.
// Returns whether a number was entered.
bool length_field(NumberFields& fields, const char* name, double& length, const LengthUnit& unit,
                  const char* meaning, const std::string& per = "", const NumberRange& range = kFinite);

// The unit of fields for coordinates in the numbers of the file, which do not show it.
inline NumberUnit file_unit(FileUnit unit) { return {Quantity::kLength, metres_per_unit(unit)}; }

// A row in which one of several values is chosen, in its open list by a click or by Up, Down and Enter.
// `names` are those of the values 0, 1, ..., each ended by a zero. `landmark` is its name in tests and
// `meaning` its tooltip; either may be null. Returns whether a value was chosen.
bool choice_row(const char* label, const char* id, int& choice, const char* names, const char* landmark,
                const char* meaning);
template <typename Choice>
bool choice_row(const char* label, const char* id, Choice& choice, const char* names, const char* landmark,
                const char* meaning) {
  int number = static_cast<int>(choice);
  const bool chosen = choice_row(label, id, number, names, landmark, meaning);
  choice = static_cast<Choice>(number);
  return chosen;
}

// A row like choice_row() of names in a list. Each name of the open list has a landmark, too: that of the
// row, with its number.
bool marked_choice_row(const char* label, const char* id, int& choice, std::span<const char* const> names,
                       const char* landmark, const char* meaning);
template <typename Choice>
bool marked_choice_row(const char* label, const char* id, Choice& choice, std::span<const char* const> names,
                       const char* landmark, const char* meaning) {
  int number = static_cast<int>(choice);
  const bool chosen = marked_choice_row(label, id, number, names, landmark, meaning);
  choice = static_cast<Choice>(number);
  return chosen;
}

// The menu of the last item at a right click, which sets the value to the standard one. Returns whether it
// did.
bool reset_item(double& value, double standard);

// A text of less weight, in as many lines as it takes.
void secondary_text(const std::string& text);

// Tables that scroll: the height of one in which so many rows are in sight, the drawing of those rows that
// are in sight by their numbers from 0, and scrolling so that a row is in the middle of that height.
float height_of_rows(size_t rows);
void draw_rows_in_sight(size_t rows, const std::function<void(size_t)>& draw);
void scroll_to_row(size_t row, float height);

}  // namespace kerf
