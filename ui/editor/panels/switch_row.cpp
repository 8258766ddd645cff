#include "ui/editor/panels/switch_row.h"

#include <imgui.h>

#include "ui/window/property.h"

namespace kerf {

bool draw_switch(ViewState& view, SwitchId id, const char* label) {
  const ViewSwitch& s = view_switch(id);
  std::string text = label != nullptr ? label : s.label;
  if (s.key != 0) text += std::string(" (") + s.key + ")";
  bool on = s.get(view.look);
  const bool flipped = ImGui::Checkbox(text.c_str(), &on);
  tooltip(s.tip);
  if (!flipped) return false;
  s.set(view.look, on);
  view.picture_old = true;
  return true;
}

}  // namespace kerf
