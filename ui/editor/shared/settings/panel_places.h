#pragma once

#include <map>
#include <string>

#include "ui/editor/shared/settings/settings.h"

namespace kerf {

// Which panels are unfolded, and where: in the column at the right, behind the tab that they belong to, or in
// one of the other places that the settings know. Panels go by their titles; those of one title share all.
class PanelPlaces {
 public:
  // The settings must outlive it.
  explicit PanelPlaces(Settings& settings) : settings_(settings) {}

  // Tells of a panel. `dock` and `unfolded` are its first state, where the settings have none yet.
  void add(const std::string& title, Tab tab, Dock dock, bool unfolded);
  // To be called when all panels are told of: chooses the tab of the first one that is unfolded, where the
  // settings name no tab.
  void choose_tab();

  Tab tab() const { return settings_.tab.value_or(Tab::kCut); }
  void show_tab(Tab tab);

  // Preconditions of these: add() was called with the title.
  Tab tab_of(const std::string& title) const;
  Dock dock_of(const std::string& title) const;
  bool is_unfolded(const std::string& title) const;
  // Whether it is unfolded and neither hidden with the column nor behind another tab.
  bool shows(const std::string& title) const;
  // Unfolds it and brings it to the front.
  void show(const std::string& title);
  // Shows it, and scrolls it into view when it is drawn next.
  void reveal(const std::string& title);
  // Whether reveal() was called with it and the panel is not in view yet; once.
  bool take_revealed(const std::string& title);
  void fold(const std::string& title);
  // Shows it in another place.
  void dock(const std::string& title, Dock dock);
  // Whether any panel is unfolded there.
  bool has_any(Dock dock) const;

 private:
  Settings& settings_;
  std::string revealed_;  // the title, until it is drawn
  struct Known {
    std::string title;
    Tab tab;
  };
  std::vector<Known> known_;  // in the order in which they were told of
};

}  // namespace kerf
