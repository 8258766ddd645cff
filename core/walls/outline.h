#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/task.h"

namespace kerf {

// A disc that moves on a straight line in the plane.
struct DiscMove {
  Vec2 from{0}, to{0};  // m, of its centre
};

// A part of an outline: a part of one of the four sides of the region that a disc sweeps, which is a line or
// an arc.
struct OutlinePiece {
  Vec2 from{0}, to{0};
  Vec2 centre{0};              // of an arc
  double radius = 0;           // of an arc, 0 for a line
  double angle = 0, turn = 0;  // of an arc: that of `from`, and by how much it turns, > 0 (radians)
  double length = 0;           // m
  uint32_t side = 0;  // 4 * move + 0 .. 3: right of the motion, around its end, left, around its start

  // The point at this share of the length, 0 .. 1.
  Vec2 at(double share) const;
};

// A closed curve. The swept region lies on its left, so that outer ones run counter-clockwise.
struct OutlineCurve {
  std::vector<OutlinePiece> pieces;
  double length = 0;  // m
};

// The boundary of the union of the regions that discs of one radius (m, > 0) sweep: of each side of each
// region, what no other region covers, chained to closed curves. What several of them have in common belongs
// to the first one. Features smaller than 1e-4 radii are lost. Returns no curve where the chain does not
// close. O(n log n) for n moves along paths that bend slowly compared with the radius, however many of them
// lie within it.
Resumable<std::vector<OutlineCurve>> outline_of(std::span<const DiscMove> moves, double radius);

}  // namespace kerf
