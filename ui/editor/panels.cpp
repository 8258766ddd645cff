#include "ui/editor/panels.h"

#include <imgui.h>

#include "ui/editor/laser_panel.h"
#include "ui/editor/menu_bar.h"
#include "ui/editor/picture_marks.h"
#include "ui/editor/shortcut_sheet.h"
#include "ui/editor/status_bar.h"
#include "ui/editor/view_panel.h"

namespace kerf {

namespace {

constexpr std::array kPanels{
    Panel{"Laser", true, draw_laser_panel},
    Panel{"View", true, draw_view_panel},
};

void draw_side(EditorState& state) {
  const Area& area = state.layout.side;
  if (area.size.x <= 0) return;
  ImGui::SetNextWindowPos({static_cast<float>(area.at.x), static_cast<float>(area.at.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
  constexpr ImGuiWindowFlags kFixed =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("##side", nullptr, kFixed)) {
    for (const Panel& panel : panels()) {
      ImGui::PushID(panel.title);
      ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
      const bool open = ImGui::CollapsingHeader(
          panel.title, panel.open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
      ImGui::PopStyleVar();
      if (open) {
        ImGui::Spacing();
        panel.draw(state);
        ImGui::Spacing();
      }
      ImGui::PopID();
    }
  }
  ImGui::End();
}

}  // namespace

std::span<const Panel> panels() { return kPanels; }

void draw_panels(EditorState& state) {
  draw_menu_bar(state);
  draw_picture_marks(state);
  draw_side(state);
  draw_status_bar(state);
  draw_shortcut_sheet(state);
}

}  // namespace kerf
