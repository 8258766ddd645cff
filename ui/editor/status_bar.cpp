#include "ui/editor/status_bar.h"

#include <imgui.h>

#include <cstdio>
#include <string>

#include "ui/editor/number_text.h"
#include "ui/editor/theme.h"

namespace kerf {

namespace {

const char* left_button(const EditorState& state) {
  switch (state.drag) {
    case Drag::kCut:
      return "Cutting: release to end, Esc ends";
    case Drag::kOrbit:
      return "Orbiting";
    case Drag::kPan:
      return "Panning";
    case Drag::kPick:
    case Drag::kNone:
      break;
  }
  if (state.left_button == Tool::kPick) return "Pick: click chooses a piece, Shift adds, drag looks round";
  if (state.cut_once) return "Laser: left drag cuts, Ctrl+click picks";
  return "Laser: left drag cuts";
}

// Text whose right end stands at `right`, which moves to where the next one may end.
void put_from_right(float& right, const std::string& text, float least_width, ImU32 colour) {
  const float em = ImGui::GetFontSize();
  right -= std::max(ImGui::CalcTextSize(text.c_str()).x, least_width * em);
  ImGui::SameLine(right);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  right -= 1.2f * em;
}

void draw_contents(const EditorState& state) {
  std::array<char, 32> frame{};
  if (state.shown.frame_ms > 0) std::snprintf(frame.data(), frame.size(), "%.1f ms", state.shown.frame_ms);
  float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
  put_from_right(right, frame.data(), 3.6f, colours::secondary());
  put_from_right(right, grouped(state.shown.pieces) + (state.shown.pieces == 1 ? " piece" : " pieces"), 4.4f,
                 colours::text());
  put_from_right(right, grouped(state.shown.faces) + " faces", 6.0f, colours::text());

  // What went wrong comes before what the button does, where there is no room for both.
  const float em = ImGui::GetFontSize(), left = ImGui::GetStyle().WindowPadding.x;
  const float hint = ImGui::CalcTextSize(left_button(state)).x + 1.6f * em;
  const float wanted = ImGui::CalcTextSize(state.message.c_str()).x + em;
  const bool crowded = state.message_is_error && left + hint + wanted > right;
  if (!crowded) {
    ImGui::SameLine(left);
    ImGui::TextUnformatted(left_button(state));
  }
  const float message_at = crowded ? left : left + hint;
  if (state.message.empty() || right <= message_at) return;
  ImGui::SameLine(message_at);
  ImGui::PushClipRect({message_at, 0}, {right, ImGui::GetIO().DisplaySize.y}, false);
  ImGui::PushStyleColor(ImGuiCol_Text, state.message_is_error ? colours::text() : colours::secondary());
  ImGui::TextUnformatted(((state.message_is_error ? "! " : "") + state.message).c_str());
  ImGui::PopStyleColor();
  ImGui::PopClipRect();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", state.message.c_str());
}

}  // namespace

void draw_status_bar(EditorState& state) {
  const Area& area = state.layout.status;
  ImGui::SetNextWindowPos({static_cast<float>(area.at.x), static_cast<float>(area.at.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImGui::GetStyle().FramePadding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##status", nullptr, kFixed)) draw_contents(state);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace kerf
