#pragma once

#include "core/base/interval.h"
#include "core/base/pose.h"
#include "core/base/vec3.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The volume that a cylinder passes through between two poses: all points nearer to its axis than the radius,
// at distances along the axis within the range. It moves on the straight line; between different directions
// it tilts evenly. Exact where it only translates. Where it tilts, a triangle's corners are taken to move
// straight in the plane across the beam, which errs in proportion to the square of the angle: keep steps
// small.
//
// All in one frame, metres. Ends are flat. The radius may be zero: a ray, or the strip that a moving ray
// passes.
class SweptCylinder {
 public:
  SweptCylinder(const Pose& from, const Pose& to, double radius, Interval range);

  // Whether the closed triangle meets the closed volume.
  bool touches(const Triangle& t) const;

  // Whether the triangle lies wholly within the volume; never for a radius of zero.
  bool contains(const Triangle& t) const;

  // How far the triangle reaches out of the volume: the largest distance of one of its points from it, zero
  // where contained. Of a volume that tilts, to the order in which it is exact.
  double overshoot(const Triangle& t) const;

  // Negative inside, positive outside, zero on the boundary of the volume; for points near it, and inside
  // everywhere, the distance from it in metres.
  double signed_distance(const Vec3& p) const;

  double radius() const { return radius_; }
  // Whether the beam tilts: then touches() may see a little more than the volume whose distances are told.
  bool tilts() const { return tilts_; }

  // The same volume with another radius.
  SweptCylinder with_radius(double radius) const {
    SweptCylinder other = *this;
    other.radius_ = radius;
    return other;
  }

  // A box in the coordinates that the volume has of itself: along `axis`, `along` (the motion) and `across`,
  // measured from from.origin. It holds the part of the volume whose depth lies in `depths`; a box for
  // culling.
  struct Slab {
    Vec3 axis, along, across, origin;
    Interval depth, motion, lateral;
  };
  Slab slab(Interval depths) const;

 private:
  // A point as the two ends of the motion see it: its offset from the axis at the start and at the end, and
  // its depth along the axis at the start.
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
