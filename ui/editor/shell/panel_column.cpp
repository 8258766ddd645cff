#include "ui/editor/shell/panel_column.h"

#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "ui/editor/shell/dock_menu.h"
#include "ui/editor/shell/tab_bar.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/landmarks.h"
#include "ui/window/splitter.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
constexpr float kLeastStripPanel = 22;  // width in sizes of the text; more panels scroll

// The panels that have the title of the first one.
std::span<const Panel> with_one_title(std::span<const Panel> panels) {
  size_t count = 1;
  while (count < panels.size() && std::string_view(panels[count].title) == panels.front().title) ++count;
  return panels.first(count);
}

// Calls `draw` with the parts of each panel in turn.
template <typename Draw>
void for_each_title(std::span<const Panel> panels, const Draw& draw) {
  while (!panels.empty()) {
    const std::span<const Panel> parts = with_one_title(panels);
    draw(parts);
    panels = panels.subspan(parts.size());
  }
}

void draw_parts(std::span<const Panel> parts) {
  ImGui::Spacing();
  for (const Panel& part : parts) part.draw();
  ImGui::Spacing();
}

// Whether the header was drawn folded in the last frame.
bool was_folded(const char* title) { return ImGui::GetStateStorage()->GetInt(ImGui::GetID(title), 1) == 0; }

// What was drawn below `top` (screen coordinates), unless all of it is in sight.
void bring_into_view(float top) {
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (top < at.y || ImGui::GetCursorScreenPos().y > at.y + size.y) ImGui::SetScrollFromPosY(top - at.y, 0);
}

// The header of a panel, and the panel where it is unfolded here. A header in the column of a panel that is
// drawn elsewhere shows and folds it there. A panel that is unfolded by something else than its header
// scrolls into view.
void draw_foldable(std::span<const Panel> parts, PanelPlaces& places, Dock here) {
  const char* title = parts.front().title;
  const bool is_here = places.dock_of(title) == here, was = places.is_unfolded(title);
  ImGui::PushID(title);
  const bool comes = is_here && was && was_folded(title);
  const bool revealed = is_here && was && places.take_revealed(title);
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  ImGui::SetNextItemOpen(was, ImGuiCond_Always);
  const float right = ImGui::GetContentRegionMax().x;
  const bool unfolded = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_AllowItemOverlap);
  mark_last_item(title);
  if (comes) ImGui::SetScrollHereY(0);
  ImGui::PopStyleVar();
  if (unfolded && !was) places.show(title);
  if (!unfolded && was) places.fold(title);
  draw_dock_button(title, right, places);
  if (unfolded && is_here) draw_parts(parts);
  if (revealed) bring_into_view(top);
  ImGui::PopID();
}

bool begin_area(const char* name, const Area& area, ImGuiWindowFlags flags = 0) {
  ImGui::SetNextWindowPos(to_im(area.at));
  ImGui::SetNextWindowSize(to_im(area.size));
  return ImGui::Begin(name, nullptr, kFixed | flags);
}

// An area that is filled by what it holds.
constexpr ImGuiWindowFlags kFilled = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;

void draw_column(const Area& area, std::span<const Panel> panels, PanelPlaces& places) {
  if (area.size.x <= 0) return;
  const float tabs = tab_bar_height();
  const Area bar{area.at, {area.size.x, tabs}};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  if (begin_area("##tabs", bar, kFilled)) draw_tab_bar(places);
  ImGui::End();
  ImGui::PopStyleVar();
  if (begin_area("##side", {area.at + Vec2(0, tabs), {area.size.x, std::max(1.0, area.size.y - tabs)}})) {
    ImGui::PushID(static_cast<int>(places.tab()));
    for_each_title(panels, [&](std::span<const Panel> parts) {
      if (places.tab_of(parts.front().title) == places.tab()) draw_foldable(parts, places, Dock::kColumn);
    });
    ImGui::PopID();
  }
  ImGui::End();
}

void draw_second_column(const Area& area, std::span<const Panel> panels, PanelPlaces& places) {
  if (area.size.x <= 0) return;
  if (begin_area("##second", area)) {
    for_each_title(panels, [&](std::span<const Panel> parts) {
      const char* title = parts.front().title;
      if (places.dock_of(title) == Dock::kSecondColumn && places.is_unfolded(title))
        draw_foldable(parts, places, Dock::kSecondColumn);
    });
  }
  ImGui::End();
}

// Beside each other.
void draw_strip(const Area& area, std::span<const Panel> panels, PanelPlaces& places) {
  if (area.size.y <= 0) return;
  std::vector<std::span<const Panel>> shown;
  for_each_title(panels, [&](std::span<const Panel> parts) {
    const char* title = parts.front().title;
    if (places.dock_of(title) == Dock::kStrip && places.is_unfolded(title)) shown.push_back(parts);
  });
  if (begin_area("##strip", area, kFilled)) {
    const float gap = ImGui::GetStyle().ItemSpacing.x, all = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(std::max<size_t>(shown.size(), 1));
    const float width =
        std::max((all - gap * (count - 1)) / count, std::min(all, kLeastStripPanel * ImGui::GetFontSize()));
    for (const std::span<const Panel> parts : shown) {
      if (parts.data() != shown.front().data()) ImGui::SameLine();
      if (ImGui::BeginChild(parts.front().title, {width, 0})) draw_foldable(parts, places, Dock::kStrip);
      ImGui::EndChild();
    }
  }
  ImGui::End();
}

