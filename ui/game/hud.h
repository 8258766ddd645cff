#pragma once

#include "ui/game/hud_state.h"
#include "ui/game/lesson.h"
#include "ui/game/sighted_part.h"
#include "ui/render/view/camera.h"

namespace kerf {

// What the head-up display shows besides the match itself.
struct HudView {
  const Match& match;
  const HudState& state;
  const CameraView& camera;
  const Sight& sight;        // of the world of the match
  Vec3 aim;                  // where the player aims, unit
  double width = 0;          // of the beam, 0 .. 1
  bool guide = false;        // the keys are shown
  std::string machine = {};  // how fast the machine plays it; empty: not shown
  std::optional<SightedPart> sighted = {};
  std::optional<Lesson::Task> task = {};
};

// Draws the head-up display of a match over the window with ImGui: reticle, energy and heat, speed, the
// player's vehicle with what it has lost, the score, the clock, what just happened, where enemies are, and
// the one in the sight with what it has lost. Colours are never the only sign. Sizes follow the size of the
// text.
void draw_hud(const HudView& view);

}  // namespace kerf
