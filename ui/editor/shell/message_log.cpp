#include "ui/editor/shell/message_log.h"

#include <imgui.h>

#include "ui/window/centred_window.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kLogEms = 48, kLogHeightEms = 26, kTimeEms = 5;

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
  if (begin_centred_window("Messages", "messages", shown, kLogEms, kLogHeightEms)) {
    draw_log(message.log);
  }
  end_centred_window();
}

}  // namespace kerf
