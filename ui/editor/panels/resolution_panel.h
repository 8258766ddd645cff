#pragma once

#include <functional>

#include "ui/editor/changes/split_view.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// What the panel of the resolution shows and sets.
struct ResolutionParts {
  const Document& document;
  LaserControls& laser;
  SplitView& split;
  ViewState& view;
  Settings& settings;
  Requests& requests;
  const Figures& figures;
  std::function<void(bool)> show_split;
};

// How finely is cut, what the last stroke made, and the second resolution of a split picture.
void draw_resolution_panel(const ResolutionParts& on);

}  // namespace kerf
