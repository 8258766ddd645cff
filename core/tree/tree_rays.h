#pragma once

#include <optional>
#include <span>

#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"
#include "core/tree/walks.h"

namespace kerf {

// Parallel rays made ready for a walk.
struct TreeRays {
  RayQuery query;
  double t_at_origin;   // t of the first ray's origin
  double t_per_length;  // of length along the ray

  // From which t on boxes and faces beyond this length along the first ray need not be looked at.
  float t_beyond(double length) const;
};

// One to four rays of equal direction, within the range. Nothing if they pass the tree by.
std::optional<TreeRays> prepare_rays(const TreeStore& tree, std::span<const Pose> rays, Interval range);

}  // namespace kerf
