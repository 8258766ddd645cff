#include "ui/game/game_menu.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "ui/game/hud.h"
#include "ui/game/player_input.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoTitleBar;

void dim_match() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, size, IM_COL32(10, 12, 15, 140));
}

void slider(const char* label, double& value, double low, double high, const RealFormat& format) {
  const std::string id = std::string("##") + label;
  real_slider({label, id.c_str(), label}, value, low, high, format);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::TextUnformatted(label);
}

template <typename Enum, size_t n>
void combo(const char* label, Enum& value, const std::array<const char*, n>& names) {
  KERF_ASSERT(static_cast<size_t>(value) < n);
  int index = static_cast<int>(value);
  if (ImGui::Combo(label, &index, names.data(), static_cast<int>(n))) value = static_cast<Enum>(index);
}

void draw_settings(const MenuView& view) {
  GameSettings& s = view.settings;
  ImGui::PushItemWidth(11 * ImGui::GetFontSize());
  combo("Difficulty (Next Match)", s.difficulty, std::array{"Easy", "Normal", "Hard"});
  slider("Aim Sensitivity", s.sensitivity, GameSettings::kMinSensitivity, GameSettings::kMaxSensitivity,
         "%.2f");
  slider("Field of View", s.field_of_view, GameSettings::kMinView, GameSettings::kMaxView, "%.0f\u00b0");
  double percent = 100 * s.volume;
  slider("Volume", percent, 0, 100, "%.0f %%");
  s.volume = percent / 100;
  combo("Graphics Quality", s.preset, std::array{"Automatic", "Low", "Medium", "High"});
  combo("Colours", view.look.palette, std::array{"Red and Green", "Orange and Blue"});
  ImGui::PopItemWidth();
  ImGui::Checkbox("Invert Vertical Aim", &s.invert);
  ImGui::Checkbox("Aim Assist", &s.aim_help);
  ImGui::Checkbox("Show Controls at Start", &s.guide);
  mark_last_item("guide");
  ImGui::Checkbox("Camera Shake", &s.shake);
  ImGui::Checkbox("Show FPS", &s.show_speed);
}

// A row for each action: its name, its key, which a click replaces, and its button of a gamepad.
void draw_keys(KeyBindings& bindings, std::optional<GameAction>& rebound) {
  for (size_t i = 0; i < kGameActions; ++i) {
    const auto action = static_cast<GameAction>(i);
    const ActionKeys& keys = action_keys(action);
    const float em = ImGui::GetFontSize();
    const std::string label =
        (rebound == action ? "Press a key..." : key_label(bindings[i])) + "##" + keys.id;
    if (ImGui::Button(label.c_str(), {7.5f * em, 0})) rebound = action;
    mark_last_item((std::string("key ") + keys.id).c_str());
    ImGui::SameLine();
    ImGui::TextUnformatted(keys.label);
    ImGui::SameLine(15 * em);
    ImGui::TextDisabled("%s", keys.pad_label);
  }
  if (ImGui::Button("Reset Keys")) bindings = default_bindings();
}

void draw_views(ViewOptions& look) {
  for (const ViewSwitch& s : view_switches()) {
    if (!is_debug_view(s)) continue;
    bool on = s.get(look) == 1;
    const auto digit = digit_of(s.id);
    const std::string label = digit ? std::string(s.label) + " (" + *digit + ")" : s.label;
    if (ImGui::Checkbox(label.c_str(), &on)) s.set(look, on ? 1 : 0);
    if (ImGui::IsItemHovered() && s.tip[0] != '\0') ImGui::SetTooltip("%s", s.tip);
  }
}

void draw_caption(const char* text) {
  const HudPaint paint;
  paint.text({0.62f * paint.size().x, 0.9f * paint.size().y}, text, colours::kPictureText, 1.6f,
             HudPaint::Align::kMiddle);
}

// Names the medal that the score has won, and the score for the next one.
std::string words_on_medals(const MatchResult& result) {
  static constexpr std::array kMedals{"bronze", "silver", "gold"};
  KERF_ASSERT(result.medals.size() <= kMedals.size());
  const auto next = std::ranges::upper_bound(result.medals, result.score.score);
  const auto won = static_cast<size_t>(next - result.medals.begin());
  std::string words = won > 0 ? std::string(", ") + kMedals[won - 1] + " medal" : "";
  if (next != result.medals.end()) words += text_of("; %s from %.0f", kMedals[won], *next);
  return words;
}

constexpr const char* kModeSummaries[] = {
    "Survive five waves of enemy cars before time runs out. You have three cars.",
    "Dismantle a van in two minutes. Intact parts score most.",
    "No enemies. Spawn cars and cut them.",
};

