#pragma once

#include <vector>

#include "core/base/interval.h"
#include "core/base/pose.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// How the beam fills its radius.
enum class Pattern {
  kVolume,  // the whole cylinder
  kRays4,   // four parallel rays on a circle of the radius, as in the paper
};

struct Laser {
  double radius = 0.01;   // m, > 0
  Interval range{0, 10};  // m along the beam from its origin
  Pattern pattern = Pattern::kVolume;
  double power = 2000;  // W; the geometric model ignores it
};

// A move of the switched-on beam from one pose to another: its origin moves along the straight line, its
// direction along the shorter arc.
struct BeamMove {
  Pose from, to;
  double seconds = 0;  // duration, >= 0; 0 if it is unknown
};

// The volumes that the beam sweeps in a move: one volume, or one strip for each ray of the pattern.
std::vector<SweptCylinder> sweep_beam(const Laser& laser, const BeamMove& move);

// Subdivides a move into 2^k equal moves, each of which takes an equal share of the time. Their number is the
// smallest for which no move carries a point of the beam within `reach` metres of its origin farther than
// `radius` (m, > 0), nor turns the beam by more than 0.05 rad, so that the swept volumes follow the beam
// closely; it is limited to 2^17. The result depends only on the arguments, so the subdivision of a stroke
// does not depend on how its moves are divided into steps. Precondition: directions are unit vectors and not
// opposite.
std::vector<BeamMove> subdivide(const BeamMove& move, double radius, double reach);
// The number of moves that subdivide() returns. O(1).
size_t subdivisions(const BeamMove& move, double radius, double reach);

}  // namespace kerf
