#include "ui/editor/shared/panel_rows.h"

#include <imgui.h>

#include "ui/editor/shared/shortcut_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

// One of several states as radio buttons in a row. Returns the state that was clicked, or the present one.
size_t choose_state(const ViewSwitch& s, size_t state) {
  for (size_t i = 0; i < s.states.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    if (ImGui::RadioButton(s.states[i], state == i)) state = i;
    mark_last_item(s.report, static_cast<int>(i));
    tooltip(s.tip);
  }
  return state;
}

float height_of_row() { return ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y; }

}  // namespace

bool draw_switch(ViewState& view, SwitchId id, const char* label) {
  const ViewSwitch& s = view_switch(id);
  std::string text = label != nullptr ? label : s.label;
  text = with_shortcut(view, text, action_name(s));
  const size_t before = s.get(view.look);
  size_t state = before;
  if (s.is_two_state()) {
    bool on = before != 0;
    ImGui::Checkbox(text.c_str(), &on);
    tooltip(s.tip);
    state = on ? 1 : 0;
  } else {
    ImGui::PushID(s.report);
    state = choose_state(s, state);
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopID();
  }
  if (state == before) return false;
  s.set(view.look, state);
  view.picture_old = true;
  return true;
}

bool length_field(NumberFields& fields, const char* name, double& length, const LengthUnit& unit,
                  const char* meaning, const std::string& per) {
  double shown = length / unit.metres;
  if (!fields.number(name, shown, "%.4g ", meaning, unit.name + per)) return false;
  length = shown * unit.metres;
  return true;
}

bool choice_row(const char* label, const char* id, int& choice, const char* names, const char* landmark,
                const char* meaning) {
  property(label);
  const bool chosen = ImGui::Combo(id, &choice, names);
  if (landmark != nullptr) mark_last_item(landmark);
  if (meaning != nullptr) tooltip(meaning);
  return chosen;
}

bool marked_choice_row(const char* label, const char* id, int& choice, std::span<const char* const> names,
                       const char* landmark, const char* meaning) {
  property(label);
  const auto now = static_cast<size_t>(choice);
  bool chosen = false;
  if (ImGui::BeginCombo(id, names[now])) {
    for (size_t i = 0; i < names.size(); ++i) {
      if (ImGui::Selectable(names[i], i == now)) {
        choice = static_cast<int>(i);
        chosen = true;
      }
      mark_last_item(landmark, static_cast<int>(i));
    }
    ImGui::EndCombo();
  } else {
    mark_last_item(landmark);
    tooltip(meaning);
  }
  return chosen;
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
