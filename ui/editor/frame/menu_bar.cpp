#include "ui/editor/frame/menu_bar.h"

#include <imgui.h>

#include <string_view>

#include "ui/window/property.h"

namespace kerf {

namespace {

void draw_action(const UserAction& action) {
  if (action.submenu) {
    if (!ImGui::BeginMenu(action.name.c_str())) return;
    action.submenu();
    ImGui::EndMenu();
    return;
  }
  const bool checked = action.checked && action.checked();
  const char* why_not = action.objection();
  if (ImGui::MenuItem(action.name.c_str(), action.shortcut.c_str(), checked, why_not == nullptr))
    action.run();
  if (why_not != nullptr || action.tip[0] != '\0') tooltip(why_not != nullptr ? why_not : action.tip);
}

}  // namespace

void draw_menu_bar(std::span<const UserAction> actions) {
  if (!ImGui::BeginMainMenuBar()) return;
  for (size_t first = 0; first < actions.size();) {
    size_t end = first;
    while (end < actions.size() && std::string_view(actions[end].menu) == actions[first].menu) ++end;
    if (ImGui::BeginMenu(actions[first].menu)) {
      for (const UserAction& action : actions.subspan(first, end - first)) {
        draw_action(action);
        if (action.ends_group) ImGui::Separator();
      }
      ImGui::EndMenu();
    }
    first = end;
  }
  ImGui::EndMainMenuBar();
}

}  // namespace kerf
