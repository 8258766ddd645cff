#include "ui/editor/shell/catalogue.h"

#include <algorithm>

#include "ui/editor/shell/bindings.h"

namespace kerf {

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
