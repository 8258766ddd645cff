#pragma once

#include <functional>
#include <span>

#include "ui/editor/frame/user_action.h"
#include "ui/editor/view/settings.h"
#include "ui/window/layout.h"

namespace kerf {

// A group of the column at the right.
struct Panel {
  PanelId id;
  const char* title;
  std::function<void()> draw;
};

// Draws the panels one below the other; which are unfolded is in the settings.
void draw_panel_column(const Area& area, std::span<const Panel> panels, Settings& settings);

// One action for each panel, which unfolds or folds it. The settings must outlive them.
std::vector<UserAction> panel_actions(std::span<const Panel> panels, Settings& settings);

// Lets the user drag the left edge of the column and the middle of a split picture.
void draw_splitters(const Layout& layout, Settings& settings);

}  // namespace kerf
