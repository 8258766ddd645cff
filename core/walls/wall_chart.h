#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/interval.h"
#include "core/base/resumable.h"
#include "core/walls/beam_pencil.h"
#include "core/walls/outline.h"

namespace kerf {

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

}  // namespace kerf
