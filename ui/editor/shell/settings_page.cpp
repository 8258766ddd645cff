#include "ui/editor/shell/settings_page.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cctype>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/editor/shell/keymap.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

using Page = SettingsPage::Page;

constexpr float kSettingsWidthEms = 46, kSettingsHeightEms = 30, kPagesEms = 7, kLabelShare = 0.38f;
constexpr std::array<const char*, SettingsPage::kPages> kPageNames{"Appearance", "Units",  "Editing",
                                                                   "Mouse",      "Keymap", "Files"};
constexpr double kScaleStep = 0.125, kSpeedStep = 1.25;
constexpr std::array kIntervals{0, 5, 10, 30, 60, 120, 300};  // s

// A row of the window.
struct SettingRow {
  Page page;
  std::string name, meaning;
  std::function<void()> draw;          // the widget of the value
  std::function<void(int)> change;     // by one step down (-1) or up (1); may be empty
  const UserAction* action = nullptr;  // of a row of the keymap
  std::string words() const {
    std::string all = std::string(kPageNames.at(static_cast<size_t>(page))) + " " + name + " " + meaning;
    return action != nullptr ? all + " " + action->menu + " " + action->shortcut : all;
  }
};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Returns true if the text contains each word of the query, ignoring case.
bool contains_words(const std::string& text, const std::string& query) {
  const std::string in = lower(text), words = lower(query);
  for (size_t at = words.find_first_not_of(' '); at != std::string::npos;) {
    const size_t end = std::min(words.find(' ', at), words.size());
    if (in.find(words.substr(at, end - at)) == std::string::npos) return false;
    at = words.find_first_not_of(' ', end);
  }
  return true;
}

// Rows
// --------------------------------------------------------------------------------------------------------

// Keeps the next button, with this label, in the row of the last one if there is room.
void stay_in_row(const char* label) {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(label).x + 1.3f * ImGui::GetFrameHeight())
    ImGui::NewLine();
}

// A row of radio buttons for the values of an enum, in their order.
template <typename Enum>
SettingRow choice_row(Page page, const char* name, const char* meaning, Enum& value,
                      std::vector<const char*> names) {
  const auto count = static_cast<int>(names.size());
  return {.page = page,
          .name = name,
          .meaning = meaning,
          .draw =
              [&value, names = std::move(names), meaning] {
                for (size_t i = 0; i < names.size(); ++i) {
                  const char* label = names[i];
                  if (i > 0) stay_in_row(label);
                  if (ImGui::RadioButton(label, value == static_cast<Enum>(i))) value = static_cast<Enum>(i);
                  mark_last_item(label);
                  tooltip(meaning);
                }
              },
          .change =
              [&value, count](int by) {
                value = static_cast<Enum>(std::clamp(static_cast<int>(value) + by, 0, count - 1));
              }};
}

SettingRow flag_row(Page page, const char* name, const char* meaning, bool& value) {
  return {.page = page,
          .name = name,
          .meaning = meaning,
          .draw =
              [&value, name, meaning] {
                ImGui::Checkbox("##flag", &value);
                mark_last_item(name);
                tooltip(meaning);
              },
          .change = [&value](int by) { value = by > 0; }};
}

SettingRow speed_row(const char* name, const char* meaning, double& speed) {
  return {.page = Page::kMouse,
          .name = name,
          .meaning = meaning,
          .draw =
              [&speed, name, meaning] {
                ImGui::SetNextItemWidth(-1);
                real_slider({name, "##speed", meaning, true}, speed, Settings::kMinSpeed, Settings::kMaxSpeed,
                            "%.2f x");
                mark_last_item(name);
              },
          .change =
              [&speed](int by) {
                speed = std::clamp(by > 0 ? speed * kSpeedStep : speed / kSpeedStep, Settings::kMinSpeed,
                                   Settings::kMaxSpeed);
              }};
}

void change_scale(Settings& settings, int by) {
  settings.ui_scale =
      std::clamp(settings.ui_scale + by * kScaleStep, Settings::kMinScale, Settings::kMaxScale);
}

