#include "ui/editor/panels/panels.h"

#include <imgui.h>

#include "ui/editor/frame/load_bar.h"
#include "ui/editor/frame/menu_bar.h"
#include "ui/editor/frame/picture_marks.h"
#include "ui/editor/frame/shortcut_sheet.h"
#include "ui/editor/frame/status_bar.h"
#include "ui/editor/panels/display_panel.h"
#include "ui/editor/panels/file_panel.h"
#include "ui/editor/panels/history_panel.h"
#include "ui/editor/panels/laser_panel.h"
#include "ui/editor/panels/light_panel.h"
#include "ui/editor/panels/pieces_panel.h"
#include "ui/editor/panels/resolution_panel.h"
#include "ui/editor/panels/statistics_panel.h"
#include "ui/editor/panels/tree_panel.h"
#include "ui/editor/panels/view_panel.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/splitter.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr std::array kPanels{
    Panel{"Laser", true, draw_laser_panel},   Panel{"Resolution", true, draw_resolution_panel},
    Panel{"Pieces", true, draw_pieces_panel}, Panel{"History", true, draw_history_panel},
    Panel{"Light", false, draw_light_panel},  Panel{"Tree", false, draw_tree_panel},
    Panel{"View", false, draw_view_panel},    Panel{"Statistics", false, draw_statistics_panel},
    Panel{"File", false, draw_file_panel},    Panel{"Display", false, draw_display_panel},
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
      mark_last_item(panel.title);
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

void draw_splitters(EditorState& state) {
  const Layout& l = state.layout;
  Settings& settings = state.settings;
  if (l.side.size.x > 0) {
    const auto to = splitter("##sides", l.side.at, l.side.size.y,
                             "Drag to make the panels wider or narrower, double click for their first width; "
                             "F4 hides them.");
    if (to.reset) settings.side_ems = Settings().side_ems;
    if (to.dragged) {
      const double wanted = (l.status.size.x - *to.dragged) / ImGui::GetFontSize();
      settings.side_ems = std::clamp(wanted, Settings::kLeastSide, Settings::kMostSide);
    }
  }
  if (!l.split()) return;
  const auto to = splitter("##halves", l.second.at, l.second.size.y,
                           "Drag to make a half wider or narrower, double click for equal halves.");
  if (to.reset) settings.split_share = Settings().split_share;
  if (to.dragged)
    settings.split_share = std::clamp((*to.dragged - l.viewport.at.x) / l.viewport.size.x, 0.0, 1.0);
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
  draw_splitters(state);
  draw_status_bar(state);
  draw_load_bar(state);
  draw_shortcut_sheet(state);
  draw_file_browser(state);
  draw_question(state);
}

}  // namespace kerf
