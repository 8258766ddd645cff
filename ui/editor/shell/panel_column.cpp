#include "ui/editor/shell/panel_column.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/editor/shared/panel_rows.h"
#include "ui/window/icons.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

struct Place {
  Dock dock;
  const char* name;
};
constexpr std::array kPlaces{Place{Dock::kColumn, "In Its Tab"},
                             Place{Dock::kSecondColumn, "In a Second Column"},
                             Place{Dock::kStrip, "Below the Viewport"}, Place{Dock::kWindow, "In a Window"}};

// Draws a window of which the edge with the panel is filled.
void draw_dock_icon(ImVec2 at, float size, Dock dock, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 to(at.x + size, at.y + 0.8f * size);
  const float x = at.x + 0.38f * size, y = at.y + 0.45f * size;
  list.AddRect(at, to, colour, 1.5f);
  if (dock == Dock::kColumn) list.AddRectFilled({to.x - 0.38f * size, at.y}, to, colour, 1);
  if (dock == Dock::kSecondColumn) list.AddRectFilled(at, {x, to.y}, colour, 1);
  if (dock == Dock::kStrip) list.AddRectFilled({at.x, y}, to, colour, 1);
  if (dock == Dock::kWindow)
    list.AddRectFilled({at.x + 0.25f * size, at.y + 0.2f * size}, {to.x - 0.25f * size, to.y - 0.2f * size},
                       colour, 1);
}

struct TabLook {
  Tab tab;
  const char* id;
  const char* name;
  const char* tip;
  const char* shortcut;
  Icon icon;
};
constexpr std::array kTabs{
    TabLook{Tab::kCut, "cut", "Cut", "Laser, resolution, path, pieces and history.", "Alt+1", Icon::kLaser},
    TabLook{Tab::kView, "view", "View", "View, lights, AABB tree, component graph and statistics.", "Alt+2",
            Icon::kEye},
    TabLook{Tab::kPhysics, "physics", "Physics", "Falling bodies and time.", "Alt+3", Icon::kMove},
    TabLook{Tab::kThermal, "thermal", "Thermal", "Material and temperature.", "Alt+4", Icon::kThermometer},
    TabLook{Tab::kMesh, "mesh", "Mesh", "Subdivision, simplification and file contents.", "Alt+5",
            Icon::kMesh}};

void draw_tab(const TabLook& look, ImVec2 size, const ViewState& view, PanelPlaces& places) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(look.id, size)) places.show_tab(look.tab);
  mark_last_item((std::string("tab ") + look.id).c_str());
  const bool over = ImGui::IsItemHovered(), selected = places.tab() == look.tab;
  tooltip(with_shortcut(view, look.tip, std::string("tab.") + look.id).c_str());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize(), middle = std::round(at.x + 0.5f * size.x);
  const ImU32 colour = selected ? colours::accent() : over ? colours::text() : colours::secondary();
  if (selected) {
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list.AddRectFilled({at.x, at.y + size.y - 2}, {at.x + size.x, at.y + size.y}, colours::accent());
  }
  draw_icon(look.icon, list, {middle, at.y + 0.8f * em}, 0.5f * em, colour);
  const float text = ImGui::CalcTextSize(look.name).x;
  list.AddText({std::round(middle - 0.5f * text), at.y + 1.45f * em}, selected ? colours::text() : colour,
               look.name);
}

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
constexpr float kMinStripPanel = 22;  // width in sizes of the text; more panels scroll

void draw_parts(const Panel& panel) {
  ImGui::Spacing();
  for (const auto& draw : panel.parts) draw();
  ImGui::Spacing();
}

// Returns true if the header was drawn folded in the last frame.
bool was_folded(const char* title) { return ImGui::GetStateStorage()->GetInt(ImGui::GetID(title), 1) == 0; }

// Scrolls to the contents below `top` (screen coordinates), unless all of them are visible.
void bring_into_view(float top) {
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (top < at.y || ImGui::GetCursorScreenPos().y > at.y + size.y) ImGui::SetScrollFromPosY(top - at.y, 0);
}

// Draws the header of a panel, and the panel if it is unfolded here. The header in the sidebar of a panel
// docked elsewhere shows and folds it there. A panel unfolded by other means than its header scrolls into
// view.
void draw_foldable(const Panel& panel, PanelPlaces& places, Dock here) {
  const char *id = panel.id, *title = panel.title;
  const bool is_here = places.dock_of(id) == here, was = places.is_unfolded(id);
  ImGui::PushID(id);
  const bool comes = is_here && was && was_folded(title);
  const bool revealed = is_here && was && places.take_revealed(id);
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  ImGui::SetNextItemOpen(was, ImGuiCond_Always);
  const float right = ImGui::GetContentRegionMax().x;
  const bool unfolded = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_AllowItemOverlap);
  mark_last_item((std::string("panel ") + id).c_str());
  if (comes) ImGui::SetScrollHereY(0);
  ImGui::PopStyleVar();
  if (unfolded && !was) places.show(id);
  if (!unfolded && was) places.fold(id);
  draw_dock_button(id, right, places);
  if (unfolded && is_here) draw_parts(panel);
  if (revealed) bring_into_view(top);
  ImGui::PopID();
}