// A slider would move under the pointer that drags it.
SettingRow scale_row(Settings& settings) {
  constexpr const char* kMeaning = "Size of text, panels and menus, relative to the scale of the display.";
  const auto draw = [&settings] {
    const float size = ImGui::GetFrameHeight();
    if (ImGui::Button("-", {size, 0})) change_scale(settings, -1);
    mark_last_item("smaller text");
    tooltip(kMeaning);
    const std::string percent = text_of("%.0f %%", 100 * settings.ui_scale);
    const float room = 3.6f * ImGui::GetFontSize(), width = ImGui::CalcTextSize(percent.c_str()).x;
    ImGui::SameLine(0, 0.5f * (room - width));
    ImGui::TextUnformatted(percent.c_str());
    ImGui::SameLine(0, 0.5f * (room - width));
    if (ImGui::Button("+", {size, 0})) change_scale(settings, 1);
    mark_last_item("larger text");
    tooltip(kMeaning);
  };
  return {.page = Page::kAppearance,
          .name = "UI Scale",
          .meaning = kMeaning,
          .draw = draw,
          .change = [&settings](int by) { change_scale(settings, by); }};
}

std::vector<SettingRow> appearance_rows(Settings& s) {
  constexpr Page kOwn = Page::kAppearance;
  return {choice_row(kOwn, "Theme", "Colours of panels, menus and viewport.", s.theme, {"Dark", "Light"}),
          scale_row(s),
          choice_row(kOwn, "Palette",
                     "Accent and boxes of the AABB tree; orange and blue suit colour-blind users.", s.palette,
                     {"Red and Green", "Orange and Blue"}),
          flag_row(kOwn, "Toolbar", "The tools at the left edge of the viewport, with their options above.",
                   s.toolbar_shown),
          flag_row(kOwn, "Sidebar", "The panels at the right.", s.side_shown)};
}

// What is done with the unit of a mesh file: ask, guess, or use one of the units.
constexpr std::array<FileUnit, 4> kUnits{FileUnit::kMillimetre, FileUnit::kCentimetre, FileUnit::kMetre,
                                         FileUnit::kInch};
constexpr std::array kUnitChoices{"Ask", "Guess", "mm", "cm", "m", "in"};

size_t unit_choice(const Settings& settings, const std::string& kind) {
  const auto known = settings.frames.find(kind);
  if (known == settings.frames.end()) return 0;
  if (!known->second) return 1;
  const auto* at = std::ranges::find(kUnits, known->second->unit);
  return 2 + static_cast<size_t>(at - kUnits.begin());
}

void set_unit_choice(Settings& settings, const std::string& kind, size_t choice) {
  KERF_ASSERT(choice < kUnitChoices.size());
  if (choice == 0) {
    settings.frames.erase(kind);
  } else if (choice == 1) {
    settings.frames[kind].reset();
  } else {
    FileFrame frame = settings.frames[kind].value_or(FileFrame());
    frame.unit = kUnits.at(choice - 2);
    settings.frames[kind] = frame;
  }
}

void draw_unit(Settings& settings, const std::string& kind) {
  const size_t choice = unit_choice(settings, kind);
  const float em = ImGui::GetFontSize();
  ImGui::SetNextItemWidth(5 * em);
  if (begin_fitted_combo("##unit", kUnitChoices.at(choice))) {
    for (size_t i = 0; i < kUnitChoices.size(); ++i) {
      if (ImGui::Selectable(kUnitChoices.at(i), i == choice)) set_unit_choice(settings, kind, i);
      mark_last_item((kind + " as " + kUnitChoices.at(i)).c_str());
    }
    ImGui::EndCombo();
  }
  mark_last_item(("unit of " + kind).c_str());
  if (unit_choice(settings, kind) < 2) return;  // the list may have changed it
  FileFrame& frame = *settings.frames[kind];
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    ImGui::SameLine();
    if (ImGui::RadioButton(up == UpAxis::kY ? "Y up" : "Z up", frame.up == up)) frame.up = up;
  }
}

std::vector<SettingRow> unit_rows(Settings& settings) {
  std::vector<SettingRow> rows;
  for (const MeshFormatRow& format : kMeshFormats) {
    const std::string kind(format.ending);
    std::string name = kind;
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    rows.push_back({.page = Page::kUnits,
                    .name = name + " Files",
                    .meaning = "Length of one file unit, and the axis that points up.",
                    .draw = [&settings, kind] { draw_unit(settings, kind); },
                    .change =
                        [&settings, kind](int by) {
                          const auto last = static_cast<int>(kUnitChoices.size()) - 1;
                          const int choice = static_cast<int>(unit_choice(settings, kind)) + by;
                          set_unit_choice(settings, kind, static_cast<size_t>(std::clamp(choice, 0, last)));
                        }});
  }
  return rows;
}

