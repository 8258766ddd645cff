#include "ui/editor/shell/settings_page.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "core/base/assert.h"
#include "ui/editor/shell/bindings.h"
#include "ui/window/centred_window.h"
#include "ui/window/key_chord.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/slider.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kPageWidthEms = 40, kPageHeightEms = 36, kKeyEms = 9;

// The actions that can have a key, with those that they have.
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

// The key is for the action that the page waits for.
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

void speed_row(const char* name, double& speed, const char* meaning) {
  property(name);
  const std::string id = std::string("##") + name;
  real_slider({name, id.c_str(), meaning, true}, speed, Settings::kLeastSpeed, Settings::kMostSpeed,
              "%.2f x");
  mark_last_item(name);
}

void draw_mouse(Settings& settings) {
  if (!begin_properties("mouse")) return;
  speed_row("Orbit", settings.drag_speed, "How far the view turns for a drag of the mouse.");
  speed_row("Zoom", settings.wheel_speed, "How far a notch of the wheel comes closer.");
  property("Keys");
  for (const BindingPreset& preset : binding_presets()) {
    if (&preset != binding_presets().data()) ImGui::SameLine();
    if (ImGui::RadioButton(preset.name, settings.bindings == preset.bindings))
      settings.bindings = preset.bindings;
    mark_last_item(preset.name);
    tooltip(preset.meaning);
  }
  end_properties();
}

void draw_machine(Settings& settings) {
  if (!begin_properties("machine")) return;
  property("Threads");
  const int most =
      std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, Settings::kMostThreads);
  whole_slider(
      {"Threads", "##Threads",
       "How many threads load, measure and save at the same time at most. Cutting always takes one."},
      settings.threads, 0, most, settings.threads == 0 ? "all" : std::to_string(settings.threads));
  mark_last_item("Threads");
  end_properties();
}

// What the page waits for, or the clash that it asks about.
void draw_prompt(SettingsPage& page, Settings& settings, std::span<const UserAction> usual,
                 std::span<const UserAction> actions) {
  const UserAction* action = find_action(actions, page.waits_for);
  if (action == nullptr)
    return ImGui::TextDisabled("Up and Down choose, Enter or a click rebinds, Del takes the key away.");
  if (!page.clashes)
    return ImGui::TextUnformatted(
        ("Press the key for \"" + action->name + "\"; Esc leaves it as it is.").c_str());
  const UserAction* other = clash_of(actions, *action, *page.clashes);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
      (chord_text(*page.clashes) + " is the key of \"" + (other ? other->name : "") + "\".").c_str());
  ImGui::SameLine();
  if (ImGui::Button("Take it (Enter)")) return take_clashing_key(page, settings, usual);
  mark_last_item("take the key");
  ImGui::SameLine();
  if (ImGui::Button("Leave it (Esc)")) stop_waiting(page);
}

void draw_row(SettingsPage& page, const UserAction& action, size_t place) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(place));
  const bool waits = page.waits_for == action.name;
  if (ImGui::Selectable(action.name.c_str(), page.cursor == place, ImGuiSelectableFlags_SpanAllColumns)) {
    stop_waiting(page);
    page.cursor = place;
    page.waits_for = action.name;
  }
  mark_last_item(("key of " + action.name).c_str());
  if (!action.tip.empty()) tooltip(action.tip.c_str());
  if (page.cursor == place && std::exchange(page.show_cursor, false)) ImGui::SetScrollHereY();
  ImGui::PopID();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, waits ? colours::accent() : colours::secondary());
  ImGui::TextUnformatted(waits ? "press a key" : action.shortcut.c_str());
  ImGui::PopStyleColor();
}

void draw_list(SettingsPage& page, std::span<const UserAction> actions) {
  if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, kKeyEms * ImGui::GetFontSize());
  for (size_t i = 0; i < actions.size(); ++i) draw_row(page, actions[i], i);
  ImGui::EndTable();
}

}  // namespace

void settings_page_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                       int mods) {
  const bool enter = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  const bool waits = !page.waits_for.empty();
  if (key == GLFW_KEY_ESCAPE) {
    page.shown = waits;
    return stop_waiting(page);
  }
  if (page.clashes && enter) return take_clashing_key(page, settings, usual);
  if (waits) return bind_pressed(page, settings, usual, key, mods);
  const std::vector<UserAction> actions = bindable(usual, settings.bindings);
  if (key == GLFW_KEY_UP && page.cursor > 0) --page.cursor;
  if (key == GLFW_KEY_DOWN && page.cursor + 1 < actions.size()) ++page.cursor;
  page.show_cursor = true;
  KERF_ASSERT(page.cursor < actions.size());
  if (enter) page.waits_for = actions[page.cursor].name;
  if (key == GLFW_KEY_DELETE) rebind(settings.bindings, usual, actions[page.cursor].name, {});
}

void draw_settings_page(SettingsPage& page, Settings& settings, std::span<const UserAction> usual) {
  if (!page.shown) return;
  if (begin_centred_window("Settings", "settings", page.shown, kPageWidthEms, kPageHeightEms)) {
    const std::vector<UserAction> actions = bindable(usual, settings.bindings);
    draw_mouse(settings);
    draw_machine(settings);
    draw_prompt(page, settings, usual, actions);
    draw_list(page, actions);
  }
  end_centred_window();
  if (!page.shown) stop_waiting(page);
}

}  // namespace kerf
