#include "ui/editor/shared/panel_rows.h"

#include <imgui.h>
#include <algorithm>
#include <cctype>
#include <cstring>
#include <vector>

#include "core/base/assert.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

std::string shortcut_of(const ViewState& view, const std::string& action) {
  const auto found = view.shortcuts.find(action);
  return found != view.shortcuts.end() ? found->second : "";
}

std::string with_shortcut(const ViewState& view, std::string sentence, const std::string& action) {
  const std::string key = shortcut_of(view, action);
  if (key.empty()) return sentence;
  const bool stop = sentence.ends_with('.');
  if (stop) sentence.pop_back();
  return sentence + " (" + key + ")" + (stop ? "." : "");
}

namespace {

// Returns the label of a state: "by angle" becomes "By Angle".
std::string title_case(std::string words) {
  for (size_t i = 0; i < words.size(); ++i) {
    if (i == 0 || words[i - 1] == ' ')
      words[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[i])));
  }
  return words;
}

// Draws the states as radio buttons in a row. Returns the one that was clicked, or the present one.
size_t select_state(const ViewSwitch& s, size_t state) {
  for (size_t i = 0; i < s.states.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    if (ImGui::RadioButton(title_case(s.states[i]).c_str(), state == i)) state = i;
    mark_last_item(s.report, static_cast<int>(i));
    tooltip(s.tip);
  }
  return state;
}

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

// Draws the open list of a row: a click selects, or Enter at the cursor that Up and Down move. Returns true
// if one was selected.
bool select_in_list(std::span<const char* const> names, int& choice, const char* landmark) {
  int& cursor = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("cursor"), choice);
  if (ImGui::IsWindowAppearing()) cursor = choice;
  const int step = (is_pressed(ImGuiKey_DownArrow) ? 1 : 0) - (is_pressed(ImGuiKey_UpArrow) ? 1 : 0);
  cursor = std::clamp(cursor + step, 0, static_cast<int>(names.size()) - 1);
  int selected = -1;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    if (ImGui::Selectable(names[static_cast<size_t>(i)], i == cursor)) selected = i;
    if (landmark != nullptr) mark_last_item(landmark, i);
  }
  if (is_pressed(ImGuiKey_Enter) || is_pressed(ImGuiKey_KeyPadEnter)) {
    selected = cursor;
    ImGui::CloseCurrentPopup();
  }
  if (selected < 0) return false;
  choice = selected;
  return true;
}

float height_of_row() { return ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y; }

}  // namespace

bool draw_switch(ViewState& view, SwitchId id, const char* label) {
  const ViewSwitch& s = view_switch(id);
  std::string text = label != nullptr ? label : s.label;
  text = with_shortcut(view, text, action_id(s));
  const size_t before = s.get(view.look);
  size_t state = before;
  if (s.is_two_state()) {
    bool on = before != 0;
    ImGui::Checkbox(text.c_str(), &on);
    tooltip(s.tip);
    state = on ? 1 : 0;
  } else {
    ImGui::PushID(s.report);
    if (label == nullptr || *label != '\0') {  // otherwise the row has a label of its own
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(text.c_str());
      ImGui::SameLine();
    }
    state = select_state(s, state);
    ImGui::PopID();
  }
  if (state == before) return false;
  s.set(view.look, state);
  view.picture_old = true;
  return true;
}

bool length_field(NumberFields& fields, const char* name, double& length, const LengthUnit& unit,
                  const char* meaning, const std::string& per, const NumberRange& range) {
  double shown = length / unit.metres;
  const NumberRange in_unit{range.least / unit.metres, range.most / unit.metres, "", range.positive};
  if (!fields.number(name, shown, "%.4g ", meaning, length_unit(unit.name, per), in_unit)) return false;
  length = shown * unit.metres;
  return true;
}

bool choice_row(const char* label, const char* id, int& choice, const char* names, const char* landmark,
                const char* meaning) {
  std::vector<const char*> all;
  for (const char* name = names; *name != '\0'; name += std::strlen(name) + 1) all.push_back(name);
  return marked_choice_row(label, id, choice, all, landmark, meaning);
}

bool marked_choice_row(const char* label, const char* id, int& choice, std::span<const char* const> names,
                       const char* landmark, const char* meaning) {
  KERF_ASSERT(static_cast<size_t>(choice) < names.size());
  property(label);
  if (begin_fitted_combo(id, names[static_cast<size_t>(choice)])) {
    const bool selected = select_in_list(names, choice, landmark);
    ImGui::EndCombo();
    return selected;
  }
  if (landmark != nullptr) mark_last_item(landmark);
  if (meaning != nullptr) tooltip(meaning);
  return false;
}

bool reset_item(double& value, double standard) {
  if (!ImGui::BeginPopupContextItem()) return false;
  const bool reset = ImGui::MenuItem("Reset to default");
  if (reset) value = standard;
  ImGui::EndPopup();
  return reset;
}

void secondary_text(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

float height_of_rows(size_t rows) {
  return static_cast<float>(rows) * height_of_row() + 0.2f * ImGui::GetFontSize();
}

void draw_rows_in_sight(size_t rows, const std::function<void(size_t)>& draw) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw(static_cast<size_t>(i));
  }
}

void scroll_to_row(size_t row, float height) {
  ImGui::SetScrollY(height_of_row() * static_cast<float>(row) - 0.5f * height);
}

}  // namespace kerf