std::string interval_text(int seconds) {
  if (seconds == 0) return "At once";
  return seconds % 60 == 0 ? std::to_string(seconds / 60) + " min" : std::to_string(seconds) + " s";
}

SettingRow autosave_row(Settings& settings) {
  constexpr const char* kMeaning =
      "Minimum time between autosaves. After a crash, the next start offers to recover them.";
  const auto draw = [&settings] {
    ImGui::SetNextItemWidth(7 * ImGui::GetFontSize());
    if (begin_fitted_combo("##autosave", interval_text(settings.autosave_seconds))) {
      for (const int seconds : kIntervals) {
        const std::string text = interval_text(seconds);
        if (ImGui::Selectable(text.c_str(), seconds == settings.autosave_seconds))
          settings.autosave_seconds = seconds;
        mark_last_item(("autosave " + text).c_str());
      }
      ImGui::EndCombo();
    }
    mark_last_item("autosave interval");
    tooltip(kMeaning);
  };
  const auto change = [&settings](int by) {
    const int now = settings.autosave_seconds;
    const auto* above = std::ranges::upper_bound(kIntervals, now);
    const auto* at = std::ranges::lower_bound(kIntervals, now);
    if (by > 0 && above != kIntervals.end()) settings.autosave_seconds = *above;
    if (by < 0 && at != kIntervals.begin()) settings.autosave_seconds = *(at - 1);
  };
  return {.page = Page::kEditing, .name = "Autosave", .meaning = kMeaning, .draw = draw, .change = change};
}

SettingRow memory_row(Settings& settings) {
  constexpr const char* kMeaning =
      "Memory limit for undo without replay. Older steps are replayed, which takes longer.";
  const auto draw = [&settings] {
    ImGui::SetNextItemWidth(-1);
    whole_slider({"Undo Memory", "##memory", kMeaning, true}, settings.history_megabytes,
                 Settings::kMinHistory, Settings::kMaxHistory,
                 grouped(static_cast<size_t>(settings.history_megabytes)) + " MB",
                 {Quantity::kPlain, 1, " MB"});
    mark_last_item("Undo Memory");
  };
  const auto change = [&settings](int by) {
    const int now = settings.history_megabytes;
    settings.history_megabytes =
        std::clamp(by > 0 ? 2 * now : now / 2, Settings::kMinHistory, Settings::kMaxHistory);
  };
  return {.page = Page::kEditing, .name = "Undo Memory", .meaning = kMeaning, .draw = draw, .change = change};
}

std::vector<SettingRow> editing_rows(Settings& s) {
  constexpr Page kOwn = Page::kEditing;
  return {
      memory_row(s), autosave_row(s),
      flag_row(kOwn, "Live Recut", "The sliders of the Resolution panel recut the last stroke.",
               s.live_recut),
      flag_row(kOwn, "Mesh Preview", "The tools of the Prepare panel show a preview.", s.prepare_preview)};
}

SettingRow threads_row(Settings& settings) {
  constexpr const char* kMeaning =
      "Maximum threads for loading, measuring and saving. Cutting always uses one.";
  const int most =
      std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, Settings::kMaxThreads);
  const auto draw = [&settings, most] {
    ImGui::SetNextItemWidth(-1);
    whole_slider({"Threads", "##Threads", kMeaning}, settings.threads, 0, most,
                 settings.threads == 0 ? "all" : std::to_string(settings.threads));
    mark_last_item("Threads");
  };
  return {
      .page = Page::kFiles,
      .name = "Threads",
      .meaning = kMeaning,
      .draw = draw,
      .change = [&settings, most](int by) { settings.threads = std::clamp(settings.threads + by, 0, most); }};
}

std::vector<SettingRow> file_rows(Settings& settings) {
  constexpr const char* kMeaning = "Removes all entries that are not pinned; the files are kept.";
  const auto recent = [&settings] {
    ImGui::BeginDisabled(settings.recent.empty());
    if (ImGui::Button("Clear")) settings.recent.clear();
    ImGui::EndDisabled();
    mark_last_item("clear recent");
    tooltip(kMeaning);
    ImGui::SameLine();
    ImGui::TextDisabled("%zu listed, %zu pinned", settings.recent.size(), settings.pinned.size());
  };
  return {{.page = Page::kFiles, .name = "Recent Files", .meaning = kMeaning, .draw = recent, .change = {}},
          threads_row(settings)};
}

// Keymap
// --------------------------------------------------------------------------------------------------------

