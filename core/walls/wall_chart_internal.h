#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/task.h"
#include "core/laser/laser.h"
#include "core/walls/beam_pencil_internal.h"
#include "core/walls/outline.h"

namespace kerf {

// Coordinates on the side of the volume that a beam has swept: the closed curve of its outline, the place
// around that curve, and the depth.
//
// For parallel beams the outline is the same at all depths, and the place is the length along it. For other
// beams the outline is computed at several depths; sides that are part of all these outlines are
// landmarks with integer places, and between two landmarks the place is interpolated by length. The map is
// then exact only at these depths, and serves to locate points relative to each other.
class WallChart {
 public:
  // Makes the chart for depths within `depths` (m, of the pencil), and a range of the beam. Returns nullopt
  // if the outlines at different depths do not correspond: curves longer than a radius appear or disappear,
  // or have no common side. Preconditions: radius > 0; `pencil` and `moves` outlive the task.
  static Task<std::optional<WallChart>> make(const BeamPencil& pencil, std::span<const BeamMove> moves,
                                             double radius, Interval depths,
                                             Interval range = {0, std::numeric_limits<double>::infinity()});

  struct Place {
    uint32_t curve = 0;
    double around = 0;  // 0 .. period(curve)
    double depth = 0;   // m
  };
  bool parallel() const { return pencil_.parallel(); }
  bool has_apex() const { return pencil_.kind() == BeamPencil::Kind::kApex; }
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
  // The axes of the beam at a depth, for beams that turn, with boxes of each kTogether consecutive moves.
  struct Guides {
    std::vector<DiscMove> moves;
    std::vector<Box> boxes;
  };
  struct Slice {
    double depth = 0;
    double around = 0;  // see BeamPencil::around
    // Whole turns that lead from 0 .. around to all guides and pieces.
    double first_turn = 0, last_turn = 0;
    std::vector<Curve> curves;
    Guides guides{};
  };
  struct Near {
    uint32_t curve = 0;
    double place = 0;
  };

  explicit WallChart(const BeamPencil& pencil) : pencil_(pencil) {}
  Task<std::optional<Slice>> make_slice(std::span<const BeamMove> moves,
                                        std::span<const BeamPencil::Hit> hits, double radius,
                                        double depth) const;
  static Guides guides_of(std::vector<DiscMove> discs);
  static std::optional<Near> nearest(const Slice& slice, Vec2 p, double reach);
  static void nearest_to(const Slice& slice, Vec2 p, std::optional<Near>& found, double& best);
  // Returns the places in two slices to which the nearest axis of the beam leads from a point between them.
  std::pair<Vec2, Vec2> along_beam(const BeamPencil::Seen& seen, size_t below, double share) const;
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
