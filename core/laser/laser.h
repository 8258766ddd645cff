#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// How the beam fills its radius.
enum class Pattern {
  kVolume,  // the whole cylinder
  kRays4,   // four parallel rays on a circle of the radius, as in the paper
};

// The gas that is blown into the cut.
enum class Assist {
  kNone,    // one that blows the melt out and does nothing else, as nitrogen
  kOxygen,  // one in which materials burn that can (see Substance::burnt_share)
};

struct Laser {
  double radius = 0.01;   // m, > 0
  Interval range{0, 10};  // m along the beam from its origin
  Pattern pattern = Pattern::kVolume;

  // The members below are for the thermal model (see Model); the geometric model ignores it. The intensity
  // falls from the axis as exp(-2 r^2 / radius^2); kRays4 shares the power among its rays.
  double power = 2000;          // W, > 0, while the beam is on
  double wavelength = 0;        // m; 0 stands for that with which the material is usually cut
  std::optional<double> focus;  // m along the beam from its origin to its waist, where it has its radius;
                                // without it the radius is the same everywhere
  double pulse_rate = 0;        // Hz; 0 is a continuous beam
  double duty = 1;              // 0 < duty <= 1, the part of each pulse period in which the beam is on
  Assist assist = Assist::kNone;
};

// The energy (J) that the beam emits from `from` to `to` seconds after it was switched on, 0 <= from <= to. A
// pulse begins each period.
double emitted_energy(const Laser& laser, double from, double to);

// A move of the switched-on beam from one pose to another: its origin moves along the straight line, its
// direction along the shorter arc.
struct BeamMove {
  Pose from, to;
  double seconds = 0;  // duration, >= 0; 0 if it is unknown
};

// A unit vector across the unit vector d, the same for equal d.
Vec3 across(const Vec3& d);

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

// One of the rays that share the power of a beam: where it passes the waist, in radii of the beam along
// across(direction) and the vector across both, and its share of the power.
struct BundleRay {
  Vec2 offset{0};
  double share = 0;
};

// The rays of a beam. For kVolume the points of a hexagonal lattice out to kBundleReach radii around the
// middle of a triangle of it, with the shares of a Gaussian profile (1/e^2 at the radius); sums over such a
// lattice are exact but for the tail that is left out (0.03 %), which the shares make up for: they add up
// to 1. The spacing of the lattice is kBundleSpacing radii, halved until it is finer than `face`, the size of
// the faces under the beam in radii, at most kMaxHalvings times. For kRays4 its four rays.
inline constexpr double kBundleSpacing = 0.3, kBundleReach = 2;
inline constexpr int kMaxHalvings = 3;
std::vector<BundleRay> ray_bundle(Pattern pattern, double face);
// The spacing of the lattice, in radii.
double bundle_spacing(double face);

// The bundle of the pose with this number: `rays` turned around the axis, for each number by an angle that
// is no fraction of a full turn (atan 3/4), so that the rays of many poses in turn fill the profile evenly.
// It comes around after 4096 poses.
std::vector<BundleRay> turned_bundle(const std::vector<BundleRay>& rays, uint64_t number);

// The ray of a beam at a pose, in the frame of the pose. With a focus the rays are straight lines that are
// skew to the axis: together they form the hyperboloids on which a Gaussian beam widens, radius * sqrt(1 +
// (z / z_R)^2), z_R = pi radius^2 / wavelength. Without one they are parallel. Precondition: the direction of
// the pose is a unit vector.
Pose ray_at(const Laser& laser, const BundleRay& ray, const Pose& pose);

}  // namespace kerf
