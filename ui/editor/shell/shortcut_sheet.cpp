#include "ui/editor/shell/shortcut_sheet.h"

#include <imgui.h>

#include <vector>

#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kColumnEms = 30, kKeysEms = 14;
constexpr ImGuiWindowFlags kSheet = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;

struct Row {
  const char *keys, *meaning;
};

std::vector<Row> rows_of_sheet(std::span<const UserAction> actions, std::span<const Gesture> gestures) {
  std::vector<Row> rows;
  for (const Gesture& g : gestures) rows.push_back({g.gesture, g.meaning});
  for (const UserAction& a : actions) {
    if (!a.shortcut.empty()) rows.push_back({a.shortcut.c_str(), a.name.c_str()});
  }
  return rows;
}

void put_row(const Row& row) {
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextWrapped("%s", row.keys);
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", row.meaning);
}

// The rows in so many columns, one below the other in each.
void draw_rows(const std::vector<Row>& rows, size_t columns) {
  if (!ImGui::BeginTable("shortcuts", static_cast<int>(2 * columns))) return;
  for (size_t c = 0; c < columns; ++c) {
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, kKeysEms);
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch, kColumnEms - kKeysEms);
  }
  const size_t height = (rows.size() + columns - 1) / columns;
  for (size_t r = 0; r < height; ++r) {
    ImGui::TableNextRow();
    for (size_t i = r; i < rows.size(); i += height) put_row(rows[i]);
  }
  ImGui::EndTable();
}

}  // namespace

void draw_shortcut_sheet(bool& shown, std::span<const UserAction> actions,
                         std::span<const Gesture> gestures) {
  if (!shown) return;
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float room = window.x - 2 * em;
  const size_t columns = room >= 2 * kColumnEms * em ? 2 : 1;
  const float width = std::min(room, static_cast<float>(columns) * kColumnEms * em);
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, window.y - 2 * em});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  if (ImGui::Begin("Shortcuts", &shown, kSheet)) draw_rows(rows_of_sheet(actions, gestures), columns);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace kerf
