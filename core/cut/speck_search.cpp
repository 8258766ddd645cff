#include "core/cut/speck_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerances.h"
#include "core/cut/rim_state.h"

namespace kerf {

SpeckSearch::SpeckSearch(const SweptDistance& distance, std::span<const RimSide> sides)
    : distance_(distance) {
  for (const RimSide& s : sides) at_rim_.insert(at_rim_.end(), {s.from, s.to});
  std::sort(at_rim_.begin(), at_rim_.end());
}

void SpeckSearch::append(RimState& rim, FaceId start, std::vector<FaceId>& specks) const {
  constexpr size_t kMostFaces = 64;
  std::vector<FaceId> part{start}, neighbours;
  for (size_t i = 0; i < part.size(); ++i) {
    if (part.size() > kMostFaces || !lies_along(rim, part[i])) return;
    neighbours.clear();
    rim.mesh().append_nearest_neighbours(part[i], neighbours);
    for (const FaceId n : neighbours) {
      if (std::find(part.begin(), part.end(), n) == part.end()) part.push_back(n);
    }
  }
  specks.insert(specks.end(), part.begin(), part.end());
}

bool SpeckSearch::lies_along(RimState& rim, FaceId f) const {
  const double most = kRimNear * rim.radius();
  const auto corners = rim.mesh().corners(f);
  const Triangle t = rim.mesh().triangle(f);
  const auto is_near = [&](const Vec3& p) { return std::abs(distance_(p)) <= most; };
  for (size_t i = 0; i < 3; ++i) {
    if (std::binary_search(at_rim_.begin(), at_rim_.end(), corners[i])) continue;
    const bool is_known = rim.region.is_near(f);  // what is far away needs no further look
    if ((is_known && std::abs(rim.distance(corners[i], f)) > 2 * most) || !is_near(t[i])) return false;
  }
  const Vec3 between[] = {0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]),
                          (t[0] + t[1] + t[2]) / 3.0};
  return std::all_of(std::begin(between), std::end(between), is_near);
}

}  // namespace kerf
