#include "ui/editor/shortcut_sheet.h"

#include <imgui.h>

#include "ui/editor/actions.h"
#include "ui/editor/theme.h"

namespace kerf {

namespace {

void row(const char* keys, const char* meaning) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextUnformatted(keys);
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(meaning);
}

}  // namespace

void draw_shortcut_sheet(EditorState& state) {
  if (!state.show_shortcuts) return;
  const Area& area = state.layout.viewport;
  const Vec2 middle = area.at + area.size * 0.5;
  ImGui::SetNextWindowPos({static_cast<float>(middle.x), static_cast<float>(middle.y)}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  constexpr ImGuiWindowFlags kSheet = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (ImGui::Begin("Shortcuts", &state.show_shortcuts, kSheet)) {
    if (ImGui::BeginTable("shortcuts", 2)) {
      for (const Gesture& g : gestures()) row(g.gesture, g.meaning);
      for (const Action& a : actions()) {
        if (a.shortcut[0] != '\0') row(a.shortcut, a.name);
      }
      ImGui::EndTable();
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace kerf