bool begin_area(const char* name, const Area& area, ImGuiWindowFlags flags = 0) {
  ImGui::SetNextWindowPos(to_im(area.at));
  ImGui::SetNextWindowSize(to_im(area.size));
  return ImGui::Begin(name, nullptr, kFixed | flags);
}

// An area filled by its contents.
constexpr ImGuiWindowFlags kFilled = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;

void draw_column(const ViewState& view, std::span<const Panel> panels, PanelPlaces& places) {
  const Area& area = view.layout.side;
  if (area.size.x <= 0) return;
  const float tabs = tab_bar_height();
  const Area bar{area.at, {area.size.x, tabs}};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  if (begin_area("##tabs", bar, kFilled)) draw_tab_bar(view, places);
  ImGui::End();
  ImGui::PopStyleVar();
  if (begin_area("##side", {area.at + Vec2(0, tabs), {area.size.x, std::max(1.0, area.size.y - tabs)}})) {
    ImGui::PushID(static_cast<int>(places.tab()));
    for (const Panel& panel : panels) {
      if (places.tab_of(panel.id) == places.tab()) draw_foldable(panel, places, Dock::kColumn);
    }
    ImGui::PopID();
  }
  ImGui::End();
}

void draw_second_column(const Area& area, std::span<const Panel> panels, PanelPlaces& places) {
  if (area.size.x <= 0) return;
  if (begin_area("##second", area)) {
    for (const Panel& panel : panels) {
      const char* id = panel.id;
      if (places.dock_of(id) == Dock::kSecondColumn && places.is_unfolded(id))
        draw_foldable(panel, places, Dock::kSecondColumn);
    }
  }
  ImGui::End();
}

void draw_strip(const Area& area, std::span<const Panel> panels, PanelPlaces& places) {
  if (area.size.y <= 0) return;
  std::vector<const Panel*> shown;
  for (const Panel& panel : panels) {
    const char* id = panel.id;
    if (places.dock_of(id) == Dock::kStrip && places.is_unfolded(id)) shown.push_back(&panel);
  }
  if (begin_area("##strip", area, kFilled)) {
    const float gap = ImGui::GetStyle().ItemSpacing.x, all = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(std::max<size_t>(shown.size(), 1));
    const float width =
        std::max((all - gap * (count - 1)) / count, std::min(all, kMinStripPanel * ImGui::GetFontSize()));
    for (const Panel* panel : shown) {
      if (panel != shown.front()) ImGui::SameLine();
      if (ImGui::BeginChild(panel->id, {width, 0})) draw_foldable(*panel, places, Dock::kStrip);
      ImGui::EndChild();
    }
  }
  ImGui::End();
}

// Returns the area of a floating panel: its last one, else the middle of the viewport, within the window.
Area window_area(const std::string& id, const Layout& layout, const Settings& settings) {
  const Area& picture = layout.viewport;
  const auto kept = settings.windows.find(id);
  Area area{picture.at + 0.15 * picture.size, 0.7 * picture.size};
  if (kept != settings.windows.end()) area = kept->second;
  area.size = glm::min(area.size, picture.size);
  area.at = glm::clamp(area.at, picture.at, picture.at + picture.size - area.size);
  return area;
}

void draw_window(const Panel& panel, const Layout& layout, PanelPlaces& places, Settings& settings) {
  const std::string id = panel.id, title = panel.title + ("###" + id);
  const Area area = window_area(id, layout, settings);
  ImGui::SetNextWindowPos(to_im(area.at), ImGuiCond_Appearing);
  ImGui::SetNextWindowSize(to_im(area.size), ImGuiCond_Appearing);
  ImGui::SetNextWindowSizeConstraints({12 * ImGui::GetFontSize(), 6 * ImGui::GetFontSize()},
                                      to_im(layout.viewport.size));
  bool open = true;
  if (ImGui::Begin(title.c_str(), &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    mark_window(("panel " + id).c_str());
    ImGui::PushID(id.c_str());
    draw_dock_button(id.c_str(), ImGui::GetContentRegionMax().x, places);
    draw_parts(panel);
    ImGui::PopID();
  }
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  settings.windows[id] = {{at.x, at.y}, {size.x, size.y}};
  ImGui::End();
  if (!open) places.fold(id);
}

void drag_edge(const SplitterMove& move, double Settings::*size, double wanted, double least, double most,
               Settings& settings) {
  if (move.reset) settings.*size = Settings().*size;
  if (move.dragged) settings.*size = std::clamp(wanted / ImGui::GetFontSize(), least, most);
}

}  // namespace

