#pragma once

#include "ui/game/hud_state.h"
#include "ui/render/view/camera.h"

namespace kerf {

// What the head-up display shows besides the match itself.
struct HudView {
  const Match& match;
  const HudState& state;
  const CameraView& camera;
  Vec3 aim;            // where the player aims, unit
  double width = 0;    // of the beam, 0 .. 1
  bool guide = false;  // the keys are shown
};

// Draws the head-up display of a match over the window with ImGui: reticle, energy and heat, speed, the
// player's vehicle with what it has lost, the score, the clock, what just happened, and where enemies are.
// Colours are never the only sign. Sizes follow the size of the text.
void draw_hud(const HudView& view);

}  // namespace kerf
