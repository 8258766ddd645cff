#pragma once

#include <vector>

#include "core/base/interval.h"
#include "core/base/pose.h"
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

// A beam that is on while it moves from one pose to the next: its origin on the straight line, its direction
// along the shorter arc.
struct BeamMove {
  Pose from, to;
  double seconds = 0;  // that the move takes, >= 0; zero where nothing is known of its time
};

// The volumes that the beam passes in a move: one, or one strip for each ray of the pattern.
std::vector<SweptCylinder> sweep_beam(const Laser& laser, const BeamMove& move);

// Subdivides a move into 2^k equal moves, each of which takes an equal share of the time. Their number is the
// smallest for which no move carries a point of the beam within `reach` metres of its origin farther than
// `radius` (m, > 0), nor turns the beam by more than 0.05 rad, so that the swept volumes follow the beam
// closely; it is limited to 2^17. The result depends on the arguments alone, so a stroke is subdivided alike
// however its moves are dealt out to steps. Precondition: directions are unit vectors and not opposite.
std::vector<BeamMove> subdivide(const BeamMove& move, double radius, double reach);
// How many moves that gives. O(1).
size_t subdivisions(const BeamMove& move, double radius, double reach);

}  // namespace kerf
