#include "ui/window/splitter.h"

#include <imgui.h>

#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kStrip = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

SplitterMove drag_strip(float x, float y, ImVec2 size, const char* tip) {
  SplitterMove move;
  ImGui::InvisibleButton("strip", size);
  const bool held = ImGui::IsItemActive(), over = ImGui::IsItemHovered();
  if (!held) tooltip(tip);
  if (!held && !over) return move;
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImGui::GetForegroundDrawList()->AddLine(
      {x, y}, {x, y + size.y},
      ImGui::GetColorU32(held ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered), 2);
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    move.reset = true;
  } else if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    move.dragged = ImGui::GetIO().MousePos.x;
  }
  return move;
}

}  // namespace

SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip) {
  const float half = 0.25f * ImGui::GetFontSize();
  const auto x = static_cast<float>(top.x), y = static_cast<float>(top.y);
  const ImVec2 size(2 * half, static_cast<float>(height));
  ImGui::SetNextWindowPos({x - half, y});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  SplitterMove move;
  if (ImGui::Begin(id, nullptr, kStrip)) move = drag_strip(x, y, size, tip);
  ImGui::End();
  ImGui::PopStyleVar(2);
  return move;
}

}  // namespace kerf
