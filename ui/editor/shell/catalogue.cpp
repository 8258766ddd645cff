#include "ui/editor/shell/catalogue.h"

#include <algorithm>
#include <array>

namespace kerf {

namespace {

const std::array<BindingPreset, 2> kPresets{{
    {"Kerf", "Default keys.", {}},
    {"Like Blender",
     "Keys that Blender users know, where Kerf has the same action: Home frames all, A selects all, X "
     "deletes, "
     "Alt+H shows, N hides the panels, F3 finds actions, Shift+Z shows edges.",
     {{"Frame all", "Home"},
      {"First view", "Ctrl+Home"},
      {"Choose all pieces", "A"},
      {"Show all pieces", "Alt+H"},
      {"Delete the chosen", "X"},
      {"Compare two shadow methods", "Shift+X"},
      {"Column of panels", "N"},
      {"Normals", "Shift+N"},
      {"Command palette", "F3"},
      {"Wire", "Shift+Z"}}},
}};

void set_binding(Bindings& bindings, std::span<const UserAction> usual, const std::string& name,
                 const std::string& key) {
  const UserAction* action = find_action(usual, name);
  if (action != nullptr && action->shortcut == key) {
    bindings.erase(name);
  } else {
    bindings[name] = key;
  }
}

}  // namespace

const UserAction* find_action(std::span<const UserAction> actions, const std::string& name) {
  for (const UserAction& action : actions) {
    if (action.name == name) return &action;
  }
  return nullptr;
}

std::vector<UserAction> bind_keys(std::vector<UserAction> actions, const Bindings& bindings) {
  for (UserAction& action : actions) {
    const auto found = bindings.find(action.name);
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
    if (chord.key != 0 && same_key && same_time && other.name != action.name) return &other;
  }
  return nullptr;
}

void rebind(Bindings& bindings, std::span<const UserAction> usual, const std::string& action,
            const KeyChord& chord) {
  const std::vector<UserAction> bound = bind_keys({usual.begin(), usual.end()}, bindings);
  const UserAction* changed = find_action(bound, action);
  if (changed == nullptr) return;
  if (const UserAction* other = clash_of(bound, *changed, chord))
    set_binding(bindings, usual, other->name, "");
  set_binding(bindings, usual, action, chord_text(chord));
}

std::span<const BindingPreset> binding_presets() { return kPresets; }

namespace {

template <typename T>
void append_in_order(std::vector<T>& all, std::vector<T> some) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
  std::stable_sort(all.begin(), all.end(), [](const T& a, const T& b) { return a.place < b.place; });
}

}  // namespace

void Catalogue::gather(const Features& features, PanelPlaces& places) {
  std::vector<ActionGroup> groups;
  for (const auto& feature : features) {
    append_in_order(panels, feature->panels());
    append_in_order(groups, feature->actions());
    append_in_order(gestures, feature->gestures());
  }
  for (const Panel& panel : panels) places.add(panel.title, panel.tab, panel.dock, panel.unfolded);
  places.choose_tab();
  for (ActionGroup& group : groups) {
    for (UserAction& action : group.actions) {
      if (action.menu == nullptr) action.menu = group.menu;
      action.set_shortcut(action.shortcut);
      usual.push_back(std::move(action));
    }
  }
  actions = usual;
}

void Catalogue::bind(const Settings& settings, std::map<std::string, std::string>& shortcuts) {
  if (bound_ == settings.bindings && !shortcuts.empty()) return;
  bound_ = settings.bindings;
  actions = bind_keys(usual, bound_);
  shortcuts.clear();
  for (const UserAction& action : actions) shortcuts.emplace(action.name, action.shortcut);
}

}  // namespace kerf
