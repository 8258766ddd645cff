#include "core/mesh/orient.h"

#include <cassert>

#include "core/base/tolerances.h"
#include "core/mesh/enclosed_patches.h"
#include "core/mesh/patches.h"

namespace kerf {

namespace {

class Orienter {
 public:
  Orienter(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
           const Progress* progress)
      : triangles_(triangles),
        edges_(edges),
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
    const auto sides = edges_.sides_of(edges_.edge_of[side]);
    if (sides.size() != 2) return;
    const uint32_t other = sides[0] == side ? sides[1] : sides[0];
    const uint32_t t = side / 3, n = other / 3;
    if (seen_[n]) return;
    seen_[n] = true;
    const bool same_way = triangles_[t][side % 3] == triangles_[n][other % 3];
    turned_[n] = turned_[t] != same_way;
    front_.push_back(n);
  }

  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const SoupEdges& edges_;
  Pace pace_;
  std::vector<bool> turned_;
  std::vector<bool> seen_;
  std::vector<uint32_t> front_;
};

// Whether the signed volume of a closed patch is negative. The terms are bounded by the edges that enter, so
// that a patch without volume, whose sum is nothing but rounding, does not count.
bool faces_inward(std::span<const Vec3> positions, const std::vector<std::array<uint32_t, 3>>& triangles,
                  std::span<const uint32_t> patch) {
  const Vec3& apex = positions[triangles[patch[0]][0]];
  double volume = 0, bound = 0;  // both times six
  for (const uint32_t t : patch) {
    const auto& [a, b, c] = triangles[t];
    const Vec3 ab = positions[b] - positions[a], ac = positions[c] - positions[a], up = positions[a] - apex;
    volume += glm::dot(up, glm::cross(ab, ac));
    bound += glm::length(up) * glm::length(ab) * glm::length(ac);
  }
  return volume < -kLeastVolume * bound;
}

}  // namespace

Result<std::vector<bool>> triangles_to_turn(const std::vector<std::array<uint32_t, 3>>& triangles,
                                            const SoupEdges& edges, const Progress* progress) {
  assert(edges.edge_of.size() == 3 * triangles.size());
  return Orienter(triangles, edges, progress).run();
}

Result<std::vector<bool>> inward_triangles(std::span<const Vec3> positions,
                                           const std::vector<std::array<uint32_t, 3>>& triangles,
                                           const SoupEdges& edges, const Progress* progress) {
  const auto patches = find_patches(triangles, edges, progress);
  if (!patches) return patches.error();
  std::vector<uint32_t> inward;
  for (uint32_t p = 0; p < patches->count(); ++p) {
    if (patches->closed[p] && faces_inward(positions, triangles, patches->triangles_of(p)))
      inward.push_back(p);
  }
  const std::vector<bool> enclosed = find_enclosed(positions, triangles, *patches, inward);
  std::vector<bool> found(triangles.size());
  for (size_t i = 0; i < inward.size(); ++i) {
    if (enclosed[i]) continue;
    for (const uint32_t t : patches->triangles_of(inward[i])) found[t] = true;
  }
  return found;
}

}  // namespace kerf
