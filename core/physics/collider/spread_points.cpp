#include "core/physics/collider/spread_points.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"

namespace kerf {

void choose_spread(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& chosen) {
  if (points.empty()) return;
  std::vector<double> apart(points.size(), std::numeric_limits<double>::infinity());
  const auto measure_from = [&](uint32_t c) {
    KERF_ASSERT(c < points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3 d = points[i] - points[c];
      apart[i] = std::min(apart[i], glm::dot(d, d));
    }
  };
  for (uint32_t c : chosen) measure_from(c);
  while (chosen.size() < most) {
    const auto farthest = std::max_element(apart.begin(), apart.end());
    if (!(*farthest > 0)) return;
    chosen.push_back(static_cast<uint32_t>(farthest - apart.begin()));
    measure_from(chosen.back());
  }
}

void choose_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& chosen) {
  if (points.empty()) return;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (std::abs(x) + std::abs(y) + std::abs(z) == 2 || (x == 0 && y == 0 && z == 0)) continue;
        const Vec3 way(x, y, z);
        uint32_t best = 0;
        for (uint32_t i = 1; i < points.size(); ++i) {
          if (glm::dot(points[i], way) > glm::dot(points[best], way)) best = i;
        }
        if (std::find(chosen.begin(), chosen.end(), best) == chosen.end()) chosen.push_back(best);
      }
    }
  }
}

}  // namespace kerf