// Returns the actions that can have a key, with their current keys.
std::vector<UserAction> bindable(std::span<const UserAction> usual, const Bindings& bindings) {
  std::vector<UserAction> actions = bind_keys({usual.begin(), usual.end()}, bindings);
  std::erase_if(actions, [](const UserAction& action) { return action.items != nullptr; });
  return actions;
}

void stop_waiting(SettingsPage& page) {
  page.waits_for.clear();
  page.clashes.reset();
}

void take_clashing_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual) {
  KERF_ASSERT(page.clashes && !page.waits_for.empty());
  rebind(settings.bindings, usual, page.waits_for, *page.clashes);
  stop_waiting(page);
}

// Binds the key to the action that the page waits for.
void bind_pressed(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                  int mods) {
  constexpr int kCounted = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT;
  const KeyChord chord{key, mods & kCounted};
  if (is_modifier(key) || chord_text(chord).empty()) return;
  const std::vector<UserAction> actions = bindable(usual, settings.bindings);
  const UserAction* action = find_action(actions, page.waits_for);
  if (action != nullptr && clash_of(actions, *action, chord) != nullptr) {
    page.clashes = chord;
    return;
  }
  rebind(settings.bindings, usual, page.waits_for, chord);
  stop_waiting(page);
}

bool keymap_button(const char* label, const char* landmark, const char* meaning) {
  const bool pressed = ImGui::Button(label);
  mark_last_item(landmark);
  tooltip(meaning);
  return pressed;
}

void draw_keymap_file(SettingsPage& page, Settings& settings) {
  if (keymap_button("Import...", "import keymap", "Reads the shortcuts of all actions from a file (.json)."))
    page.asks_for = SettingsPage::KeymapFile::kImport;
  stay_in_row("Export...");
  if (keymap_button("Export...", "export keymap", "Writes the shortcuts of all actions to a file (.json)."))
    page.asks_for = SettingsPage::KeymapFile::kExport;
  const bool is_default = settings.bindings.empty();
  stay_in_row("Reset");
  ImGui::BeginDisabled(is_default);
  if (keymap_button("Reset", "reset keymap",
                    is_default ? "All shortcuts have their defaults." : "Restores the default shortcuts."))
    settings.bindings.clear();
  ImGui::EndDisabled();
}

void draw_presets(Settings& settings) {
  for (const BindingPreset& preset : binding_presets()) {
    if (&preset != binding_presets().data()) stay_in_row(preset.name);
    if (ImGui::RadioButton(preset.name, settings.bindings == preset.bindings))
      settings.bindings = preset.bindings;
    mark_last_item(preset.name);
    tooltip(preset.meaning);
  }
}

void take_preset(Settings& settings, int by) {
  const std::span<const BindingPreset> presets = binding_presets();
  settings.bindings = by > 0 ? presets.back().bindings : presets.front().bindings;
}

std::vector<SettingRow> keymap_rows(SettingsPage& page, Settings& settings,
                                    std::span<const UserAction> actions) {
  constexpr Page kOwn = Page::kKeymap;
  std::vector<SettingRow> rows{{.page = kOwn,
                                .name = "Preset",
                                .meaning = "Replaces all shortcuts by those of Kerf or Blender.",
                                .draw = [&settings] { draw_presets(settings); },
                                .change = [&settings](int by) { take_preset(settings, by); }},
                               {.page = kOwn,
                                .name = "Keymap File",
                                .meaning = "Import, export and reset of the shortcuts.",
                                .draw = [&page, &settings] { draw_keymap_file(page, settings); },
                                .change = {}}};
  for (const UserAction& action : actions)
    rows.push_back({.page = kOwn,
                    .name = action.name,
                    .meaning = action.tip,
                    .draw = {},
                    .change = {},
                    .action = &action});
  return rows;
}

// Returns the rows to list: those of the page, or those of all pages that match the search. They refer to
// the arguments.
std::vector<SettingRow> listed_rows(SettingsPage& page, Settings& settings,
                                    std::span<const UserAction> actions) {
  std::vector<SettingRow> rows;
  for (auto& more :
       {appearance_rows(settings), unit_rows(settings), editing_rows(settings),
        std::vector<SettingRow>{
            speed_row("Orbit Speed", "Rotation of the view per drag of the mouse.", settings.drag_speed),
            speed_row("Zoom Speed", "Zoom per notch of the wheel.", settings.wheel_speed)},
        file_rows(settings), keymap_rows(page, settings, actions)})
    rows.insert(rows.end(), more.begin(), more.end());
  const std::string query = page.query.data();
  std::erase_if(rows, [&](const SettingRow& row) {
    return query.empty() ? row.page != page.page : !contains_words(row.words(), query);
  });
  return rows;
}

