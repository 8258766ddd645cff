#pragma once

#include <algorithm>
#include <cassert>

#include "core/base/geometry.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The volume that a cylinder with flat ends sweeps between two poses. At each pose the cylinder holds all
// points within the radius of its axis whose depth along the axis lies in the range. The origin moves on a
// straight line, and the direction turns uniformly. The volume is exact for a translation across the axis.
// Where the ends of the range move along the axis, touches() uses the depths of the whole motion at each
// pose, and contains() those common to all. For a tilting cylinder, the corners of a triangle are assumed to
// move on straight lines in the plane across the beam; the error is proportional to the squared angle, so
// that large turns must be subdivided.
//
// All arguments are in one frame, in metres. The radius may be zero: a ray, or the strip that it sweeps.
class SweptCylinder {
 public:
  // Preconditions: both directions are unit vectors and not opposite to each other, radius >= 0.
  SweptCylinder(const Pose& from, const Pose& to, double radius, Interval range);

  // Returns true if the closed triangle meets the closed volume.
  bool touches(const Triangle& t) const { return touches(t, radius_); }
  bool touches(const Triangle& t, double radius) const;

  // Returns true if the triangle lies entirely within the volume; always false for a radius of zero.
  bool contains(const Triangle& t) const;

  // Returns the largest distance of the triangle's corners from the volume [m], 0 if it is contained.
  double overshoot(const Triangle& t) const;

  // Returns the signed distance from the boundary [m], negative inside. Outside it is exact next to the
  // lateral surface and beyond the ends, and a lower bound near the edges of the ends.
  double signed_distance(const Vec3& p) const;

  // Returns a Lipschitz constant of the signed distance.
  double steepest() const { return steepest_; }

  double radius() const { return radius_; }
  Interval range() const { return range_; }
  // Returns true if touches() of this triangle refers to the same volume as the distances. If the beam tilts,
  // or if the ends of its range pass the triangle, touches() may return true slightly outside that volume, or
  // where the range has not reached or has left the triangle.
  bool touches_exactly(const Triangle& t) const;

  // Returns this sweep with another radius. Precondition: radius >= 0.
  SweptCylinder with_radius(double radius) const {
    assert(radius >= 0);
    SweptCylinder other = *this;
    other.radius_ = radius;
    return other;
  }

  // An oriented box around the part of the volume whose depth lies in `depths`, for culling. Its axes are
  // `axis` (the beam), `along` (the motion) and `across`; intervals are relative to `origin`, the origin of
  // the first pose.
  struct Slab {
    Vec3 axis, along, across, origin;
    Interval depth, motion, lateral;
  };
  Slab slab(Interval depths) const;

 private:
  // A point in the frame of the beam: its offsets from the axis at the start and at the end of the motion,
  // and its depth along the axis at the start.
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
  double shift_ = 0;                // displacement of the origin along the axis [m]
  double radius_ = 0;
  double steepest_ = 1;
  Interval range_;
  bool tilts_ = false;
};

}  // namespace kerf
