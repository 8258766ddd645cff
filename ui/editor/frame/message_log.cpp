#include "ui/editor/frame/message_log.h"

#include <imgui.h>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kWidthEms = 48, kHeightEms = 26, kTimeEms = 5;
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;

std::string time_text(std::time_t when) {
  std::tm parts{};
  localtime_r(&when, &parts);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%H:%M:%S", &parts);
  return text.data();
}

std::string as_text(const std::deque<Message::Said>& log) {
  std::string all;
  for (const Message::Said& said : log) all += time_text(said.when) + "  " + said.text + "\n";
  return all;
}

void draw_said(const Message::Said& said) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextUnformatted(time_text(said.when).c_str());
  if (said.is_error) ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s%s", said.is_error ? "! " : "", said.text.c_str());
  if (!said.is_error) ImGui::PopStyleColor();
}

void draw_log(const std::deque<Message::Said>& log) {
  if (log.empty()) return ImGui::TextDisabled("Nothing was said yet.");
  if (ImGui::SmallButton("Copy all")) ImGui::SetClipboardText(as_text(log).c_str());
  tooltip("Copies these sentences as text, the oldest first.");
  if (!ImGui::BeginTable("log", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthFixed, kTimeEms * ImGui::GetFontSize());
  ImGui::TableSetupColumn("sentence", ImGuiTableColumnFlags_WidthStretch);
  for (size_t i = log.size(); i-- > 0;) draw_said(log[i]);
  ImGui::EndTable();
}

}  // namespace

void draw_message_log(bool& shown, const Message& message) {
  if (!shown) return;
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(window.x - 2 * em, kWidthEms * em), std::min(window.y - 4 * em, kHeightEms * em)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  if (ImGui::Begin("Messages", &shown, kFixed)) {
    mark_window("messages");
    draw_log(message.log);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace kerf
