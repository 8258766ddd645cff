#include "ui/window/progress_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

namespace kerf {

namespace {

constexpr float kWidth = 24, kUp = 2;  // sizes of the text

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

}  // namespace

bool draw_progress(const Area& picture, const std::string& title, double fraction, bool can_stop) {
  const float em = ImGui::GetFontSize();
  bool stopped = false;
  ImGui::SetNextWindowPos({static_cast<float>(picture.at.x + picture.size.x / 2),
                           static_cast<float>(picture.at.y + picture.size.y) - kUp * em},
                          ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSize({kWidth * em, 0});
  if (ImGui::Begin("##progress", nullptr, kFixed)) {
    ImGui::TextUnformatted(title.c_str());
    const float button = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x;
    const float beside = can_stop ? button + ImGui::GetStyle().ItemSpacing.x : 0;
    const char* text = fraction > 0 ? nullptr : "";  // null: the percentage
    ImGui::ProgressBar(static_cast<float>(fraction), {-std::max(beside, FLT_MIN), 0}, text);
    if (can_stop) {
      ImGui::SameLine();
      stopped = ImGui::Button("Cancel");
    }
  }
  ImGui::End();
  return stopped;
}

}  // namespace kerf
