#include "ui/window/splitter.h"

#include <imgui.h>

#include "ui/window/imgui_vector.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kStrip = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

enum class Strip { kUpright, kLevel };

SplitterMove drag_strip(Strip strip, ImVec2 from, ImVec2 size, const char* tip) {
  SplitterMove move;
  ImGui::InvisibleButton("strip", size);
  const bool held = ImGui::IsItemActive(), over = ImGui::IsItemHovered(), upright = strip == Strip::kUpright;
  if (!held) tooltip(tip);
  if (!held && !over) return move;
  ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  const ImVec2 to = upright ? ImVec2(from.x, from.y + size.y) : ImVec2(from.x + size.x, from.y);
  ImGui::GetForegroundDrawList()->AddLine(
      from, to, ImGui::GetColorU32(held ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered), 2);
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    move.reset = true;
  } else if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    move.dragged = upright ? pointer.x : pointer.y;
  }
  return move;
}

SplitterMove draw_strip(Strip strip, const char* id, Vec2 begin, double length, const char* tip) {
  const float half = 0.25f * ImGui::GetFontSize();
  const ImVec2 from = to_im(begin);
  const bool upright = strip == Strip::kUpright;
  const auto along = static_cast<float>(length);
  const ImVec2 size = upright ? ImVec2(2 * half, along) : ImVec2(along, 2 * half);
  ImGui::SetNextWindowPos(upright ? ImVec2(from.x - half, from.y) : ImVec2(from.x, from.y - half));
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  SplitterMove move;
  if (ImGui::Begin(id, nullptr, kStrip)) move = drag_strip(strip, from, size, tip);
  ImGui::End();
  ImGui::PopStyleVar(2);
  return move;
}

}  // namespace

SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip) {
  return draw_strip(Strip::kUpright, id, top, height, tip);
}

SplitterMove splitter_across(const char* id, Vec2 left, double width, const char* tip) {
  return draw_strip(Strip::kLevel, id, left, width, tip);
}

}  // namespace kerf
