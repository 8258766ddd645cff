#include "ui/editor/shell/panel_column.h"

#include <imgui.h>

#include <string_view>

#include "ui/window/landmarks.h"
#include "ui/window/splitter.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

// Whether the header was drawn folded in the last frame.
bool was_folded(const char* title) { return ImGui::GetStateStorage()->GetInt(ImGui::GetID(title), 1) == 0; }

// The panels that have the title of the first one.
std::span<const Panel> with_one_title(std::span<const Panel> panels) {
  size_t count = 1;
  while (count < panels.size() && std::string_view(panels[count].title) == panels.front().title) ++count;
  return panels.first(count);
}

// One that is unfolded from elsewhere comes into view.
void draw_panel(std::span<const Panel> parts, bool& unfolded) {
  const char* title = parts.front().title;
  ImGui::PushID(title);
  const bool comes = unfolded && was_folded(title);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  ImGui::SetNextItemOpen(unfolded, ImGuiCond_Always);
  unfolded = ImGui::CollapsingHeader(title);
  mark_last_item(title);
  if (comes) ImGui::SetScrollHereY(0);
  ImGui::PopStyleVar();
  if (unfolded) {
    ImGui::Spacing();
    for (const Panel& part : parts) part.draw();
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
    for (auto rest = panels; !rest.empty();) {
      const std::span<const Panel> parts = with_one_title(rest);
      draw_panel(parts, settings.panels[parts.front().title]);
      rest = rest.subspan(parts.size());
    }
  }
  ImGui::End();
}

std::vector<UserAction> panel_actions(std::span<const Panel> panels, Settings& settings) {
  std::vector<UserAction> actions;
  for (auto rest = panels; !rest.empty(); rest = rest.subspan(with_one_title(rest).size())) {
    const std::string title = rest.front().title;
    actions.push_back({.name = title, .tip = "Unfolds or folds this panel."});
    actions.back().run = [&settings, title] {
      const bool shown = settings.shows(title);
      settings.panels[title] = !shown;
      settings.side_shown = settings.side_shown || !shown;
    };
    actions.back().checked = [&settings, title] { return settings.shows(title); };
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
