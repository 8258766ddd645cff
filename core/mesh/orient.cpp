#include "core/mesh/orient.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/enclosed_patches.h"

namespace kerf {

namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

// Whether the two triangles on every edge of exactly two traverse it in opposite directions.
bool is_consistent(const Triangles& triangles, const SoupEdges& edges) {
  constexpr size_t kEdges = 1 << 16;  // a range
  std::vector<uint8_t> differs(range_count(edges.count(), kEdges));
  const auto tail = [&](uint32_t side) { return triangles[side / 3][side % 3]; };
  for_each_range(edges.count(), kEdges, [&](size_t e, size_t end) {
    uint8_t& found = differs[e / kEdges];
    for (; e < end && !found; ++e) {
      const auto sides = edges.sides_of(static_cast<uint32_t>(e));
      found = sides.size() == 2 && tail(sides[0]) == tail(sides[1]);
    }
  });
  return std::none_of(differs.begin(), differs.end(), [](uint8_t found) { return found != 0; });
}

class Orienter {
 public:
  Orienter(const Triangles& triangles, const SoupEdges& edges, const Progress* progress)
      : triangles_(triangles),
        edges_(edges),
        edge_of_(edges_of_sides(edges)),
        pace_(progress, triangles.size()),
        turned_(triangles.size()),
        seen_(triangles.size()) {}

  Result<std::vector<bool>> run() {
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!seen_[t] && !orient_from(t)) return cancelled();
    }
    return std::move(turned_);
  }

 private:
  // Returns false if it was stopped.
  bool orient_from(uint32_t seed) {
    front_.assign(1, seed);
    seen_[seed] = true;
    size_t turned = 0;
    for (size_t i = 0; i < front_.size(); ++i) {
      if (!pace_.step()) return false;
      const uint32_t t = front_[i];
      turned += turned_[t];
      for (uint32_t side = 3 * t; side < 3 * t + 3; ++side) visit_across(side);
    }
    if (2 * turned > front_.size()) {
      for (const uint32_t t : front_) turned_[t] = !turned_[t];
    }
    return true;
  }

  void visit_across(uint32_t side) {
    const auto sides = edges_.sides_of(edge_of_[side]);
    if (sides.size() != 2) return;
    const uint32_t other = sides[0] == side ? sides[1] : sides[0];
    const uint32_t t = side / 3, n = other / 3;
    if (seen_[n]) return;
    seen_[n] = true;
    const bool same_way = triangles_[t][side % 3] == triangles_[n][other % 3];
    turned_[n] = turned_[t] != same_way;
    front_.push_back(n);
  }

  const Triangles& triangles_;
  const SoupEdges& edges_;
  const std::vector<uint32_t> edge_of_;
  Pace pace_;
  std::vector<bool> turned_;
  std::vector<bool> seen_;
  std::vector<uint32_t> front_;
};

// Six times the signed volume of the tetrahedra over some triangles of a patch, and a bound of its terms.
struct Volume {
  double sum = 0, bound = 0;

  void add(const Vec3& apex, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, up = a - apex;
    sum += glm::dot(up, glm::cross(ab, ac));
    bound += glm::length(up) * glm::length(ab) * glm::length(ac);
  }
};

// The sign of the signed volume of a closed patch. The terms are bounded by the edges that enter, so that a
// patch without volume, whose sum is nothing but rounding, has the sign 0.
int sign_of_volume(std::span<const Vec3> positions, const Triangles& triangles,
                   std::span<const uint32_t> patch) {
  constexpr size_t kTriangles = 1 << 16;  // a range
  const Vec3& apex = positions[triangles[patch[0]][0]];
  std::vector<Volume> parts(range_count(patch.size(), kTriangles));
  for_each_range(patch.size(), kTriangles, [&](size_t i, size_t end) {
    Volume volume;
    for (const uint32_t t : patch.subspan(i, end - i)) {
      const auto& [a, b, c] = triangles[t];
      volume.add(apex, positions[a], positions[b], positions[c]);
    }
    parts[i / kTriangles] = volume;
  });
  Volume whole;
  for (const Volume& part : parts) whole = {whole.sum + part.sum, whole.bound + part.bound};
  if (whole.sum < -kLeastVolume * whole.bound) return -1;
  return whole.sum > kLeastVolume * whole.bound ? 1 : 0;
}

}  // namespace

Result<std::vector<bool>> triangles_to_turn(const Triangles& triangles, const SoupEdges& edges,
                                            const Progress* progress) {
  KERF_ASSERT(edges.triangles() == triangles.size());
  if (is_consistent(triangles, edges)) return std::vector<bool>(triangles.size());
  return Orienter(triangles, edges, progress).run();
}

std::vector<bool> inward_triangles(std::span<const Vec3> positions, const Triangles& triangles,
                                   const Patches& patches) {
  std::vector<uint32_t> inward;
  for (uint32_t p = 0; p < patches.count(); ++p) {
    if (patches.closed[p] && sign_of_volume(positions, triangles, patches.triangles_of(p)) < 0)
      inward.push_back(p);
  }
  std::vector<bool> found(triangles.size());
  if (inward.empty()) return found;
  const std::vector<bool> enclosed = find_enclosed(positions, triangles, patches, inward);
  for (size_t i = 0; i < inward.size(); ++i) {
    if (enclosed[i]) continue;
    for (const uint32_t t : patches.triangles_of(inward[i])) found[t] = true;
  }
  return found;
}

std::vector<uint32_t> overlapping_patches(std::span<const Vec3> positions, const Triangles& triangles,
                                          const Patches& patches) {
  constexpr uint32_t kRays = 4;  // so that parts that touch the wall of a hole do not count as being in it
  std::vector<uint32_t> shells, overlapping;
  for (uint32_t p = 0; p < patches.count(); ++p) {
    if (patches.closed[p]) shells.push_back(p);
  }
  if (shells.size() < 2) return {};
  const std::vector<uint32_t> around = count_enclosing(positions, triangles, patches, shells, kRays);
  for (size_t i = 0; i < shells.size(); ++i) {
    if (around[i] == 0) continue;
    const int sign = sign_of_volume(positions, triangles, patches.triangles_of(shells[i]));
    if (sign == (around[i] % 2 == 0 ? -1 : 1)) overlapping.push_back(shells[i]);
  }
  return overlapping;
}

}  // namespace kerf