// Draw
// --------------------------------------------------------------------------------------------------------

void show_page(SettingsPage& page, Page which) {
  stop_waiting(page);
  page.page = which;
  page.query.fill('\0');
  page.cursor = 0;
  page.show_cursor = true;
}

void draw_settings_search(SettingsPage& page) {
  const bool waits = !page.waits_for.empty();
  if (std::exchange(page.leaves_search, false) && page.in_search) ImGui::ClearActiveID();
  ImGui::BeginDisabled(waits);
  if (page.take_focus && !waits) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##query", "Search settings", page.query.data(), page.query.size()))
    page.cursor = 0;
  page.in_search = ImGui::IsItemActive();
  if (page.in_search || waits) page.take_focus = false;
  mark_last_item("settings search");
  ImGui::EndDisabled();
}

void draw_pages(SettingsPage& page) {
  const bool searches = page.query.front() != '\0';
  for (size_t i = 0; i < kPageNames.size(); ++i) {
    const auto which = static_cast<Page>(i);
    if (ImGui::Selectable(kPageNames.at(i), !searches && which == page.page)) show_page(page, which);
    mark_last_item((std::string("settings page ") + kPageNames.at(i)).c_str());
  }
}

// Draws the prompt for a key, the clash to confirm, or the keys of the window.
void draw_prompt(SettingsPage& page, Settings& settings, std::span<const UserAction> usual,
                 std::span<const UserAction> actions) {
  const UserAction* action = find_action(actions, page.waits_for);
  if (action == nullptr) return ImGui::TextDisabled("Up/Down: row - Left/Right: value - Page Up/Down: page");
  if (!page.clashes)
    return ImGui::TextWrapped("Press a new shortcut for \"%s\"; Esc to cancel.", action->name.c_str());
  const UserAction* other = clash_of(actions, *action, *page.clashes);
  ImGui::TextWrapped("%s is assigned to \"%s\".", chord_text(*page.clashes).c_str(),
                     other != nullptr ? other->name.c_str() : "");
  if (ImGui::Button("Reassign (Enter)")) return take_clashing_key(page, settings, usual);
  mark_last_item("take the key");
  ImGui::SameLine();
  if (ImGui::Button("Cancel (Esc)")) stop_waiting(page);
}

void draw_action_row(SettingsPage& page, const UserAction& action, size_t place) {
  const bool waits = page.waits_for == action.id;
  if (ImGui::Selectable(action.name.c_str(), page.cursor == place, ImGuiSelectableFlags_SpanAllColumns)) {
    stop_waiting(page);
    page.cursor = place;
    page.waits_for = action.id;
  }
  mark_last_item(("key of " + action.id).c_str());
  if (!action.tip.empty()) tooltip(action.tip.c_str());
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, waits ? colours::accent() : colours::secondary());
  ImGui::TextUnformatted(waits ? "press a key" : action.shortcut.empty() ? "none" : action.shortcut.c_str());
  ImGui::PopStyleColor();
}

void draw_setting(SettingsPage& page, const SettingRow& row, size_t place) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(row.name.c_str());
  ImGui::PushID(static_cast<int>(row.page));
  if (page.cursor == place && std::exchange(page.show_cursor, false)) ImGui::SetScrollHereY();
  if (row.action != nullptr) {
    draw_action_row(page, *row.action, place);
  } else {
    ImGui::AlignTextToFramePadding();
    if (page.cursor == place)
      ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, ImGui::GetColorU32(ImGuiCol_Header));
    draw_fitted_text(row.name, row.meaning.c_str());
    ImGui::TableNextColumn();
    row.draw();
  }
  ImGui::PopID();
  ImGui::PopID();
}

void draw_page_name(Page page) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  ImGui::TextUnformatted(kPageNames.at(static_cast<size_t>(page)));
  ImGui::PopStyleColor();
}

void draw_settings(SettingsPage& page, std::span<const SettingRow> rows) {
  if (rows.empty()) return ImGui::TextDisabled("No setting matches.");
  if (!ImGui::BeginTable("rows", 2, ImGuiTableFlags_ScrollY)) return;
  const bool searches = page.query.front() != '\0';
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, kLabelShare * width);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  for (size_t i = 0; i < rows.size(); ++i) {
    if (searches && (i == 0 || rows[i].page != rows[i - 1].page)) draw_page_name(rows[i].page);
    draw_setting(page, rows[i], i);
  }
  ImGui::EndTable();
}

