#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shell/layout_table.h"
#include "ui/window/window.h"

namespace kerf {

// Keys set by the user: chords by the ids of actions; an empty chord removes the default key.
using Bindings = std::map<std::string, std::string>;

// Returns the action of this id, or null.
const UserAction* find_action(std::span<const UserAction> actions, const std::string& id);

// Returns the actions with these keys. Unknown actions and invalid chords are ignored.
std::vector<UserAction> bind_keys(std::vector<UserAction> actions, const Bindings& bindings);

// Returns another action that would have the same key at the same time if `action` had this chord, or null.
// An action with a conditional key (UserAction::has_key_when) does not clash with one that always has it.
const UserAction* clash_of(std::span<const UserAction> actions, const UserAction& action,
                           const KeyChord& chord);

// Gives the chord to an action, and removes it from the action that clashes. `usual` are the actions with
// their default keys: bindings equal to these are dropped. An empty chord removes the key of the action.
void rebind(Bindings& bindings, std::span<const UserAction> usual, const std::string& action,
            const KeyChord& chord);

struct BindingPreset {
  const char* name;
  const char* meaning;
  Bindings bindings;
};
std::span<const BindingPreset> binding_presets();

// A panel with the parts that features draw, from top to bottom.
struct Panel {
  const char* id;
  const char* title;
  std::vector<std::function<void()>> parts;
};

// Panels, actions and gestures of all features, in the order of the layout table.
struct Catalogue {
  std::vector<Panel> panels;        // from top to bottom
  std::vector<UserAction> usual;    // with their default keys, in the order of the menus
  std::vector<UserAction> actions;  // with the keys of the settings
  std::vector<Gesture> gestures;

  // Collects them from the features, which must outlive it, and registers the panels in `places`.
  void gather(const Features& features, PanelPlaces& places);
  // Gives the actions the keys of the settings. `shortcuts` receives the keys by the ids of actions.
  void bind(const Settings& settings, std::map<std::string, std::string>& shortcuts);

 private:
  void add_panels(const Features& features, PanelPlaces& places);
  void add_actions(const Features& features);
  void add_gestures(const Features& features);

  std::map<std::string, std::string> bound_;
};

}  // namespace kerf
