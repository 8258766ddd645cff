#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/window/window.h"

namespace kerf {

// The keys that the user has given to actions in place of the usual ones: texts of chords by the names of
// actions; an empty text takes the key from an action.
using Bindings = std::map<std::string, std::string>;

// The action of this name; null if there is none.
const UserAction* find_action(std::span<const UserAction> actions, const std::string& name);

// The actions with these keys. Bindings of unknown actions and texts that name no key change nothing.
std::vector<UserAction> bind_keys(std::vector<UserAction> actions, const Bindings& bindings);

// Another action that has the key of `action` at the same time, if it had this chord; null where there is
// none. An action that has its key only at times (UserAction::has_key_when) and one that has it otherwise do
// not clash.
const UserAction* clash_of(std::span<const UserAction> actions, const UserAction& action,
                           const KeyChord& chord);

// Gives the chord to an action, and takes it from the action that clashes. `usual` are the actions with their
// usual keys: bindings that are equal to these are dropped. An empty chord takes the key from the action.
void rebind(Bindings& bindings, std::span<const UserAction> usual, const std::string& action,
            const KeyChord& chord);

// A set of bindings that people know from elsewhere.
struct BindingPreset {
  const char* name;
  const char* meaning;
  Bindings bindings;
};
std::span<const BindingPreset> binding_presets();

using Features = std::vector<std::unique_ptr<Feature>>;

// What all features together offer.
struct Catalogue {
  std::vector<Panel> panels;        // from top to bottom
  std::vector<UserAction> usual;    // with their usual keys, in the order of the menus
  std::vector<UserAction> actions;  // with those of the settings
  std::vector<Gesture> gestures;

  // Asks the features, which must outlive it, and tells the places of all panels.
  void gather(const Features& features, PanelPlaces& places);
  // Gives the actions the keys of the settings. `shortcuts` gets the keys by the names of actions.
  void bind(const Settings& settings, std::map<std::string, std::string>& shortcuts);

 private:
  std::map<std::string, std::string> bound_;
};

}  // namespace kerf
