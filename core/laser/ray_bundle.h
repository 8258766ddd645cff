#pragma once

#include <cstdint>
#include <vector>

#include "core/laser/laser.h"

namespace kerf {

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
// the faces under the beam in radii, at most kMostHalvings times. For kRays4 its four rays.
inline constexpr double kBundleSpacing = 0.3, kBundleReach = 2;
inline constexpr int kMostHalvings = 3;
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
