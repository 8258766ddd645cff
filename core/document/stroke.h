#pragma once

#include <vector>

#include "core/cut/cut_step.h"

namespace kerf {

// A stroke as it is drawn: how it cuts, and the way of the beam so far.
struct Stroke {
  CutSettings settings;
  Pose pose;                   // where the beam is now
  double reach = 0;            // m along the beam that there is anything to cut
  std::vector<BeamMove> path;  // all of it, straight ways as one move

  // The beam is on at a pose.
  Stroke(const CutSettings& cut, const Pose& start) : settings(cut), pose(start), path{{start, start}} {}

  // Moves the beam on, and gives the moves that it makes.
  std::vector<BeamMove> move_to(const Pose& to) {
    std::vector<BeamMove> moves = subdivide({pose, to}, settings.laser.radius, reach);
    if (to.direction == pose.direction) {
      path.push_back({pose, to});
    } else {
      path.insert(path.end(), moves.begin(), moves.end());
    }
    pose = to;
    return moves;
  }
};

}  // namespace kerf
