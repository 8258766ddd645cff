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

// The axes of a moving beam if all of them are parallel or pass through one point, the apex. A plane across
// their middle direction intersects the swept volume in regions swept by a disc. With an apex this is an
// approximation: the section of a beam inclined to the middle direction is an ellipse.
class BeamPencil {
 public:
  // Returns the pencil of the moves of a beam of this radius (m); nullopt if the lines are neither parallel
  // nor meet within 1e-3 radii, or one is inclined by more than 72 degrees. The moves and everything below
  // are in one frame. Precondition: there is a move.
  static std::optional<BeamPencil> of(std::span<const BeamMove> moves, double radius);

  bool parallel() const { return parallel_; }

  // A point in the coordinates of the pencil: its depth along the middle direction (m, from the apex, or from
  // the origin of the first beam), and its position in the plane across that direction at this depth (m).
  struct Seen {
    Vec2 place;
    double depth;
  };
  Seen see(const Vec3& p) const;
  Vec3 point(Vec2 place, double depth) const;

  // Returns the motion of the beam's axis in the plane at this depth.
  DiscMove at_depth(const BeamMove& move, double depth) const;

  // Returns the ratio of the longest ellipse in that plane to the disc, >= 1.
  double longest_ellipse(std::span<const BeamMove> moves) const;

  const Vec3& axis() const { return axis_; }

 private:
  bool parallel_ = false;
  Vec3 origin_{0};  // the apex, or the origin of the first beam
  Vec3 axis_{0}, right_{0}, up_{0};
};

// Coordinates on the side of the volume that a beam has swept: the closed curve of its outline, the place
// around that curve, and the depth.
//
// For parallel beams the outline is the same at all depths, and the place is the length along it. For beams
// through an apex the outline is computed at several depths; sides that are part of all these outlines are
// landmarks with integer places, and between two landmarks the place is interpolated by length. The map is
// then exact only at these depths, and serves to locate points relative to each other.
class WallChart {
 public:
  // Makes the chart for depths within `depths` (m, of the pencil). Returns nullopt if the outlines at
  // different depths do not correspond: curves longer than a radius appear or disappear, or have no common
  // side. Preconditions: radius > 0; `pencil` and `moves` outlive the task.
  static Task<std::optional<WallChart>> make(const BeamPencil& pencil, std::span<const BeamMove> moves,
                                             double radius, Interval depths);

  struct Place {
    uint32_t curve = 0;
    double around = 0;  // 0 .. period(curve)
    double depth = 0;   // m
  };
  bool parallel() const { return pencil_.parallel(); }
  size_t curves() const { return slices_.front().curves.size(); }
  double period(uint32_t curve) const { return slices_.front().curves[curve].period; }

  // Returns the place nearest to a point; nullopt if it is more than `reach` metres from the side. Culls
  // groups of consecutive pieces: O(pieces / 16).
  std::optional<Place> place_of(const Vec3& p, double reach) const;
  // Returns the point at a place; `around` may lie outside the period.
  Vec3 point_at(const Place& place) const;

  // Returns the places around a curve, at the first depth, at which pieces of the outline meet, and places on
  // arcs at most `turn` radians apart; ascending.
  std::vector<double> corners(uint32_t curve, double turn) const;

 private:
  static constexpr size_t kTogether = 16;

  struct Box {
    Vec2 low, high;
  };
  struct Curve {
    OutlineCurve outline;
    std::vector<double> starts;  // by piece: length along the curve, followed by the total length
    // Landmarks: the length along the curve at the first one, and the lengths from it to each, ascending.
    // Without landmarks, places are lengths.
    double first_mark = 0;
    std::vector<double> marks;
    double period = 0;
    std::vector<Box> boxes;  // of each kTogether consecutive pieces

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
  // Returns the slice below a depth, and the share of the way to the next one.
  std::pair<size_t, double> slice_below(double depth) const;

  BeamPencil pencil_;
  std::vector<Slice> slices_;  // by depth
};

// Depths of the ends of the range (m, of the pencil); nullopt if moves differ, as with an apex.
struct RangeEnds {
  std::optional<double> low, high;
};
// Precondition: there is a move, and radius > 0.
RangeEnds range_ends(const BeamPencil& pencil, std::span<const BeamMove> moves, Interval range,
                     double radius);

// Parts of the boundary of the swept volume.
enum class BoundaryPart { kSide, kLowEnd, kHighEnd };

// The distances of a rim vertex from the sides and from the nearer end of the beam (m). `end`: the nearer
// end, or kSide if none is within reach. `place`: the nearest place on the sides, if within reach.
struct NearBoundary {
  std::optional<WallChart::Place> place;
  double from_side = std::numeric_limits<double>::infinity();
  double from_end = std::numeric_limits<double>::infinity();
  BoundaryPart end = BoundaryPart::kSide;
};
// `depth` is that of the point. Precondition: reach > 0, in metres.
NearBoundary near_boundary(const WallChart& chart, const RangeEnds& ends, const Vec3& p, double depth,
                           double reach);

// Returns the part along which an edge of the rim runs, or nullopt. If an edge leads from a side to an end,
// the vertex nearer to the corner between them belongs to both parts.
std::optional<BoundaryPart> part_along(const NearBoundary& a, const NearBoundary& b);

}  // namespace kerf
