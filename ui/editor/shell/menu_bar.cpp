#include "ui/editor/shell/menu_bar.h"

#include <imgui.h>

#include <string_view>

#include "core/base/assert.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

void draw_actions(std::span<const UserAction> actions);

void draw_action(const UserAction& action) {
  if (action.items) {
    if (!ImGui::BeginMenu(action.name.c_str())) return;
    draw_actions(action.items());
    ImGui::EndMenu();
    return;
  }
  KERF_ASSERT(action.run);
  const bool checked = action.checked && action.checked();
  const char* why_not = action.objection();
  if (ImGui::MenuItem(action.name.c_str(), action.shortcut.c_str(), checked, why_not == nullptr))
    action.run();
  if (why_not != nullptr) return tooltip(why_not);
  if (action.tip.empty()) return;
  const bool has_picture = action.tip_picture && ImGui::IsItemHovered();
  tooltip(action.tip.c_str(), has_picture ? action.tip_picture() : std::nullopt);
}

void draw_actions(std::span<const UserAction> actions) {
  for (size_t i = 0; i < actions.size(); ++i) {
    if (!actions[i].in_menu) continue;
    ImGui::PushID(static_cast<int>(i));
    draw_action(actions[i]);
    ImGui::PopID();
    if (actions[i].ends_group) ImGui::Separator();
  }
}

bool has_menu(std::span<const UserAction> actions) {
  return std::any_of(actions.begin(), actions.end(), [](const UserAction& a) { return a.in_menu; });
}

}  // namespace

void draw_menu_bar(std::span<const UserAction> actions) {
  if (!ImGui::BeginMainMenuBar()) return;
  for (size_t first = 0; first < actions.size();) {
    size_t end = first;
    while (end < actions.size() && std::string_view(actions[end].menu) == actions[first].menu) ++end;
    const std::span<const UserAction> menu = actions.subspan(first, end - first);
    if (has_menu(menu) && ImGui::BeginMenu(menu.front().menu)) {
      draw_actions(menu);
      ImGui::EndMenu();
    }
    first = end;
  }
  ImGui::EndMainMenuBar();
}

}  // namespace kerf
