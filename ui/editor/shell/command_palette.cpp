#include "ui/editor/shell/command_palette.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr int kNone = std::numeric_limits<int>::min() / 2;
constexpr int kLetter = 1, kInARow = 7, kBeginsWord = 6, kBeginsText = 2;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_part_of_word(char c) {
  return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) > 127;
}

bool begins_word(std::string_view text, size_t at) {
  return at == 0 || (is_part_of_word(text[at]) && !is_part_of_word(text[at - 1]));
}

int score_of_letter(std::string_view text, size_t at) {
  return kLetter + (begins_word(text, at) ? kBeginsWord : 0) + (at == 0 ? kBeginsText : 0);
}

// Dynamic programming over the letters of the word: ends[i] is the best score of the letters so far whose
// last one is matched by text[i].
std::optional<int> score_of_word(std::string_view word, std::string_view text) {
  std::vector<int> ends(text.size(), kNone);
  for (size_t letter = 0; letter < word.size(); ++letter) {
    std::vector<int> next(text.size(), kNone);
    int best_before = letter == 0 ? 0 : kNone;  // best score of the previous letters, anywhere left of i
    for (size_t i = 0; i < text.size(); ++i) {
      if (lower(text[i]) == lower(word[letter])) {
        const int row = letter > 0 && i > 0 ? ends[i - 1] + kInARow : kNone;
        const int before = std::max(best_before, row);
        if (before > kNone / 2) next[i] = before + score_of_letter(text, i);
      }
      if (letter > 0) best_before = std::max(best_before, ends[i]);
    }
    ends = std::move(next);
  }
  const auto best = std::max_element(ends.begin(), ends.end());
  return best == ends.end() || *best <= kNone / 2 ? std::nullopt : std::optional(*best);
}

constexpr const char* kTitle = "##palette";
constexpr float kWidthEms = 42, kMaxRowsShown = 12;
constexpr int kPage = 10;
constexpr int kOfName = 4;  // weight of the name relative to a match that needs the menu

void draw_text_at(ImVec2 at, ImU32 colour, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(at, colour, text.c_str());
}

// Returns the text, or as much of it as fits in a width.
std::string fitting(std::string text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  while (!text.empty() && ImGui::CalcTextSize((text + "...").c_str()).x > width) {
    do text.pop_back();
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80);
  }
  return text + "...";
}

// Draws the key at the right, and left of it the check mark of a switch. Returns the width that they take.
float draw_key_and_state(const UserAction& action, ImVec2 right) {
  const float em = ImGui::GetFontSize();
  float width = 0;
  const auto put = [&](const std::string& text, ImU32 colour) {
    if (text.empty()) return;
    width += ImGui::CalcTextSize(text.c_str()).x;
    draw_text_at({right.x - width, right.y}, colour, text);
    width += em;
  };
  put(action.shortcut, colours::secondary());
  if (action.checked && action.checked()) put("on", colours::accent());
  return width;
}

// Draws name, menu or disabled reason, state and key. Returns true if it was clicked.
bool draw_row(const UserAction& action, size_t place, bool at_cursor) {
  const char* disabled_reason = action.objection();
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(place));
  const bool clicked = ImGui::Selectable("##row", at_cursor, ImGuiSelectableFlags_DontClosePopups);
  mark_last_item("palette row", static_cast<int>(place));
  ImGui::PopID();
  const float taken = draw_key_and_state(action, {at.x + room - 0.3f * em, at.y});
  const float left = at.x + 0.3f * em, width = room - taken - 0.6f * em;
  draw_text_at({left, at.y}, disabled_reason != nullptr ? colours::secondary() : colours::text(),
               fitting(action.name, width));
  const float name = ImGui::CalcTextSize(action.name.c_str()).x + em;
  if (name + 3 * em < width)
    draw_text_at({left + name, at.y}, colours::secondary(),
                 fitting(disabled_reason != nullptr ? disabled_reason : action.menu, width - name));
  return clicked;
}

// Deselects the text, which a field selects when it gets the focus: the next letter would replace it.
int select_nothing(ImGuiInputTextCallbackData* data) {
  if (static_cast<const CommandPalette*>(data->UserData)->begins)
    data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  return 0;
}

void draw_field(CommandPalette& palette) {
  if (palette.begins || !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##typed", "Search actions by parts of their names", palette.typed.data(),
                               palette.typed.size(), ImGuiInputTextFlags_CallbackAlways, select_nothing,
                               &palette)) {
    palette.cursor = 0;
    palette.is_selected = palette.typed.front() != '\0';
    palette.show_cursor = true;
  }
  if (ImGui::IsItemActive()) palette.begins = false;
}

void move_cursor(CommandPalette& palette, int steps, size_t count) {
  const auto last = static_cast<std::ptrdiff_t>(count) - 1;
  const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(palette.cursor) + steps;
  palette.cursor = static_cast<size_t>(std::clamp<std::ptrdiff_t>(to, 0, std::max<std::ptrdiff_t>(last, 0)));
  if (steps != 0) palette.show_cursor = palette.is_selected = true;
}

