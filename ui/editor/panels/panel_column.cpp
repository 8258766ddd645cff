#include "ui/editor/panels/panel_column.h"

#include <imgui.h>

#include "ui/window/landmarks.h"
#include "ui/window/splitter.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

// Whether the header was drawn folded in the last frame.
bool was_folded(const char* title) { return ImGui::GetStateStorage()->GetInt(ImGui::GetID(title), 1) == 0; }

// One that is unfolded from elsewhere comes into view.
void draw_panel(const Panel& panel, bool& unfolded) {
  ImGui::PushID(panel.title);
  const bool comes = unfolded && was_folded(panel.title);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  ImGui::SetNextItemOpen(unfolded, ImGuiCond_Always);
  unfolded = ImGui::CollapsingHeader(panel.title);
  mark_last_item(panel.title);
  if (comes) ImGui::SetScrollHereY(0);
  ImGui::PopStyleVar();
  if (unfolded) {
    ImGui::Spacing();
    panel.draw();
    ImGui::Spacing();
  }
  ImGui::PopID();
}

}  // namespace

void draw_panel_column(const Area& area, std::span<const Panel> panels, Settings& settings) {
  if (area.size.x <= 0) return;
  ImGui::SetNextWindowPos({static_cast<float>(area.at.x), static_cast<float>(area.at.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
  if (ImGui::Begin("##side", nullptr, kFixed)) {
    for (const Panel& panel : panels) draw_panel(panel, settings.panels.at(panel.id));
  }
  ImGui::End();
}

std::vector<UserAction> panel_actions(std::span<const Panel> panels, Settings& settings) {
  std::vector<UserAction> actions;
  for (const Panel& panel : panels) {
    actions.push_back({.menu = "View", .name = panel.title, .tip = "Unfolds or folds this panel."});
    actions.back().run = [&settings, id = panel.id] {
      const bool shown = settings.shows(id);
      settings.panels.at(id) = !shown;
      settings.side_shown = settings.side_shown || !shown;
    };
    actions.back().checked = [&settings, id = panel.id] { return settings.shows(id); };
  }
  return actions;
}

void draw_splitters(const Layout& l, Settings& settings) {
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

}  // namespace kerf
