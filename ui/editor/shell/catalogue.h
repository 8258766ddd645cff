#pragma once

#include <map>
#include <span>

#include "ui/editor/shared/settings/panel_places.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

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