// Draws the list of matches. Returns the place of the row that was clicked.
std::optional<size_t> draw_matches(CommandPalette& palette, std::span<const UserAction> actions,
                                   const std::vector<size_t>& found) {
  std::optional<size_t> clicked;
  const float row = ImGui::GetTextLineHeightWithSpacing();
  const float rows = std::clamp(static_cast<float>(found.size()), 1.0f, kMaxRowsShown);
  if (ImGui::BeginChild("matches", {0, rows * row})) {
    if (found.empty()) ImGui::TextDisabled("No matching actions");
    for (size_t place = 0; place < found.size(); ++place) {
      const bool at_cursor = palette.is_selected && place == palette.cursor;
      if (draw_row(actions[found[place]], place, at_cursor)) clicked = place;
      if (at_cursor && std::exchange(palette.show_cursor, false)) ImGui::SetScrollHereY();
      if (at_cursor) palette.show_cursor = false;
    }
  }
  ImGui::EndChild();
  return clicked;
}

void draw_explanation(std::span<const UserAction> actions, const std::vector<size_t>& found,
                      const CommandPalette& palette) {
  ImGui::Separator();
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::PushTextWrapPos(0);
  if (palette.is_selected && palette.cursor < found.size()) {
    const UserAction& action = actions[found[palette.cursor]];
    const char* disabled_reason = action.objection();
    ImGui::TextDisabled("%s", disabled_reason != nullptr ? disabled_reason : action.tip.c_str());
  }
  ImGui::PopTextWrapPos();
  // Keeps the height of the window independent of the explanation.
  ImGui::SetCursorPos({at.x, at.y + 2 * ImGui::GetTextLineHeightWithSpacing()});
}

void close(CommandPalette& palette) {
  palette.open = false;
  ImGui::CloseCurrentPopup();
}

// Returns the action to run after the palette is closed, because it may open another window.
const UserAction* draw_window(CommandPalette& palette, std::span<const UserAction> actions) {
  draw_field(palette);
  const std::vector<size_t> found = find_actions(actions, palette.typed.data());
  const CommandPalette::Keys keys = std::exchange(palette.keys, {});
  move_cursor(palette, keys.steps, found.size());
  std::optional<size_t> selected = draw_matches(palette, actions, found);
  draw_explanation(actions, found, palette);
  if (keys.escape) {
    close(palette);
    return nullptr;
  }
  if (keys.enter && palette.is_selected) selected = palette.cursor;
  if (keys.enter && !palette.is_selected) palette.begins = true;  // the field lost the focus
  if (!selected || *selected >= found.size()) return nullptr;
  palette.cursor = *selected;
  palette.is_selected = true;
  const UserAction& action = actions[found[*selected]];
  if (action.objection() != nullptr) {
    palette.begins = true;  // Enter ended the typing
    return nullptr;
  }
  close(palette);
  return &action;
}

}  // namespace

std::optional<int> fuzzy_score(std::string_view query, std::string_view text) {
  int score = 0;
  while (true) {
    const size_t from = query.find_first_not_of(' ');
    if (from == std::string_view::npos) return score;
    const size_t to = std::min(query.find(' ', from), query.size());
    const auto word = score_of_word(query.substr(from, to - from), text);
    if (!word) return std::nullopt;
    score += *word;
    query.remove_prefix(to);
  }
}

void open_palette(CommandPalette& palette) {
  palette = {};
  palette.open = palette.begins = palette.show_cursor = true;
}

void palette_key(CommandPalette& palette, int key) {
  switch (key) {
    case GLFW_KEY_UP:
      --palette.keys.steps;
      break;
    case GLFW_KEY_DOWN:
      ++palette.keys.steps;
      break;
    case GLFW_KEY_PAGE_UP:
      palette.keys.steps -= kPage;
      break;
    case GLFW_KEY_PAGE_DOWN:
      palette.keys.steps += kPage;
      break;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      palette.keys.enter = true;
      break;
    case GLFW_KEY_ESCAPE:
      palette.keys.escape = true;
      break;
    default:
      break;
  }
}

std::vector<UserAction> nameable_actions(std::span<const UserAction> actions) {
  std::vector<UserAction> all;
  for (const UserAction& action : actions) {
    if (!action.items) {
      all.push_back(action);
      continue;
    }
    for (UserAction& item : action.items()) {
      item.name = action.name + ": " + item.name;
      item.menu = action.menu;
      all.push_back(std::move(item));
    }
  }
  return all;
}

std::vector<size_t> find_actions(std::span<const UserAction> actions, const char* typed) {
  std::vector<std::pair<int, size_t>> found;
  for (size_t i = 0; i < actions.size(); ++i) {
    const UserAction& action = actions[i];
    const auto in_name = fuzzy_score(typed, action.name);
    const auto in_menu = fuzzy_score(typed, std::string(action.menu) + " " + action.name);
    if (in_name || in_menu)
      found.emplace_back(std::max(kOfName * in_name.value_or(0), in_menu.value_or(0)), i);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<size_t> order;
  for (const auto& [score, index] : found) order.push_back(index);
  return order;
}

void draw_palette(CommandPalette& palette, std::span<const UserAction> actions, float x, float y) {
  if (!palette.open) return;
  if (palette.begins && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const float em = ImGui::GetFontSize();
  const float width = std::min(kWidthEms * em, ImGui::GetIO().DisplaySize.x - 2 * em);
  ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6f * em, 0.6f * em});
  const bool drawn = ImGui::BeginPopup(kTitle, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  palette.open = drawn;  // a click outside closes it
  if (!drawn) return;
  mark_window("palette");
  const std::vector<UserAction> nameable = nameable_actions(actions);
  const UserAction* selected = draw_window(palette, nameable);
  ImGui::EndPopup();
  if (selected != nullptr) selected->run();
}

}  // namespace kerf
