#include "ui/editor/pieces/piece_switches.h"

#include <imgui.h>

#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kLine = 1.4f;
constexpr float kBetween = 0.35f;  // sizes of the text, between two switches

// The room of a switch, by its middle and the half of its height.
struct Cell {
  ImVec2 middle;
  float radius = 0;
  bool clicked = false, hovered = false;
};

Cell cell(const char* id, const char* meaning) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Cell cell;
  cell.clicked = ImGui::InvisibleButton(id, {side, side});
  cell.hovered = ImGui::IsItemHovered();
  cell.middle = {at.x + 0.5f * side, at.y + 0.5f * side};
  cell.radius = 0.42f * side;
  tooltip(meaning);
  return cell;
}

// What is as usual is quiet, so that what is not stands out.
ImU32 colour_of(const Cell& cell, bool stands_out) {
  return cell.hovered || stands_out ? colours::text() : colours::secondary();
}

void draw_eye(const Cell& cell, bool open) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_of(cell, !open);
  const ImVec2 m = cell.middle;
  const float r = cell.radius, lid = open ? 1.15f * r : 0.9f * r;
  if (open) {
    list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y - lid}, {m.x + r, m.y}, colour, kLine);
    list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y + lid}, {m.x + r, m.y}, colour, kLine);
    return list.AddCircleFilled(m, 0.3f * r, colour);
  }
  list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y + lid}, {m.x + r, m.y}, colour, kLine);
  for (const float x : {-0.6f, 0.0f, 0.6f}) {
    const float from = m.y + lid * (0.5f - 0.42f * x * x);
    list.AddLine({m.x + x * r, from}, {m.x + 1.25f * x * r, from + 0.4f * r}, colour, kLine);
  }
}

// A drawing pin that stands in the surface, or lies aside as an outline.
void draw_pin(const Cell& cell, bool pinned) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_of(cell, pinned);
  const ImVec2 m = cell.middle;
  const float r = cell.radius;
  const ImVec2 head{m.x, m.y - 0.4f * r};
  if (pinned) {
    list.AddCircleFilled(head, 0.55f * r, colour);
  } else {
    list.AddCircle(head, 0.5f * r, colour, 0, kLine);
  }
  list.AddLine({m.x, head.y + 0.5f * r}, {m.x, m.y + r}, colour, kLine);
}

}  // namespace

bool eye_switch(bool open, const char* meaning) {
  const Cell at = cell("##eye", meaning);
  draw_eye(at, open);
  return at.clicked;
}

bool pin_switch(bool pinned, const char* meaning) {
  ImGui::SameLine(0, kBetween * ImGui::GetFontSize());
  const Cell at = cell("##pin", meaning);
  draw_pin(at, pinned);
  return at.clicked;
}

float width_of_switches() { return 2 * ImGui::GetTextLineHeight() + kBetween * ImGui::GetFontSize(); }

}  // namespace kerf
