#pragma once

#include <optional>
#include <span>

#include "core/laser/laser.h"
#include "core/walls/outline.h"

namespace kerf {

// The lines on which the axes of a moving beam lie, where all of them are parallel or go through one point,
// the apex. Planes across their middle direction cut the volume that the beam sweeps in regions swept by a
// disc; for an apex nearly so, since a beam that is inclined against the middle direction is cut in an
// ellipse.
class BeamPencil {
 public:
  // The pencil of some moves of a beam of this radius (m); nothing where the lines are neither parallel nor
  // meet within 1e-3 radii, or one is inclined by more than 72 degrees. The moves and everything below are in
  // one frame. Precondition: there is a move.
  static std::optional<BeamPencil> of(std::span<const BeamMove> moves, double radius);

  bool parallel() const { return parallel_; }

  // A point, as its depth along the middle direction (m, from the apex, or from the origin of the first
  // beam) and its place in the plane across that direction at this depth (m).
  struct Seen {
    Vec2 place;
    double depth;
  };
  Seen see(const Vec3& p) const;
  Vec3 point(Vec2 place, double depth) const;

  // Where the axis of the beam moves in the plane at this depth.
  DiscMove at_depth(const BeamMove& move, double depth) const;

  // By how much the longest of the ellipses in that plane is longer than the disc, 1 or more.
  double longest_ellipse(std::span<const BeamMove> moves) const;

  const Vec3& axis() const { return axis_; }

 private:
  bool parallel_ = false;
  Vec3 origin_{0};  // the apex, or the origin of the first beam
  Vec3 axis_{0}, right_{0}, up_{0};
};

}  // namespace kerf
