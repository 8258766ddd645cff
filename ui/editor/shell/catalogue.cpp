#include "ui/editor/shell/catalogue.h"

#include <algorithm>
#include <array>

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
  for (const Panel& panel : panels) places.add(panel.id, panel.tab, panel.dock, panel.unfolded);
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
  for (const UserAction& action : actions) shortcuts.emplace(action.id, action.shortcut);
}

}  // namespace kerf