// Draws a row of choices of equal width. Returns true if the selection changed.
template <typename Enum, size_t n>
bool draw_choice(const char* what, Enum& value, const std::array<const char*, n>& titles) {
  ImGui::TextDisabled("%s", what);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap * (n - 1)) / n;
  bool other = false;
  for (size_t i = 0; i < n; ++i) {
    if (i > 0) ImGui::SameLine();
    const bool selected = static_cast<size_t>(value) == i;
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetColorU32(selected ? ImGuiCol_ButtonActive : ImGuiCol_Button));
    if (ImGui::Button(titles[i], {width, 0}) && !selected) {
      value = static_cast<Enum>(i);
      other = true;
    }
    ImGui::PopStyleColor();
  }
  ImGui::Spacing();
  return other;
}

}  // namespace

std::string words_on_course(const MatchResult& result) {
  const auto count = [](size_t n, const char* one, const char* more) {
    return std::to_string(n) + " " + (n == 1 ? one : more) + ", ";
  };
  std::string words;
  if (result.fights()) words += count(result.score.enemies_destroyed, "wreck", "wrecks");
  words += count(result.pieces, "piece cut", "pieces cut");
  if (result.fights()) words += count(result.wheels_lost, "wheel lost", "wheels lost");
  return words + clock_text(result.score.seconds);
}

void begin_menu(const char* name, float across, float min_width) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({across * size.x, 0.5f * size.y}, ImGuiCond_Always, {across, 0.5f});
  ImGui::SetNextWindowSizeConstraints({std::min(min_width * ImGui::GetFontSize(), size.x), 0},
                                      {size.x, 0.94f * size.y});
  ImGui::Begin(name, nullptr, kFixed);
}

void end_menu() {
  ImGui::NavMoveRequestTryWrapping(ImGui::GetCurrentWindow(), ImGuiNavMoveFlags_LoopY);
  ImGui::End();
}

void set_menu_navigation(bool on) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Tab] = on ? -1 : GLFW_KEY_TAB;
  io.ConfigFlags = on ? io.ConfigFlags | ImGuiConfigFlags_NavEnableGamepad
                      : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableGamepad;
  io.BackendFlags =
      on ? io.BackendFlags | ImGuiBackendFlags_HasGamepad : io.BackendFlags & ~ImGuiBackendFlags_HasGamepad;
}

bool is_menu_navigated() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavId != 0 && !context.NavDisableHighlight;
}

void menu_heading(const char* text, float scale) {
  const float size = scale * ImGui::GetFontSize();
  ImGui::PushFont(&large_font());
  ImGui::SetWindowFontScale(size / large_font().FontSize);
  ImGui::TextUnformatted(text);
  ImGui::SetWindowFontScale(1);
  ImGui::PopFont();
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
    const std::string outcome = std::string(s.won ? "won   " : "lost  ") +
                                std::to_string(s.enemies_destroyed) +
                                (s.enemies_destroyed == 1 ? " wreck   " : " wrecks  ");
    ImGui::Text("%2zu  %6.0f  %s%s%s", i + 1, s.score, fights ? outcome.c_str() : "",
                clock_text(s.seconds).c_str(), is_now ? "  (this match)" : "");
    ImGui::PopStyleColor();
  }
  ImGui::Spacing();
}

MenuChoice draw_pause_menu(const MenuView& view) {
  MenuChoice choice = MenuChoice::kNone;
  dim_match();
  begin_menu("Pause", 0.5f);
  menu_heading("Paused");
  if (menu_button("Resume (Esc)", "resume")) choice = MenuChoice::kResume;
  if (menu_button("Restart (R)", "restart")) choice = MenuChoice::kRestart;
  if (menu_button("Open in Editor", "inspect")) choice = MenuChoice::kInspect;
  if (view.ways.starts && menu_button("Change Mode, Arena or Car", "title")) choice = MenuChoice::kTitle;
  if (menu_button(view.ways.from_editor ? "Back to Editor" : "Quit", "leave")) choice = MenuChoice::kLeave;
  ImGui::Spacing();
  if (ImGui::CollapsingHeader("Settings", ImGuiTreeNodeFlags_DefaultOpen)) draw_settings(view);
  if (ImGui::CollapsingHeader("Keys")) draw_keys(view.settings.keys, view.rebound);
  mark_last_item("keys");
  // Without their keys and checkboxes, views that are on could not be switched off.
  if (ImGui::Checkbox("Debug Views", &view.settings.debug_views) && !view.settings.debug_views)
    press_digit('0', view.view);
  mark_last_item("debug views");
  if (view.settings.debug_views) draw_views(view.view);
  end_menu();
  return choice;
}

