#pragma once

#include <vector>

#include "core/tree/swept_cylinder.h"

namespace kerf {

// How the beam fills its radius.
enum class Pattern {
  kVolume,  // everything in the cylinder
  kRays4,   // four parallel rays on a circle of the radius, as in the paper
};

struct Laser {
  double radius = 0.01;   // m, > 0
  Interval range{0, 10};  // m along the beam from its origin
  Pattern pattern = Pattern::kVolume;
  double power = 2000;  // W; the geometric model does not ask
};

// A beam that is on while it moves from one pose to the next.
struct BeamMove {
  Pose from, to;
};

// The volumes that the beam passes in a move: one, or one strip for each ray of the pattern.
std::vector<SweptCylinder> sweep_beam(const Laser& laser, const BeamMove& move);

// Cuts the way between two poses into moves small enough that the sweep is true to the beam: the origin goes
// on the straight line, the direction along the shorter arc. 2^k equal moves, none of which carries a point
// of the beam within `reach` metres of its origin farther than the radius (but no more than 2^17 moves). The
// moves depend on the two poses alone, so a stroke is walked alike in however many steps. Directions are unit
// and not opposite.
std::vector<BeamMove> walk(const Pose& from, const Pose& to, double radius, double reach);

}  // namespace kerf