void draw_dock_button(const char* panel, float right, PanelPlaces& places) {
  const float em = ImGui::GetFontSize(), line = ImGui::GetFrameHeight();
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("dock");
  ImGui::SameLine(right - line);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##dock", {line, line})) ImGui::OpenPopup("dock");
  mark_last_item((std::string("dock ") + panel).c_str());
  const bool over = ImGui::IsItemHovered();
  tooltip("Place of this panel: its tab, a second column, below the viewport, or a window.");
  const float size = 0.75f * em;
  draw_dock_icon({at.x + 0.5f * (line - size), at.y + 0.5f * (line - 0.8f * size)}, size,
                 places.dock_of(panel), over ? colours::text() : colours::secondary());
  if (!ImGui::BeginPopup("dock")) return;
  for (const Place& place : kPlaces) {
    if (ImGui::MenuItem(place.name, nullptr, places.dock_of(panel) == place.dock))
      places.dock(panel, place.dock);
    mark_last_item(place.name);
  }
  ImGui::EndPopup();
}

float tab_bar_height() { return std::round(2.75f * ImGui::GetFontSize()); }

void draw_tab_bar(const ViewState& view, PanelPlaces& places) {
  const ImVec2 all = ImGui::GetWindowSize(), at = ImGui::GetWindowPos();
  for (size_t i = 0; i < kTabs.size(); ++i) {
    const auto edge = [&](size_t k) {
      return std::round(at.x + all.x * static_cast<float>(k) / static_cast<float>(kTabs.size()));
    };
    ImGui::SetCursorScreenPos({edge(i), at.y});
    draw_tab(kTabs.at(i), {edge(i + 1) - edge(i), all.y}, view, places);
  }
}

std::vector<UserAction> tab_actions(PanelPlaces& places) {
  std::vector<UserAction> actions;
  for (const TabLook& look : kTabs) {
    actions.push_back({.id = std::string("tab.") + look.id,
                       .name = std::string("Tab: ") + look.name,
                       .shortcut = look.shortcut,
                       .tip = look.tip});
    actions.back().run = [&places, tab = look.tab] { places.show_tab(tab); };
    actions.back().checked = [&places, tab = look.tab] { return places.tab() == tab; };
  }
  return actions;
}

void draw_panel_areas(const ViewState& view, std::span<const Panel> panels, PanelPlaces& places,
                      Settings& settings) {
  const Layout& layout = view.layout;
  draw_column(view, panels, places);
  draw_second_column(layout.second_side, panels, places);
  draw_strip(layout.strip, panels, places);
  for (const Panel& panel : panels) {
    const char* id = panel.id;
    if (places.dock_of(id) == Dock::kWindow && places.is_unfolded(id))
      draw_window(panel, layout, places, settings);
  }
}

std::vector<UserAction> panel_actions(std::span<const Panel> panels, PanelPlaces& places) {
  std::vector<UserAction> actions;
  for (const Panel& panel : panels) {
    const std::string id = panel.id;
    actions.push_back({.name = panel.title, .tip = "Shows or hides this panel."});
    actions.back().run = [&places, id] {
      if (places.shows(id)) return places.fold(id);
      places.reveal(id);
    };
    actions.back().checked = [&places, id] { return places.shows(id); };
  }
  return actions;
}

PanelSizes panel_sizes(const PanelPlaces& places, const Settings& settings) {
  return {.side = settings.side_shown ? settings.side_ems : 0,
          .second_side = places.has_any(Dock::kSecondColumn) ? settings.second_ems : 0,
          .strip = places.has_any(Dock::kStrip) ? settings.strip_ems : 0};
}

void draw_splitters(const ViewState& view, Settings& settings) {
  const Layout& l = view.layout;
  if (l.side.size.x > 0) {
    const std::string key = shortcut_of(view, "view.sidebar");
    const std::string tip = "Drag to resize the panels; double-click to reset their width" +
                            (key.empty() ? "." : "; " + key + " hides them.");
    const auto to = splitter("##sides", l.side.at, l.side.size.y, tip.c_str());
    drag_edge(to, &Settings::side_ems, l.status.size.x - to.dragged.value_or(0), Settings::kMinSide,
              Settings::kMaxSide, settings);
  }
  if (l.second_side.size.x > 0) {
    const auto to = splitter("##second edge", l.viewport.at, l.second_side.size.y,
                             "Drag to resize the panels; double-click to reset their width.");
    drag_edge(to, &Settings::second_ems, to.dragged.value_or(0), Settings::kMinSide, Settings::kMaxSide,
              settings);
  }
  if (l.strip.size.y > 0) {
    const auto to = splitter_across("##strip edge", l.strip.at, l.strip.size.x,
                                    "Drag to resize the panels; double-click to reset their height.");
    drag_edge(to, &Settings::strip_ems, l.status.at.y - to.dragged.value_or(0), Settings::kMinStrip,
              Settings::kMaxStrip, settings);
  }
  if (!l.split()) return;
  const auto to = splitter("##halves", l.second.at, l.second.size.y,
                           "Drag to resize the halves; double-click for equal halves.");
  if (to.reset) settings.split_share = Settings().split_share;
  if (to.dragged)
    settings.split_share = std::clamp((*to.dragged - l.viewport.at.x) / l.viewport.size.x, 0.0, 1.0);
}

}  // namespace kerf
