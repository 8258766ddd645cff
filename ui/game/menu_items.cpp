#include "ui/game/menu_items.h"

#include <imgui.h>

#include "ui/game/hud_paint.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoTitleBar;

}  // namespace

void begin_menu(const char* name, float across, float least_width) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({across * size.x, 0.5f * size.y}, ImGuiCond_Always, {across, 0.5f});
  ImGui::SetNextWindowSizeConstraints({least_width * ImGui::GetFontSize(), 0}, {size.x, 0.94f * size.y});
  ImGui::Begin(name, nullptr, kFixed);
}

void menu_heading(const char* text, float scale) {
  ImGui::SetWindowFontScale(scale);
  ImGui::TextUnformatted(text);
  ImGui::SetWindowFontScale(1);
  ImGui::Spacing();
}

bool menu_button(const char* label, const char* landmark) {
  const bool pressed = ImGui::Button(label, {ImGui::GetContentRegionAvail().x, 1.9f * ImGui::GetFontSize()});
  mark_last_item(landmark);
  return pressed;
}

void draw_scores(const std::vector<HighScore>& scores, const std::string& title, size_t now, bool fights) {
  if (scores.empty()) return;
  ImGui::TextDisabled("%s", title.c_str());
  for (size_t i = 0; i < scores.size(); ++i) {
    const HighScore& s = scores[i];
    const bool is_now = i + 1 == now;
    ImGui::PushStyleColor(ImGuiCol_Text, is_now ? colours::accent() : colours::text());
    const std::string outcome =
        std::string(s.won ? "won   " : "lost  ") + std::to_string(s.enemies_destroyed) + " destroyed  ";
    ImGui::Text("%2zu  %6.0f  %s%s%s", i + 1, s.score, fights ? outcome.c_str() : "",
                clock_text(s.seconds).c_str(), is_now ? "  this match" : "");
    ImGui::PopStyleColor();
  }
  ImGui::Spacing();
}

}  // namespace kerf
