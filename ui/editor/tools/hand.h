#pragma once

#include <optional>
#include <vector>

#include "core/world/spring.h"
#include "ui/editor/section/section_drag.h"
#include "ui/editor/tools/laser_controls.h"
#include "ui/editor/tools/laser_tool.h"
#include "ui/editor/tools/piece_move.h"
#include "ui/editor/view/settings.h"

namespace kerf {

// What the left button does.
enum class Tool { kLaser, kPick, kInspect, kPath };

// What a drag that has begun goes on doing. One that picks, or that began on the axes, has not moved yet.
enum class Drag {
  kNone,
  kCut,
  kPick,
  kBox,
  kAxes,
  kOrbit,
  kPan,
  kLight,
  kPiece,
  kMeasure,
  kPath,
  kEmitter,
  kSection,
  kPull
};

// What the user holds, and what the mouse is doing with it.
struct Hand {
  LaserControls laser;  // as its panel sets it
  LaserTool beam;       // the stroke that is drawn
  Tool tool = Tool::kLaser;
  Drag drag = Drag::kNone;
  size_t dragged_light = 0;
  std::optional<PieceMove> move;             // of the chosen piece, while the user decides where it goes
  bool moves_copy = false;                   // the piece is a copy that was made for the move
  std::optional<BodyId> newest_before_copy;  // the body that was the newest when a copy was asked for
  std::optional<SectionDrag> section;        // of the section plane, by one of its handles
  std::optional<Spring> spring;              // on what was pressed, while time passes; pulls with kPull
  std::vector<Vec3> measured;                // m, the points that were clicked to measure: at most two
  Vec2 pointer{0}, pressed_at{0};            // screen coordinates
  bool over_picture = false;                 // the pointer is
  bool cut_once = false;                     // hints are no longer needed
};

// Whether the path is shown: while it is in hand or its panel is unfolded.
inline bool shows_path(const Hand& hand, const Settings& settings) {
  return hand.tool == Tool::kPath || settings.shows(PanelId::kPath);
}

// Ends the stroke that is drawn, if one is; what was cut stays cut. Returns whether there was one.
bool cancel_stroke(Hand& hand, Document& document);

}  // namespace kerf
