#include <algorithm>
#include <iterator>

#include "core/base/tolerances.h"
#include "core/cut/chord_test.h"
#include "core/cut/rim_state.h"

namespace kerf {

namespace {

bool may_split(RimState& rim, FaceId f) {
  const double least = kRimLeastEdge * rim.radius();
  return rim.mesh().data(f).halvings < 2 * Resolution::kLargestDepth &&
         longest_edge2(rim.mesh().triangle(f)) > least * least;
}

bool fails(RimState& rim, FaceId f) {
  return chord_fails(rim.region, f, rim.mesh().triangle(f), rim.distances_of(f), kRimChord * rim.radius(),
                     kRimGraze * rim.radius());
}

}  // namespace

// The beam may be near either half of a green pair alone, and the faces that take the place of the pair need
// not lie within one half.
void split_near_rim(RimState& rim, FaceId f, std::vector<FaceId>& parts) {
  for (const Replacement& r : split_by_scheme(rim.step, rim.settings.resolution.scheme, f)) {
    const std::span<const FaceId> gone(r.gone.data(), r.gone_count), born(r.born.data(), r.born_count);
    const auto is_near = [&](FaceId g) { return rim.region.is_near(g); };
    if (std::none_of(gone.begin(), gone.end(), is_near)) continue;
    std::remove_copy_if(born.begin(), born.end(), std::back_inserter(rim.faces), is_near);
    parts.insert(parts.end(), born.begin(), born.end());
    rim.region.inherit(born, gone);
  }
}

Status refine_rim(RimState& rim) {
  std::vector<FaceId>& waiting = rim.work.waiting;
  for (size_t tests = 0; tests < faces_together() && !waiting.empty(); ++tests) {
    if (rim.mesh().live_faces() > rim.settings.most_faces) return too_many_faces(rim.settings);
    const FaceId f = waiting.back();
    waiting.pop_back();
    if (may_split(rim, f) && fails(rim, f)) split_near_rim(rim, f, waiting);
  }
  return Done{};
}

}  // namespace kerf
