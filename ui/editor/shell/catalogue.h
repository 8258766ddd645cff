#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/window/window.h"

namespace kerf {

struct Catalogue;
struct Workspace;

using Features = std::vector<std::unique_ptr<Feature>>;

// The order of everything that features provide. A feature states content only, by id; the tables name each
// id exactly once.

// A panel: its parts from top to bottom, and its initial state.
struct PanelLayout {
  const char* id;
  const char* title;
  bool unfolded;
  std::vector<const char*> parts;
  Dock dock = Dock::kColumn;
};

// The panels of a tab, from top to bottom.
struct TabLayout {
  Tab tab;
  std::vector<PanelLayout> panels;
};
std::span<const TabLayout> tab_layout();

// The actions of a menu, from top to bottom. An entry that begins with kSubmenu is the title of a submenu,
// which holds the actions up to the next separator.
struct MenuLayout {
  static constexpr const char* kLine = "";  // a separator
  static constexpr char kSubmenu = '>';
  const char* title;
  std::vector<const char*> actions;
};
// The menus of the menu bar, from left to right.
std::span<const MenuLayout> menu_layout();
// Actions in no menu, under the titles that the command palette shows.
std::span<const MenuLayout> palette_layout();

// The actions of the context menu of the viewport, over a piece and over none.
std::span<const char* const> context_layout(bool over_piece);

// The gestures in the list of shortcuts.
std::span<const char* const> gesture_layout();

// Creates all features of the editor. The order defines which receives events and presses first, and whose
// overlays lie below others. The workspace and the catalogue, which is filled later, must outlive them.
Features make_features(Workspace& workspace, const Catalogue& catalogue);

// Keys set by the user: chords by the ids of actions, in place of the default key and its alternative; an
// empty chord removes them.
using Bindings = std::map<std::string, std::string>;

// Returns the action of this id, or null.
const UserAction* find_action(std::span<const UserAction> actions, const std::string& id);

// Returns the actions with these keys. Unknown actions and invalid chords are ignored.
std::vector<UserAction> bind_keys(std::vector<UserAction> actions, const Bindings& bindings);

// Returns another action that would have the same key at the same time if `action` had this chord, or null.
// An action with a conditional key (UserAction::has_key_when) does not clash with one that always has it.
const UserAction* clash_of(std::span<const UserAction> actions, const UserAction& action,
                           const KeyChord& chord);

// Drops bindings equal to the default keys of `usual`, except for those that keep the alternative of the
// default (UserAction::also) from a clash.
void drop_default_keys(Bindings& bindings, std::span<const UserAction> usual);

// Gives the chord to an action, and removes it from the action that clashes, which keeps its key if the chord
// was its alternative. `usual` are the actions with their default keys: bindings equal to these are dropped
// (see drop_default_keys). An empty chord removes the key of the action.
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

// Draws the menus of a list of actions, in which those of one menu are contiguous. Menus for which the bar
// has no room are in a last one, More.
void draw_menu_bar(std::span<const UserAction> actions);

// Draws the context menu while it is open, and opens it at the pointer if `opens`. Its content depends on
// whether a piece is selected.
void draw_context_menu(std::span<const UserAction> actions, bool opens, bool any_selected);

}  // namespace kerf
