#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/commands/stroke_commands.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// A stroke while it is cut: its settings, the end of its queued moves, and the path that the beam has swept.
struct Stroke {
  CutSettings settings;
  BeamAt beam;                 // the pose and time at the end of the last queued move
  bool ended = false;          // its end is queued
  bool given_up = false;       // a part of it failed: what is still drawn of it is not executed
  size_t queued = 0;           // moves that were queued
  std::vector<BeamMove> path;  // the moves that were begun; moves that rotate the beam are subdivided
  // For each body that has moved since the stroke began, all that the beam has swept, in the frame of the
  // body: moves of the beam and moves of the body under it. Bodies that are not listed have stood still.
  SweptByBody swept;

  // Lists what was appended to the path since the last call for the bodies that have moved. To be called
  // before a body moves again. O(appended moves * listed bodies).
  void list_path(const World& world);

  // Shortens the path by this many moves, and appends one to it if it is given: the moves were begun, but the
  // stroke was stopped before them. Precondition: list_path() was called since they were begun, and no body
  // has moved since.
  void cut_back(const World& world, size_t moves, const std::optional<BeamMove>& instead);

  // Pieces that were detached have been swept like the body that they were detached from.
  void inherit(std::span<const Detached> detached);

  // A body has moved from one placement to another while the beam stood still at a pose. Returns the moves of
  // the beam in the frame of the body, subdivided, without those that cannot meet the body, and lists them.
  // Precondition: list_path() was called. Only for a body that moved for the first time is the cost
  // proportional to the path.
  std::vector<BeamMove> move_body(BodyId id, const Body& body, const Placement& from, const Pose& beam);

 private:
  size_t listed_ = 0;  // moves of the path that swept has
};

}  // namespace kerf
