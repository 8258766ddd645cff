#pragma once

#include <algorithm>
#include <cassert>

#include "core/base/geometry.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The volume that a cylinder with flat ends sweeps between two poses: all points within the radius of its
// axis whose depth along the axis lies in the range. The origin moves on a straight line, and the direction
// turns evenly. The volume is exact for a translation. If the cylinder tilts, the corners of a triangle are
// assumed to move on straight lines in the plane across the beam; the error is proportional to the square of
// the angle, so that large turns must be subdivided.
//
// All arguments are in one frame, in metres. The radius may be zero: a ray, or the strip that a moving ray
// sweeps.
class SweptCylinder {
 public:
  // Preconditions: both directions are unit vectors and not opposite to each other, radius >= 0.
  SweptCylinder(const Pose& from, const Pose& to, double radius, Interval range);

  // Whether the closed triangle meets the closed volume.
  bool touches(const Triangle& t) const { return touches(t, radius_); }
  // The same of this sweep with another radius.
  bool touches(const Triangle& t, double radius) const;

  // Whether the triangle lies entirely within the volume; always false for a radius of zero.
  bool contains(const Triangle& t) const;

  // How far the triangle reaches out of the volume: the largest distance of its corners from it, in metres;
  // zero if it is contained. As exact as the volume is.
  double overshoot(const Triangle& t) const;

  // Signed distance from the boundary in metres: negative inside, positive outside. Outside it is exact
  // beside the volume and beyond its ends, and a lower bound near the edges of the ends.
  double signed_distance(const Vec3& p) const;

  // By how many metres the signed distance changes at most over a metre.
  double steepest() const { return 1 + std::max(glm::length(from_tilt_), glm::length(to_tilt_)); }

  double radius() const { return radius_; }
  // Whether the beam tilts. touches() may then hold for a triangle slightly outside the volume that the
  // distances refer to.
  bool tilts() const { return tilts_; }

  // This sweep with another radius. Precondition: radius >= 0.
  SweptCylinder with_radius(double radius) const {
    assert(radius >= 0);
    SweptCylinder other = *this;
    other.radius_ = radius;
    return other;
  }

  // An oriented box that contains the part of the volume whose depth lies in `depths`, for culling. Its axes
  // are `axis` (the beam), `along` (the motion) and `across`; intervals are measured from `origin`, that of
  // the first pose.
  struct Slab {
    Vec3 axis, along, across, origin;
    Interval depth, motion, lateral;
  };
  Slab slab(Interval depths) const;

 private:
  // A point relative to the beam: its offset from the axis at the start and at the end of the motion, and its
  // depth along the axis at the start.
  struct Seen {
    Vec2 start, end;
    double depth;
  };
  Seen see(const Vec3& p) const;
  template <typename Measure>
  double least_over_motion(const Seen& seen, Measure measure) const;
  Interval depth_touched() const;
  Interval depth_contained() const;

  Vec3 from_origin_, to_origin_;
  Vec3 axis_, along_, across_;
  Vec2 from_tilt_{0}, to_tilt_{0};  // drift across the axis per metre of depth
  double shift_ = 0;                // how far the origin moves along the axis
  double radius_ = 0;
  Interval range_;
  bool tilts_ = false;
};

}  // namespace kerf
