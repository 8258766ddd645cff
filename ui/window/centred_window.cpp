#include "ui/window/centred_window.h"

#include <imgui.h>

#include <algorithm>

#include "ui/window/landmarks.h"

namespace kerf {

bool begin_centred_window(const char* title, const char* landmark, bool& shown, float width_ems,
                          float height_ems) {
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(window.x - 2 * em, width_ems * em), std::min(window.y - 4 * em, height_ems * em)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  const bool visible = ImGui::Begin(title, &shown, kFixed);
  if (visible) mark_window(landmark);
  return visible;
}

void end_centred_window() {
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace kerf
