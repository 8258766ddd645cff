#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// Distribution of the beam over its radius.
enum class Pattern {
  kVolume,  // the full cylinder
  kRays4,   // four parallel rays on a circle of the radius, as in the paper
};

// The assist gas blown into the cut.
enum class Assist {
  kNone,    // blows the melt out and does not react, as nitrogen
  kOxygen,  // burns combustible materials (see Substance::burnt_share)
};

struct Laser {
  double radius = 0.01;   // m, > 0
  Interval range{0, 10};  // m along the beam from its origin
  Pattern pattern = Pattern::kVolume;

  // Members of the thermal model (see Model); the geometric model ignores them. The intensity falls from the
  // axis as exp(-2 r^2 / radius^2); kRays4 shares the power among its rays.
  double power = 2000;          // W, > 0, while the beam is on
  double wavelength = 0;        // m; 0 for the material's usual one
  std::optional<double> focus;  // m along the beam from its origin to its waist, which has the radius;
                                // nullopt for a constant radius
  double pulse_rate = 0;        // Hz, a pulse begins each period; 0 for a continuous beam
  double duty = 1;              // 0 < duty <= 1, the share of each pulse period with the beam on
  Assist assist = Assist::kNone;
};

// Returns the energy (J) emitted from `from` to `to` seconds after the beam was switched on, 0 <= from <= to.
double emitted_energy(const Laser& laser, double from, double to);

// A move of the active beam: its origin moves along a straight line, its direction along the shorter arc.
struct BeamMove {
  Pose from, to;
  double seconds = 0;  // duration, >= 0; 0 if it is unknown
};

// Returns a unit vector perpendicular to the unit vector d, the same for equal d.
Vec3 across(const Vec3& d);

// Returns the volumes that the beam sweeps in a move: one volume, or one strip for each ray of the pattern.
std::vector<SweptCylinder> sweep_beam(const Laser& laser, const BeamMove& move);

// Subdivides a move into 2^k <= 2^17 moves of equal length and duration: the smallest number for which no
// move carries a point of the beam within `reach` metres of its origin farther than `radius` (m, > 0), nor
// turns the beam by more than 0.05 rad, so that the swept volumes follow the beam closely. The result depends
// only on the arguments, so a stroke is subdivided equally however its moves are divided into steps.
// Precondition: directions are unit vectors and not opposite.
std::vector<BeamMove> subdivide(const BeamMove& move, double radius, double reach);
// Returns the number of moves that subdivide() returns. O(1).
size_t subdivisions(const BeamMove& move, double radius, double reach);

// One of the rays that share the power of a beam: its position in the waist, in beam radii along
// across(direction) and the vector across both, and its share of the power.
struct BundleRay {
  Vec2 offset{0};
  double share = 0;
};

// Returns the rays of a beam. For kVolume they are the points of a hexagonal lattice out to kBundleReach
// radii, centred on one of its triangles, with the shares of a Gaussian profile (1/e^2 at the radius). Sums
// over such a lattice are exact but for the omitted tail (0.03 %), which is made up for by normalising the
// shares to a sum of 1. The lattice spacing is kBundleSpacing radii, halved at most kMaxHalvings times until
// it is finer than `face`, the size of the faces under the beam in radii. For kRays4 they are its four rays.
inline constexpr double kBundleSpacing = 0.3, kBundleReach = 2;
inline constexpr int kMaxHalvings = 3;
std::vector<BundleRay> ray_bundle(Pattern pattern, double face);
double bundle_spacing(double face);

// Returns the bundle of the pose with this number: `rays` rotated about the axis, for each number by an angle
// that is an irrational fraction of a full turn (atan 3/4), so that the rays of successive poses fill the
// profile evenly. It repeats after 4096 poses.
std::vector<BundleRay> turned_bundle(const std::vector<BundleRay>& rays, uint64_t number);

// Returns the ray of a beam at a pose, in the frame of the pose. With a focus the rays are straight lines
// skew to the axis; together they form the hyperboloids of a widening Gaussian beam, radius * sqrt(1 + (z /
// z_R)^2), z_R = pi radius^2 / wavelength. Without one they are parallel. Precondition: the direction of the
// pose is a unit vector.
Pose ray_at(const Laser& laser, const BundleRay& ray, const Pose& pose);

}  // namespace kerf
