#include "ui/editor/shell/dock_menu.h"

#include <imgui.h>

#include <array>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

struct Place {
  Dock dock;
  const char* name;
};
constexpr std::array kPlaces{
    Place{Dock::kColumn, "In its tab"}, Place{Dock::kSecondColumn, "In a second column"},
    Place{Dock::kStrip, "Below the picture"}, Place{Dock::kWindow, "In a window of its own"}};

// A window of which one edge is filled: the one where the panel is.
void draw_icon(ImVec2 at, float size, Dock dock, ImU32 colour) {
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

}  // namespace

void draw_dock_button(const char* title, float right, PanelPlaces& places) {
  const float em = ImGui::GetFontSize(), line = ImGui::GetFrameHeight();
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("dock");
  ImGui::SameLine(right - line);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##dock", {line, line})) ImGui::OpenPopup("dock");
  mark_last_item((std::string("dock ") + title).c_str());
  const bool over = ImGui::IsItemHovered();
  tooltip("Where this panel is shown: in its tab, in a second column, below the picture or in a window.");
  const float size = 0.75f * em;
  draw_icon({at.x + 0.5f * (line - size), at.y + 0.5f * (line - 0.8f * size)}, size, places.dock_of(title),
            over ? colours::text() : colours::secondary());
  if (!ImGui::BeginPopup("dock")) return;
  for (const Place& place : kPlaces) {
    if (ImGui::MenuItem(place.name, nullptr, places.dock_of(title) == place.dock))
      places.dock(title, place.dock);
    mark_last_item(place.name);
  }
  ImGui::EndPopup();
}

}  // namespace kerf
