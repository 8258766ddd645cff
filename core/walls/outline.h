#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/task.h"

namespace kerf {

// A disc that moves along a straight line in the plane.
struct DiscMove {
  Vec2 from{0}, to{0};  // centre [m]
};

// A piece of an outline: a line or an arc, part of one of the four sides of the region that a disc sweeps.
struct OutlinePiece {
  Vec2 from{0}, to{0};
  Vec2 centre{0};              // of an arc
  double radius = 0;           // of an arc, 0 for a line
  double angle = 0, turn = 0;  // of an arc: angle of `from` and turn, > 0 [rad]
  double length = 0;           // m
  uint32_t side = 0;  // 4 * move + 0 .. 3: right of the motion, around its end, left, around its start

  // Returns the point at this share of the length, 0 .. 1.
  Vec2 at(double share) const;
};

// A closed curve with the swept region on its left, so that outer curves run counter-clockwise.
struct OutlineCurve {
  std::vector<OutlinePiece> pieces;
  double length = 0;  // m
};

// Returns the boundary of the union of the regions swept by discs of one radius (m, > 0): the parts of each
// region's sides that no other region covers, joined into closed curves. Parts common to several regions
// belong to the first one. Features smaller than 1e-4 radii are lost. Returns no curve if the parts do not
// join into closed curves. O(n log n) for n moves along paths that bend slowly compared with the radius,
// regardless of the number of moves within a radius.
Task<std::vector<OutlineCurve>> outline_of(std::span<const DiscMove> moves, double radius);

// Returns the outline on a cylinder: positions whose y differ by `around` (m, > 0) are the same. Moves may
// pass all round, and several times. The y of consecutive pieces of a curve may differ by `around`.
Task<std::vector<OutlineCurve>> outline_around(std::span<const DiscMove> moves, double radius, double around);

}  // namespace kerf
