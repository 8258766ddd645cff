#include "ui/game/start_menu.h"

#include <imgui.h>

#include "ui/game/hud_paint.h"
#include "ui/game/menu_items.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr const char* kWhatIsPlayed[] = {
    "Five waves of one to five cars, against the clock. You have three cars.",
    "Take a van apart in two minutes. Parts that come off whole count most.",
    "Nobody fights. V brings another car to cut.",
};

// A row of choices of equal width. Returns whether another one was chosen.
template <typename Enum, size_t n>
bool draw_choice(const char* what, Enum& value, const std::array<const char*, n>& titles) {
  ImGui::TextDisabled("%s", what);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap * (n - 1)) / n;
  bool other = false;
  for (size_t i = 0; i < n; ++i) {
    if (i > 0) ImGui::SameLine();
    const bool chosen = static_cast<size_t>(value) == i;
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetColorU32(chosen ? ImGuiCol_ButtonActive : ImGuiCol_Button));
    if (ImGui::Button(titles[i], {width, 0}) && !chosen) {
      value = static_cast<Enum>(i);
      other = true;
    }
    ImGui::PopStyleColor();
  }
  ImGui::Spacing();
  return other;
}

}  // namespace

MenuChoice draw_start_menu(const StartView& view) {
  GameSettings& s = view.settings;
  MenuChoice choice = MenuChoice::kNone;
  begin_menu("Start", 0.04f, 27);
  menu_heading("Kerf", 2.6f);
  ImGui::TextUnformatted("A laser on the roof, and whatever it cuts comes off.");
  ImGui::Spacing();
  bool other = draw_choice("What is played", s.mode, kModeTitles);
  ImGui::TextWrapped("%s", kWhatIsPlayed[static_cast<size_t>(s.mode)]);
  ImGui::Spacing();
  if (s.mode == GameMode::kWaves)
    other = draw_choice("Level", s.difficulty, std::array{"Easy", "Normal", "Hard"}) || other;
  other = draw_choice("Your car", s.vehicle, kVehicleTitles) || other;
  ImGui::TextDisabled("What puts a car out");
  ImGui::TextWrapped(
      "%s", "Its engine or its driver's seat is cut off. Cut through a hub, and the wheel comes off.");
  ImGui::Spacing();
  draw_scores(view.scores, "Best scores", 0, s.mode == GameMode::kWaves);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
  if (menu_button("Start (Enter)", "start")) choice = MenuChoice::kStart;
  ImGui::PopStyleColor();
  if (menu_button("The first lesson", "lesson")) choice = MenuChoice::kLesson;
  if (menu_button(view.from_editor ? "Back to the editor (Esc)" : "Quit (Esc)", "leave"))
    choice = MenuChoice::kLeave;
  ImGui::End();
  return choice == MenuChoice::kNone && other ? MenuChoice::kOther : choice;
}

}  // namespace kerf
