#pragma once

#include <span>
#include <vector>

#include "core/cut/swept_distance.h"
#include "core/walls/make_walls.h"

namespace kerf {

struct RimState;

// Finds connected parts of a few faces that lie along the boundary of what was swept everywhere. With walls
// they would enclose next to nothing.
class SpeckSearch {
 public:
  // The sides are all along the rim.
  SpeckSearch(const SweptDistance& distance, std::span<const RimSide> sides);

  // Appends the faces of the part of a face, if it is such a one.
  void append(RimState& rim, FaceId start, std::vector<FaceId>& specks) const;

 private:
  bool lies_along(RimState& rim, FaceId f) const;

  const SweptDistance& distance_;
  std::vector<VertexId> at_rim_;  // ascending, with repeats
};

}  // namespace kerf
