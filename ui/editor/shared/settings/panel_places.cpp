#include "ui/editor/shared/settings/panel_places.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

void PanelPlaces::add(const std::string& title, Tab tab, Dock dock, bool unfolded) {
  known_.push_back({title, tab});
  settings_.panels.try_emplace(title, unfolded);
  if (dock != Dock::kColumn) settings_.docks.try_emplace(title, dock);
}

void PanelPlaces::choose_tab() {
  if (settings_.tab) return;
  const auto first = std::find_if(known_.begin(), known_.end(), [this](const Known& k) {
    return is_unfolded(k.title) && dock_of(k.title) == Dock::kColumn;
  });
  settings_.tab = first != known_.end() ? first->tab : Tab::kCut;
}

void PanelPlaces::show_tab(Tab tab) {
  settings_.tab = tab;
  settings_.side_shown = true;
}

Tab PanelPlaces::tab_of(const std::string& title) const {
  const auto found =
      std::find_if(known_.begin(), known_.end(), [&](const Known& k) { return k.title == title; });
  KERF_ASSERT(found != known_.end());
  return found != known_.end() ? found->tab : Tab::kCut;
}

Dock PanelPlaces::dock_of(const std::string& title) const {
  const auto found = settings_.docks.find(title);
  return found != settings_.docks.end() ? found->second : Dock::kColumn;
}

bool PanelPlaces::is_unfolded(const std::string& title) const {
  const auto found = settings_.panels.find(title);
  return found != settings_.panels.end() && found->second;
}

bool PanelPlaces::shows(const std::string& title) const {
  if (!is_unfolded(title)) return false;
  return dock_of(title) != Dock::kColumn || (settings_.side_shown && tab_of(title) == tab());
}

void PanelPlaces::show(const std::string& title) {
  settings_.panels[title] = true;
  if (dock_of(title) == Dock::kColumn) show_tab(tab_of(title));
}

void PanelPlaces::reveal(const std::string& title) {
  show(title);
  revealed_ = title;
}

bool PanelPlaces::take_revealed(const std::string& title) {
  if (revealed_ != title) return false;
  revealed_.clear();
  return true;
}

void PanelPlaces::fold(const std::string& title) { settings_.panels[title] = false; }

void PanelPlaces::dock(const std::string& title, Dock dock) {
  settings_.docks[title] = dock;
  show(title);
}

bool PanelPlaces::has_any(Dock dock) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const Known& k) { return is_unfolded(k.title) && dock_of(k.title) == dock; });
}

}  // namespace kerf
