#include "ui/editor/load_bar.h"

#include <imgui.h>

namespace kerf {

namespace {

constexpr float kWidth = 24, kUp = 2;  // sizes of the text

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

}  // namespace

void draw_load_bar(EditorState& state) {
  if (!state.loader.busy()) return;
  const float em = ImGui::GetFontSize();
  const Area& over = state.layout.viewport;
  ImGui::SetNextWindowPos({static_cast<float>(over.at.x + over.size.x / 2),
                           static_cast<float>(over.at.y + over.size.y) - kUp * em},
                          ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSize({kWidth * em, 0});
  if (ImGui::Begin("##loading", nullptr, kFixed)) {
    ImGui::TextUnformatted(("Opening " + state.loader.name()).c_str());
    const float button = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::ProgressBar(static_cast<float>(state.loader.fraction()),
                       {-button - ImGui::GetStyle().ItemSpacing.x, 0});
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) cancel_opening(state);
  }
  ImGui::End();
}

void cancel_opening(EditorState& state) {
  state.say("Opening " + state.loader.name() + " was cancelled: everything is as it was.");
  state.loader.cancel();
}

}  // namespace kerf
