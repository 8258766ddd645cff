#include "ui/editor/panels.h"

#include <imgui.h>

#include "ui/editor/display_panel.h"
#include "ui/editor/file_panel.h"
#include "ui/editor/laser_panel.h"
#include "ui/editor/menu_bar.h"
#include "ui/editor/picture_marks.h"
#include "ui/editor/pieces_panel.h"
#include "ui/editor/property.h"
#include "ui/editor/resolution_panel.h"
#include "ui/editor/shortcut_sheet.h"
#include "ui/editor/status_bar.h"
#include "ui/editor/theme.h"
#include "ui/editor/tree_panel.h"
#include "ui/editor/view_panel.h"

namespace kerf {

namespace {

constexpr std::array kPanels{
    Panel{"Laser", true, draw_laser_panel},      Panel{"Resolution", true, draw_resolution_panel},
    Panel{"Pieces", true, draw_pieces_panel},    Panel{"Tree", false, draw_tree_panel},
    Panel{"View", false, draw_view_panel},       Panel{"File", false, draw_file_panel},
    Panel{"Display", false, draw_display_panel},
};

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

bool& unfolded(EditorState& state, const Panel& panel) {
  return state.settings.panels.try_emplace(panel.title, panel.open_at_first).first->second;
}

void draw_side(EditorState& state) {
  const Area& area = state.layout.side;
  if (area.size.x <= 0) return;
  ImGui::SetNextWindowPos({static_cast<float>(area.at.x), static_cast<float>(area.at.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
  if (ImGui::Begin("##side", nullptr, kFixed)) {
    for (const Panel& panel : panels()) {
      bool& open = unfolded(state, panel);
      ImGui::PushID(panel.title);
      ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
      ImGui::SetNextItemOpen(open, ImGuiCond_Always);
      open = ImGui::CollapsingHeader(panel.title);
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

// The strip between the picture and the panels, which can be dragged.
void draw_splitter(EditorState& state) {
  const Area& area = state.layout.side;
  if (area.size.x <= 0) return;
  const float em = ImGui::GetFontSize(), half = 0.25f * em;
  const auto x = static_cast<float>(area.at.x), y = static_cast<float>(area.at.y);
  const auto height = static_cast<float>(area.size.y);
  ImGui::SetNextWindowPos({x - half, y});
  ImGui::SetNextWindowSize({2 * half, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  if (ImGui::Begin("##splitter", nullptr,
                   kFixed | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar)) {
    ImGui::InvisibleButton("splitter", {2 * half, height});
    const bool held = ImGui::IsItemActive(), over = ImGui::IsItemHovered();
    if (held || over) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
      ImGui::GetForegroundDrawList()->AddLine(
          {x, y}, {x, y + height},
          ImGui::GetColorU32(held ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered), 2);
    }
    if (!held) tooltip("Drag to make the panels wider or narrower; F4 hides them.");
    if (held) {
      const double wanted = (state.layout.status.size.x - ImGui::GetIO().MousePos.x) / em;
      state.settings.side_ems = std::clamp(wanted, Settings::kLeastSide, Settings::kMostSide);
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

std::span<const Panel> panels() { return kPanels; }

void draw_panels_menu(EditorState& state) {
  for (const Panel& panel : panels()) ImGui::MenuItem(panel.title, nullptr, &unfolded(state, panel));
}

void draw_panels(EditorState& state) {
  draw_menu_bar(state);
  draw_picture_marks(state);
  draw_side(state);
  draw_splitter(state);
  draw_status_bar(state);
  draw_shortcut_sheet(state);
  draw_file_browser(state);
}

}  // namespace kerf
