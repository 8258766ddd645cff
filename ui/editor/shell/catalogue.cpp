#include "ui/editor/shell/catalogue.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace kerf {

namespace {

const std::array<BindingPreset, 2> kPresets{{
    {"Kerf", "Default keys.", {}},
    {"Blender",
     "Keys that Blender users know, where Kerf has the same action: Home frames all, A selects all, X "
     "deletes, "
     "Alt+H shows, N hides the panels, F3 finds actions, Shift+Z shows edges.",
     {{"view.frame_all", "Home"},
      {"view.reset", "Ctrl+Home"},
      {"pieces.select_all", "A"},
      {"pieces.show_all", "Alt+H"},
      {"pieces.delete", "X"},
      {"view.shadow_compare", "Shift+X"},
      {"view.sidebar", "N"},
      {"view.normals", "Shift+N"},
      {"help.palette", "F3"},
      {"view.wire", "Shift+Z"}}},
}};

void set_binding(Bindings& bindings, std::span<const UserAction> usual, const std::string& id,
                 const std::string& key) {
  const UserAction* action = find_action(usual, id);
  if (action != nullptr && action->shortcut == key) {
    bindings.erase(id);
  } else {
    bindings[id] = key;
  }
}

}  // namespace

const UserAction* find_action(std::span<const UserAction> actions, const std::string& id) {
  for (const UserAction& action : actions) {
    if (action.id == id) return &action;
  }
  return nullptr;
}

std::vector<UserAction> bind_keys(std::vector<UserAction> actions, const Bindings& bindings) {
  for (UserAction& action : actions) {
    const auto found = bindings.find(action.id);
    if (found == bindings.end() || action.items) continue;
    if (!parse_chord(found->second) && !found->second.empty()) continue;
    action.set_shortcut(found->second);
    action.pad_key = 0;
  }
  return actions;
}

const UserAction* clash_of(std::span<const UserAction> actions, const UserAction& action,
                           const KeyChord& chord) {
  for (const UserAction& other : actions) {
    const bool same_key = (other.key == chord.key || other.pad_key == chord.key) && other.mods == chord.mods;
    const bool same_time = (other.has_key_when != nullptr) == (action.has_key_when != nullptr);
    if (chord.key != 0 && same_key && same_time && other.id != action.id) return &other;
  }
  return nullptr;
}

void rebind(Bindings& bindings, std::span<const UserAction> usual, const std::string& action,
            const KeyChord& chord) {
  const std::vector<UserAction> bound = bind_keys({usual.begin(), usual.end()}, bindings);
  const UserAction* changed = find_action(bound, action);
  if (changed == nullptr) return;
  if (const UserAction* other = clash_of(bound, *changed, chord)) set_binding(bindings, usual, other->id, "");
  set_binding(bindings, usual, action, chord_text(chord));
}

std::span<const BindingPreset> binding_presets() { return kPresets; }

namespace {

// The contributions of all features by their ids.
template <typename T, typename Contribute>
std::map<std::string, T> by_id(const Features& features, const Contribute& contribute) {
  std::map<std::string, T> all;
  for (const auto& feature : features) {
    for (T& one : contribute(*feature)) {
      std::string id = one.id;
      all.emplace(std::move(id), std::move(one));
    }
  }
  return all;
}

// Moves the actions of a menu to the end of the list, except for those that no feature has.
void append_menu(const MenuLayout& menu, bool in_menu, std::map<std::string, UserAction>& actions,
                 std::vector<UserAction>& list) {
  for (size_t i = 0; i < menu.actions.size(); ++i) {
    const auto found = actions.find(menu.actions[i]);
    if (found == actions.end()) continue;
    UserAction action = std::move(found->second);
    action.menu = menu.title;
    action.in_menu = in_menu;
    action.ends_group =
        i + 1 < menu.actions.size() && std::string_view(menu.actions[i + 1]) == MenuLayout::kLine;
    action.set_shortcut(action.shortcut);
    list.push_back(std::move(action));
  }
}

}  // namespace

void Catalogue::gather(const Features& features, PanelPlaces& places) {
  add_panels(features, places);
  add_actions(features);
  add_gestures(features);
}

void Catalogue::add_panels(const Features& features, PanelPlaces& places) {
  auto parts = by_id<PanelPart>(features, [](Feature& f) { return f.panel_parts(); });
  for (const TabLayout& tab : tab_layout()) {
    for (const PanelLayout& layout : tab.panels) {
      Panel panel{layout.id, layout.title, {}};
      for (const char* part : layout.parts) {
        const auto found = parts.find(part);
        if (found != parts.end()) panel.parts.push_back(std::move(found->second.draw));
      }
      panels.push_back(std::move(panel));
      places.add(layout.id, tab.tab, layout.dock, layout.unfolded);
    }
  }
  places.select_tab();
}

void Catalogue::add_actions(const Features& features) {
  auto all = by_id<UserAction>(features, [](Feature& f) { return f.actions(); });
  for (const MenuLayout& menu : menu_layout()) append_menu(menu, true, all, usual);
  for (const MenuLayout& menu : palette_layout()) append_menu(menu, false, all, usual);
  actions = usual;
}

void Catalogue::add_gestures(const Features& features) {
  const auto all = by_id<Gesture>(features, [](Feature& f) { return f.gestures(); });
  for (const char* id : gesture_layout()) {
    const auto found = all.find(id);
    if (found != all.end()) gestures.push_back(found->second);
  }
}

void Catalogue::bind(const Settings& settings, std::map<std::string, std::string>& shortcuts) {
  if (bound_ == settings.bindings && !shortcuts.empty()) return;
  bound_ = settings.bindings;
  actions = bind_keys(usual, bound_);
  shortcuts.clear();
  for (const UserAction& action : actions) shortcuts.emplace(action.id, action.shortcut);
}

}  // namespace kerf
