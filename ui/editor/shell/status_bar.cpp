#include "ui/editor/shell/status_bar.h"

#include <imgui.h>

#include <cstdio>
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "ui/editor/shared/files/file_frames.h"
#include "ui/window/fitted_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

struct Count {
  std::string text;
  float least_width;  // in sizes of the text, so that what is beside it stays where it is
  ImU32 colour;
  float width() const {
    return std::max(ImGui::CalcTextSize(text.c_str()).x, least_width * ImGui::GetFontSize()) +
           1.2f * ImGui::GetFontSize();
  }
};

// "3 pieces, 84 specks".
std::string pieces_text(const ShownStatistics& shown) {
  const std::string pieces = count_text(shown.pieces, "piece");
  return shown.specks == 0 ? pieces : pieces + ", " + count_text(shown.specks, "speck");
}

std::string removed_text(const ShownStatistics& shown) {
  const double area = shown.stroke->removed_area;
  return area > 0 ? area_label(area, shown.unit) : "nothing";
}

// From the right; what comes first stays longest where there is no room for all.
std::vector<Count> statistics_of(const ShownStatistics& shown) {
  std::array<char, 32> frame{};
  if (shown.frame_ms > 0) std::snprintf(frame.data(), frame.size(), "%.1f ms", shown.frame_ms);
  std::vector<Count> statistics{{count_text(shown.faces, "face"), 6.0f, colours::text()},
                                {pieces_text(shown), 4.4f, colours::text()},
                                {frame.data(), 3.6f, colours::secondary()}};
  if (!shown.time.empty()) statistics.push_back({shown.time, 6.0f, colours::text()});
  if (shown.stroke)
    statistics.push_back({"last stroke removed " + removed_text(shown), 12.4f, colours::secondary()});
  return statistics;
}

// Where the statistics begin.
float draw_statistics(const ShownStatistics& shown, float from, float to) {
  std::vector<Count> statistics = statistics_of(shown);
  float width = 0;
  for (size_t i = 0; i < statistics.size(); ++i) {
    width += statistics[i].width();
    if (from + width <= to) continue;
    width -= statistics[i].width();
    statistics.resize(i);
  }
  const float begin = to - width;
  float x = begin;
  for (const Count& count : statistics) {
    ImGui::SameLine(x + 1.2f * ImGui::GetFontSize());
    ImGui::PushStyleColor(ImGuiCol_Text, count.colour);
    ImGui::TextUnformatted(count.text.c_str());
    ImGui::PopStyleColor();
    x += count.width();
  }
  return begin;
}

// The whole sentence, wrapped: it may be longer than the window is wide.
void draw_whole(const std::string& text) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(std::min(36 * ImGui::GetFontSize(), 0.9f * ImGui::GetIO().DisplaySize.x));
  ImGui::TextUnformatted(text.c_str());
  ImGui::TextDisabled("Click for all messages.");
  ImGui::PopTextWrapPos();
  mark_window("whole message");
  ImGui::EndTooltip();
}

// Returns whether it was clicked.
bool draw_message(const Message& message, float from, float to) {
  ImGui::SameLine(from);
  ImGui::PushStyleColor(ImGuiCol_Text, message.is_error ? colours::text() : colours::secondary());
  ImGui::TextUnformatted(fitted_text((message.is_error ? "! " : "") + message.text, to - from).c_str());
  mark_last_item("message");
  ImGui::PopStyleColor();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) draw_whole(message.text);
  return hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

bool draw_contents(const char* button, const Message& message, const ShownStatistics& shown) {
  // What went wrong comes before what the button does, where there is no room for both.
  const float em = ImGui::GetFontSize(), left = ImGui::GetStyle().WindowPadding.x;
  const float end = ImGui::GetWindowWidth() - left;
  const float hint = ImGui::CalcTextSize(button).x + 1.6f * em;
  const float right = draw_statistics(shown, left + hint, end);
  const float wanted = ImGui::CalcTextSize(message.text.c_str()).x + em;
  const bool crowded = message.is_error && left + hint + wanted > right;
  if (!crowded) {
    ImGui::SameLine(left);
    ImGui::TextUnformatted(button);
  }
  const float message_at = crowded ? left : left + hint;
  return !message.text.empty() && right > message_at && draw_message(message, message_at, right);
}

}  // namespace

bool draw_status_bar(const Area& area, const char* button, const Message& message,
                     const ShownStatistics& shown) {
  KERF_ASSERT(button != nullptr);
  ImGui::SetNextWindowPos({static_cast<float>(area.at.x), static_cast<float>(area.at.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImGui::GetStyle().FramePadding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  const bool clicked = ImGui::Begin("##status", nullptr, kFixed) && draw_contents(button, message, shown);
  ImGui::End();
  ImGui::PopStyleVar(2);
  return clicked;
}

}  // namespace kerf
