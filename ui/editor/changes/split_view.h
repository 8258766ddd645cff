#pragma once

#include "ui/editor/changes/twin_cut.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// The right half of a split picture, which shows the last stroke at another resolution.
struct SplitView {
  bool shown = false;
  ResolutionControls resolution{.edge_fraction = 1};
  TwinCut twin;
};

// Splits the picture in two or joins it again. Ends a stroke in progress.
void show_split(SplitView& split, bool shown, Hand& hand, Document& document, ViewState& view);

}  // namespace kerf
