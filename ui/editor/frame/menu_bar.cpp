#include "ui/editor/frame/menu_bar.h"

#include <imgui.h>

#include <string_view>

#include "ui/editor/actions.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

void draw_action(EditorState& state, const Action& action) {
  if (action.submenu != nullptr) {
    if (!ImGui::BeginMenu(action.name)) return;
    action.submenu(state);
    ImGui::EndMenu();
    return;
  }
  const bool checked = action.checked != nullptr && action.checked(state);
  const char* why_not = action.why_not != nullptr ? action.why_not(state) : nullptr;
  if (ImGui::MenuItem(action.name, action.shortcut, checked, why_not == nullptr)) action.run(state);
  if (why_not != nullptr || action.tip[0] != '\0') tooltip(why_not != nullptr ? why_not : action.tip);
}

}  // namespace

void draw_menu_bar(EditorState& state) {
  if (!ImGui::BeginMainMenuBar()) return;
  const std::span<const Action> all = actions();
  for (size_t first = 0; first < all.size();) {
    size_t end = first;
    while (end < all.size() && std::string_view(all[end].menu) == all[first].menu) ++end;
    if (ImGui::BeginMenu(all[first].menu)) {
      for (const Action& action : all.subspan(first, end - first)) {
        draw_action(state, action);
        if (action.ends_group) ImGui::Separator();
      }
      ImGui::EndMenu();
    }
    first = end;
  }
  ImGui::EndMainMenuBar();
}

}  // namespace kerf
