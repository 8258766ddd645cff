#pragma once

#include <span>

#include "core/tree/sheared_ray.h"
#include "core/tree/tree_store.h"
#include "core/tree/walks.h"

namespace kerf {

// Makes parallel rays ready for a walk: one to four rays of equal direction, within the range; `sheared` is
// the first of them. False if they pass the tree by.
bool prepare_rays(const TreeStore& tree, std::span<const Pose> rays, const ShearedRay& sheared,
                  Interval range, RayQuery& out);

}  // namespace kerf
