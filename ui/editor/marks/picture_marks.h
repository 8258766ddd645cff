#pragma once

#include "ui/editor/changes/split_view.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/inspect/heat_probe.h"
#include "ui/editor/path/placed_lasers.h"
#include "ui/editor/play/play_state.h"
#include "ui/editor/single_step/stage_state.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// What the marks over the picture tell of.
struct MarkParts {
  const Document& document;
  const ViewState& view;
  const Hand& hand;
  const SplitView& split;
  const StageState& stages;
  const Settings& settings;
  const ShownFigures& shown;
  const ShadowFigures& shadows;
  const PlacedLasers& lasers;
  const PlayState& play;
  const HeatProbe& probe;
};

// Draws over the picture: a ring as wide as the beam, what the halves of a split picture show, the handles of
// lights and of the chosen piece, the path and the emitter, the legends of its views, what the last single
// step did, the curve of the probe, whether time passes, the spring that pulls a piece, and hints until the
// first cut.
void draw_picture_marks(const MarkParts& of);

}  // namespace kerf
