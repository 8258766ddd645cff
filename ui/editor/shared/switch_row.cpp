#include "ui/editor/shared/switch_row.h"

#include <imgui.h>

#include "ui/editor/shared/shortcut_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"

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

}  // namespace kerf
