#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/task.h"
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

// Coordinates on the side of the volume that a beam has swept: which closed curve of its outline, the place
// around that curve, and the depth.
//
// For parallel beams the outline is the same at all depths, and the place is the length along it. For beams
// through an apex the outline is computed at several depths; sides that are a part of all of these outlines
// are landmarks, at which the place is a whole number, and between two of them it is the share of the length.
// The map is then exact only at these depths and serves to tell where things lie relative to each other.
class WallChart {
 public:
  // The chart for depths within `depths` (m, of the pencil). Nothing where the outlines at different depths
  // do not correspond: curves longer than a radius come or go, or have no side in common. Preconditions:
  // radius > 0; pencil and moves live until it is made.
  static Resumable<std::optional<WallChart>> make(const BeamPencil& pencil, std::span<const BeamMove> moves,
                                                  double radius, Interval depths);

  struct Place {
    uint32_t curve = 0;
    double around = 0;  // 0 .. period(curve)
    double depth = 0;   // m
  };
  bool parallel() const { return pencil_.parallel(); }
  size_t curves() const { return slices_.front().curves.size(); }
  double period(uint32_t curve) const { return slices_.front().curves[curve].period; }

  // The place nearest to a point; nothing if it is farther than `reach` metres from the side. Pieces that
  // follow each other are taken together where they are farther: O(pieces / 16).
  std::optional<Place> place_of(const Vec3& p, double reach) const;
  // The point at a place; `around` may lie outside of the period.
  Vec3 point_at(const Place& place) const;

  // The places around a curve where one piece of the outline ends and the next one begins, and further ones
  // on arcs, at most `turn` radians apart; ascending. They are those at the first depth.
  std::vector<double> corners(uint32_t curve, double turn) const;

 private:
  static constexpr size_t kTogether = 16;

  struct Box {
    Vec2 low, high;
  };
  struct Curve {
    OutlineCurve outline;
    std::vector<double> starts;  // by piece: length along the curve, and that of the whole at the end
    // Of landmarks: the length along the curve at the first one, and from there to each, ascending. Places
    // are lengths where there are none.
    double first_mark = 0;
    std::vector<double> marks;
    double period = 0;
    std::vector<Box> boxes;  // of each kTogether pieces that follow each other

    void set_outline(OutlineCurve curve);
    double place(double length) const;
    double length(double place) const;
    Vec2 at(double place) const;
  };
  struct Slice {
    double depth = 0;
    std::vector<Curve> curves;
  };
  struct Near {
    uint32_t curve = 0;
    double place = 0;
  };

  explicit WallChart(const BeamPencil& pencil) : pencil_(pencil) {}
  static std::optional<Near> nearest(const Slice& slice, Vec2 p, double reach);
  static bool set_landmarks(std::vector<Slice>& slices);
  // The slice below a depth, and the share of the way to the next one.
  std::pair<size_t, double> slice_below(double depth) const;

  BeamPencil pencil_;
  std::vector<Slice> slices_;  // by depth
};

// The depths at which the range of a beam begins and ends (m, of the pencil), each nothing where it is not
// the same for all moves, as for beams through an apex.
struct RangeEnds {
  std::optional<double> low, high;
};
// Precondition: there is a move, and radius > 0.
RangeEnds range_ends(const BeamPencil& pencil, std::span<const BeamMove> moves, Interval range,
                     double radius);

// The parts of the boundary of what a beam has swept.
enum class BoundaryPart { kSide, kLowEnd, kHighEnd };

// How far a vertex of a rim is from the sides and from the nearer end (m), and which end that is: kSide if
// none is within reach. `place` is that on the sides, if they are within reach.
struct NearBoundary {
  std::optional<WallChart::Place> place;
  double from_side = std::numeric_limits<double>::infinity();
  double from_end = std::numeric_limits<double>::infinity();
  BoundaryPart end = BoundaryPart::kSide;
};
// `depth` is that of the point. Precondition: reach > 0, in metres.
NearBoundary near_boundary(const WallChart& chart, const RangeEnds& ends, const Vec3& p, double depth,
                           double reach);

// Which part an edge of the rim runs along. Of an edge that leads from a side to an end, the vertex that is
// nearer to the corner between them belongs to both parts. Nothing if the edge runs along none.
std::optional<BoundaryPart> part_along(const NearBoundary& a, const NearBoundary& b);

}  // namespace kerf