// In the middle of the picture at first, and where it was left afterwards; always within the window.
Area window_area(const std::string& title, const Layout& layout, const Settings& settings) {
  const Area& picture = layout.viewport;
  const auto kept = settings.windows.find(title);
  Area area{picture.at + 0.15 * picture.size, 0.7 * picture.size};
  if (kept != settings.windows.end()) area = kept->second;
  area.size = glm::min(area.size, picture.size);
  area.at = glm::clamp(area.at, picture.at, picture.at + picture.size - area.size);
  return area;
}

void draw_window(std::span<const Panel> parts, const Layout& layout, PanelPlaces& places,
                 Settings& settings) {
  const std::string title = parts.front().title;
  const Area area = window_area(title, layout, settings);
  ImGui::SetNextWindowPos(to_im(area.at), ImGuiCond_Appearing);
  ImGui::SetNextWindowSize(to_im(area.size), ImGuiCond_Appearing);
  ImGui::SetNextWindowSizeConstraints({12 * ImGui::GetFontSize(), 6 * ImGui::GetFontSize()},
                                      to_im(layout.viewport.size));
  bool open = true;
  if (ImGui::Begin(title.c_str(), &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    mark_window(title.c_str());
    ImGui::PushID(title.c_str());
    draw_dock_button(title.c_str(), ImGui::GetContentRegionMax().x, places);
    draw_parts(parts);
    ImGui::PopID();
  }
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  settings.windows[title] = {{at.x, at.y}, {size.x, size.y}};
  ImGui::End();
  if (!open) places.fold(title);
}

void drag_edge(const SplitterMove& move, double Settings::*size, double wanted, double least, double most,
               Settings& settings) {
  if (move.reset) settings.*size = Settings().*size;
  if (move.dragged) settings.*size = std::clamp(wanted / ImGui::GetFontSize(), least, most);
}

}  // namespace

void draw_panel_areas(const Layout& layout, std::span<const Panel> panels, PanelPlaces& places,
                      Settings& settings) {
  draw_column(layout.side, panels, places);
  draw_second_column(layout.second_side, panels, places);
  draw_strip(layout.strip, panels, places);
  for_each_title(panels, [&](std::span<const Panel> parts) {
    const char* title = parts.front().title;
    if (places.dock_of(title) == Dock::kWindow && places.is_unfolded(title))
      draw_window(parts, layout, places, settings);
  });
}

std::vector<UserAction> panel_actions(std::span<const Panel> panels, PanelPlaces& places) {
  std::vector<UserAction> actions;
  for_each_title(panels, [&](std::span<const Panel> parts) {
    const std::string title = parts.front().title;
    actions.push_back({.name = title, .tip = "Shows or folds this panel."});
    actions.back().run = [&places, title] {
      if (places.shows(title)) return places.fold(title);
      places.show(title);
    };
    actions.back().checked = [&places, title] { return places.shows(title); };
  });
  return actions;
}

PanelSizes panel_sizes(const PanelPlaces& places, const Settings& settings) {
  return {.side = settings.side_shown ? settings.side_ems : 0,
          .second_side = places.has_any(Dock::kSecondColumn) ? settings.second_ems : 0,
          .strip = places.has_any(Dock::kStrip) ? settings.strip_ems : 0};
}

void draw_splitters(const Layout& l, Settings& settings) {
  if (l.side.size.x > 0) {
    const auto to = splitter("##sides", l.side.at, l.side.size.y,
                             "Drag to make the panels wider or narrower, double click for their first width; "
                             "F4 hides them.");
    drag_edge(to, &Settings::side_ems, l.status.size.x - to.dragged.value_or(0), Settings::kLeastSide,
              Settings::kMostSide, settings);
  }
  if (l.second_side.size.x > 0) {
    const auto to =
        splitter("##second edge", l.viewport.at, l.second_side.size.y,
                 "Drag to make the panels wider or narrower, double click for their first width.");
    drag_edge(to, &Settings::second_ems, to.dragged.value_or(0), Settings::kLeastSide, Settings::kMostSide,
              settings);
  }
  if (l.strip.size.y > 0) {
    const auto to =
        splitter_across("##strip edge", l.strip.at, l.strip.size.x,
                        "Drag to make the panels higher or lower, double click for their first height.");
    drag_edge(to, &Settings::strip_ems, l.status.at.y - to.dragged.value_or(0), Settings::kLeastStrip,
              Settings::kMostStrip, settings);
  }
  if (!l.split()) return;
  const auto to = splitter("##halves", l.second.at, l.second.size.y,
                           "Drag to make a half wider or narrower, double click for equal halves.");
  if (to.reset) settings.split_share = Settings().split_share;
  if (to.dragged)
    settings.split_share = std::clamp((*to.dragged - l.viewport.at.x) / l.viewport.size.x, 0.0, 1.0);
}

}  // namespace kerf
