#include "ui/editor/menu_bar.h"

#include <imgui.h>

#include <string_view>

#include "ui/editor/actions.h"

namespace kerf {

void draw_menu_bar(EditorState& state) {
  if (!ImGui::BeginMainMenuBar()) return;
  const std::span<const Action> all = actions();
  for (size_t first = 0; first < all.size();) {
    size_t end = first;
    while (end < all.size() && std::string_view(all[end].menu) == all[first].menu) ++end;
    if (ImGui::BeginMenu(all[first].menu)) {
      for (const Action& action : all.subspan(first, end - first)) {
        const bool checked = action.checked != nullptr && action.checked(state);
        if (ImGui::MenuItem(action.name, action.shortcut, checked)) action.run(state);
      }
      ImGui::EndMenu();
    }
    first = end;
  }
  ImGui::EndMainMenuBar();
}

}  // namespace kerf
