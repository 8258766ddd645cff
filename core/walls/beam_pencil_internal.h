#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/laser/laser.h"
#include "core/walls/outline.h"

namespace kerf {

// The axes of a moving beam as lines across a family of surfaces. These intersect the swept volume in regions
// swept by a disc; unless the lines are parallel this is an approximation, because the section of an inclined
// beam is an ellipse.
class BeamPencil {
 public:
  enum class Kind {
    kParallel,
    kApex,     // the lines pass through one point, the apex
    kTurning,  // the lines are perpendicular to an axis; the surfaces are the cylinders round it
    kRuled,    // any lines
  };

  // Returns the pencils of the moves of a beam of this radius (m), the most exact one first: the parallel one
  // alone, or those that hold of an apex within 1e-3 radii, turning, and ruled. The surfaces are planes
  // across the middle direction, to which no line may be inclined by more than 72 degrees, except for turning
  // beams. The moves and everything below are in one frame. Precondition: there is a move.
  static std::vector<BeamPencil> all_of(std::span<const BeamMove> moves, double radius);

  Kind kind() const { return kind_; }
  bool parallel() const { return kind_ == Kind::kParallel; }

  // A point in the coordinates of the pencil: its depth along the middle direction (m, from the apex, or from
  // the origin of the first beam), and its position in the plane across that direction at this depth (m). For
  // turning beams the depth is the negative distance from the axis, and the position is that along the axis,
  // and the length of the arc round it.
  struct Seen {
    Vec2 place;
    double depth;
  };
  Seen see(const Vec3& p) const;
  Vec3 point(Vec2 place, double depth) const;
  // Returns the length round the axis at a depth of turning beams [m]; 0 for others.
  double around(double depth) const;

  // An axis of the beam meets a cylinder twice: where it enters and where it leaves. Other surfaces count as
  // entered.
  struct Hit {
    uint32_t move;
    bool leaves;
  };
  // Returns the hits within the range at a depth, in the order of the moves, first those that enter.
  std::vector<Hit> hits(std::span<const BeamMove> moves, Interval range, double depth) const;
  // Returns the motions of the beam's axis at the hits in the surface at a depth. Those of turning beams are
  // continuous, i.e. their arcs may be longer than the way round. Returns nullopt if the surface does not
  // cross all axes, or at a flat angle.
  std::optional<std::vector<DiscMove>> at_depth(std::span<const BeamMove> moves, std::span<const Hit> hits,
                                                double depth) const;

  // Returns the ratio of the longest ellipse in the surface at a depth to the disc, >= 1.
  double longest_ellipse(std::span<const BeamMove> moves, double depth) const;

  const Vec3& axis() const { return axis_; }

 private:
  static std::optional<BeamPencil> parallel(std::span<const BeamMove> moves);
  static std::optional<BeamPencil> through_apex(std::span<const BeamMove> moves, double radius);
  static std::optional<BeamPencil> turning(std::span<const BeamMove> moves);
  static std::optional<BeamPencil> ruled(std::span<const BeamMove> moves);
  static BeamPencil across_middle(std::span<const BeamMove> moves);
  std::optional<Vec2> centre(const Pose& pose, bool leaves, double depth) const;
  double offset(const Pose& pose) const;

  Kind kind_ = Kind::kParallel;
  Vec3 origin_{0};  // the apex, the origin of the first beam, or a point of the axis of turning beams
  Vec3 axis_{0};    // the middle direction, or the axis of turning beams
  Vec3 right_{0}, up_{0};
};

}  // namespace kerf
