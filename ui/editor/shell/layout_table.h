#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/settings.h"

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

// The actions of a menu, from top to bottom.
struct MenuLayout {
  static constexpr const char* kLine = "";  // a separator
  const char* title;
  std::vector<const char*> actions;
};
// The menus of the menu bar, from left to right.
std::span<const MenuLayout> menu_layout();
// Actions in no menu, under the titles that the command palette shows.
std::span<const MenuLayout> palette_layout();

// The gestures in the list of shortcuts.
std::span<const char* const> gesture_layout();

// Creates all features of the editor. The order defines which receives events and presses first, and whose
// overlays lie below others. The workspace and the catalogue, which is filled later, must outlive them.
Features make_features(Workspace& workspace, const Catalogue& catalogue);

}  // namespace kerf
