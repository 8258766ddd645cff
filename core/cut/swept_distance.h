#pragma once

#include <span>
#include <vector>

#include "core/cut/stroke_region.h"
#include "core/laser/laser.h"

namespace kerf {

// The signed distance from the boundary of all that a stroke has swept, anywhere and not only near a face as
// in StrokeRegion. Moves that follow each other are taken together where they are far away, so that a query
// costs about a sixteenth of what asking each of them would.
class SweptDistance {
 public:
  // Precondition: part i of the region is what moves[i] sweeps, in one frame. Both must outlive this object.
  SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves);

  // Negative inside, positive outside; the least of the distances from the parts, to the bit (m).
  double operator()(const Vec3& p) const;

 private:
  // Parts first .. end - 1. All their axes lie within `aside` metres of the line from `origin` along
  // `direction` at the origin, and within `apart` metres more for each metre from there.
  struct Group {
    size_t first, end;
    Vec3 origin, direction;
    double aside, apart;
  };
  double at_least(const Group& group, const Vec3& p) const;
  double least_of(const Group& group, const Vec3& p) const;

  const StrokeRegion& region_;
  std::vector<Group> groups_;
};

}  // namespace kerf