void draw_pages_and_rows(SettingsPage& page, Settings& settings, std::span<const UserAction> usual) {
  const std::vector<UserAction> actions = bindable(usual, settings.bindings);
  draw_settings_search(page);
  const std::vector<SettingRow> rows = listed_rows(page, settings, actions);
  page.cursor = rows.empty() ? 0 : std::min(page.cursor, rows.size() - 1);
  const float em = ImGui::GetFontSize();
  const float below = page.clashes ? 2.2f * ImGui::GetFrameHeightWithSpacing() : 1.6f * em;
  const float height = std::max(3 * em, ImGui::GetContentRegionAvail().y - below);
  if (ImGui::BeginChild("pages", {kPagesEms * em, height})) draw_pages(page);
  ImGui::EndChild();
  ImGui::SameLine();
  if (ImGui::BeginChild("rows", {0, height})) draw_settings(page, rows);
  ImGui::EndChild();
  draw_prompt(page, settings, usual, actions);
}

// Keys
// --------------------------------------------------------------------------------------------------------

void turn_page(SettingsPage& page, int by) {
  const int last = static_cast<int>(SettingsPage::kPages) - 1;
  show_page(page, static_cast<Page>(std::clamp(static_cast<int>(page.page) + by, 0, last)));
}

// Returns true if the key was used.
bool move_cursor(SettingsPage& page, size_t rows, int key) {
  const bool enters = page.in_search && (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER);
  if (key != GLFW_KEY_UP && key != GLFW_KEY_DOWN && !enters) return false;
  page.show_cursor = true;
  if (page.in_search) {
    page.leaves_search = key != GLFW_KEY_UP;
    page.cursor = 0;
  } else if (key == GLFW_KEY_DOWN) {
    if (page.cursor + 1 < rows) ++page.cursor;
  } else if (page.cursor > 0) {
    --page.cursor;
  } else {
    page.take_focus = true;
  }
  return true;
}

void change_row(SettingsPage& page, Settings& settings, std::span<const UserAction> usual,
                const SettingRow& row, int key) {
  const bool enter = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  if (row.action != nullptr) {
    if (enter) page.waits_for = row.action->id;
    if (key == GLFW_KEY_DELETE) rebind(settings.bindings, usual, row.action->id, {});
  } else if (row.change) {
    if (key == GLFW_KEY_LEFT) row.change(-1);
    if (key == GLFW_KEY_RIGHT) row.change(1);
  }
}

}  // namespace

void toggle_settings_page(SettingsPage& page) {
  const bool shows = !page.shown;
  stop_waiting(page);
  page.query.fill('\0');
  page.shown = page.take_focus = shows;
}

void settings_page_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                       int mods) {
  const bool enter = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  const bool waits = !page.waits_for.empty();
  if (key == GLFW_KEY_ESCAPE) {
    const bool searches = page.query.front() != '\0';
    if (!waits && searches) return show_page(page, page.page);
    page.shown = waits;
    return stop_waiting(page);
  }
  if (page.clashes && enter) return take_clashing_key(page, settings, usual);
  if (waits) return bind_pressed(page, settings, usual, key, mods);
  if (key == GLFW_KEY_PAGE_UP || key == GLFW_KEY_PAGE_DOWN)
    return turn_page(page, key == GLFW_KEY_PAGE_UP ? -1 : 1);
  const bool is_letter = key >= GLFW_KEY_A && key <= GLFW_KEY_Z && (mods & ~GLFW_MOD_SHIFT) == 0;
  if (is_letter || (key == GLFW_KEY_F && (mods & GLFW_MOD_CONTROL) != 0)) page.take_focus = true;
  const std::vector<UserAction> actions = bindable(usual, settings.bindings);
  const std::vector<SettingRow> rows = listed_rows(page, settings, actions);
  if (move_cursor(page, rows.size(), key) || page.in_search || page.cursor >= rows.size()) return;
  change_row(page, settings, usual, rows[page.cursor], key);
}

void draw_settings_page(SettingsPage& page, Settings& settings, std::span<const UserAction> usual) {
  if (!page.shown) return;
  if (begin_centred_window("Settings", "settings", page.shown, kSettingsWidthEms, kSettingsHeightEms))
    draw_pages_and_rows(page, settings, usual);
  end_centred_window();
  if (!page.shown) stop_waiting(page), page.in_search = page.take_focus = false;
}

}  // namespace kerf