MenuChoice draw_confirmation(MenuChoice choice, const Match& match) {
  KERF_ASSERT(choice == MenuChoice::kRestart || choice == MenuChoice::kTitle || choice == MenuChoice::kLeave);
  MenuChoice answer = MenuChoice::kNone;
  const bool restarts = choice == MenuChoice::kRestart;
  dim_match();
  begin_menu("Confirm", 0.5f);
  menu_heading(restarts ? "Restart the match?" : "Leave the match?");
  ImGui::TextUnformatted(loss_warning(match).c_str());
  ImGui::Spacing();
  if (menu_button("Cancel (Esc)", "cancel")) answer = MenuChoice::kCancel;
  if (menu_button(restarts ? "Restart" : "Leave", "confirm")) answer = choice;
  end_menu();
  return answer;
}

MenuChoice draw_result(const MatchResult& result, std::optional<MatchReplay::State> replay,
                       const LeavingWays& ways) {
  using Replay = MatchReplay::State;
  MenuChoice choice = MenuChoice::kNone;
  if (replay == Replay::kPlaying) draw_caption("Highlight");
  begin_menu("Result", 0.04f);
  menu_heading(result.won ? "Won" : result.ended ? "Time is up" : "Lost", 2.2f);
  if (!result.ended) ImGui::Text("%s", result.why.c_str());
  ImGui::Text("Score %.0f%s", result.score.score, words_on_medals(result).c_str());
  ImGui::TextUnformatted(words_on_course(result).c_str());
  ImGui::Spacing();
  const std::string& level = result.score.difficulty;
  draw_scores(result.scores, "High Scores: " + result.score.rules + (level.empty() ? "" : ", " + level),
              result.rank, result.fights());
  if (menu_button("Play Again (R)", "restart")) choice = MenuChoice::kRestart;
  ImGui::BeginDisabled(replay != Replay::kOver);
  const char* label = !replay                        ? "No Highlight"
                      : replay == Replay::kPreparing ? "Preparing highlight..."
                      : replay == Replay::kPlaying   ? "Highlight"
                                                     : "Watch Highlight Again (B)";
  if (menu_button(label, replay ? "replay" : "no replay")) choice = MenuChoice::kReplay;
  ImGui::EndDisabled();
  if (menu_button("Open in Editor", "inspect")) choice = MenuChoice::kInspect;
  if (ways.starts && menu_button("Change Mode, Arena or Car", "title")) choice = MenuChoice::kTitle;
  if (menu_button(ways.from_editor ? "Back to Editor" : "Quit", "leave")) choice = MenuChoice::kLeave;
  end_menu();
  return choice;
}

MenuChoice draw_start_menu(const StartView& view) {
  GameSettings& s = view.settings;
  MenuChoice choice = MenuChoice::kNone;
  begin_menu("Start", 0.04f, 27);
  const bool small = ImGui::GetIO().DisplaySize.y < 36 * ImGui::GetFontSize();
  menu_heading("Kerf", small ? 1.3f : 2.6f);
  if (!small) ImGui::TextUnformatted("Your car has a laser. Anything that you cut falls off.");
  ImGui::Spacing();
  bool other = draw_choice("Mode", s.mode, kModeTitles);
  if (!small) {
    ImGui::TextWrapped("%s", kModeSummaries[static_cast<size_t>(s.mode)]);
    ImGui::Spacing();
  }
  if (s.mode == GameMode::kWaves)
    other = draw_choice("Difficulty", s.difficulty, std::array{"Easy", "Normal", "Hard"}) || other;
  other = draw_choice("Arena", s.arena, kArenaTitles) || other;
  other = draw_choice("Car", s.vehicle, kVehicleTitles) || other;
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
  if (menu_button("Start (Enter)", "start")) choice = MenuChoice::kStart;
  ImGui::PopStyleColor();
  if (menu_button("Tutorial", "lesson")) choice = MenuChoice::kLesson;
  if (menu_button(view.from_editor ? "Back to Editor (Esc)" : "Quit (Esc)", "leave"))
    choice = MenuChoice::kLeave;
  ImGui::Spacing();
  ImGui::TextDisabled("How to Wreck a Car");
  ImGui::TextWrapped("%s",
                     "Cut out its engine or driver's seat. Cut through a hub to take off the wheel. Cut a "
                     "post so that it falls on the car.");
  ImGui::Spacing();
  draw_scores(view.scores, "High Scores", 0, s.mode == GameMode::kWaves);
  end_menu();
  return choice == MenuChoice::kNone && other ? MenuChoice::kOther : choice;
}

}  // namespace kerf
