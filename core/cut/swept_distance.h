#pragma once

#include <span>
#include <vector>

#include "core/cut/stroke_region.h"
#include "core/laser/laser.h"

namespace kerf {

// The signed distance from the boundary of all that a stroke has swept, anywhere and not only near a face as
// in StrokeRegion. Moves that follow each other are halved again and again to a tree, so that a query asks
// those that are near alone.
class SweptDistance {
 public:
  // Precondition: part i of the region is what moves[i] sweeps, in one frame. O(n log n).
  SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves);

  // Negative inside, positive outside; the least of the distances from the parts, to the bit (m).
  double operator()(const Vec3& p) const;

 private:
  // Parts first .. end - 1. All their axes lie within `aside` metres of the line from `origin` along
  // `direction` at the origin, and within `apart` metres more for each metre from there.
  struct Node {
    size_t first, end;
    Vec3 origin, direction;
    double aside = 0, apart = 0;
    uint32_t halves = 0;  // the index of the first half, before that of the second one; 0 for a leaf
  };
  void bound(uint32_t node, std::span<const BeamMove> moves);
  double at_least(const Node& node, const Vec3& p) const;

  std::vector<SweptCylinder> parts_;
  std::vector<Node> nodes_;  // the root first
};

}  // namespace kerf
