#include "core/mesh/patches.h"

#include <algorithm>
#include <cassert>

#include "core/base/union_find.h"

namespace kerf {

namespace {

class PatchFinder {
 public:
  PatchFinder(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
              const Progress* progress)
      : triangles_(triangles),
        edges_(edges),
        pace_(progress, 2 * edges.count() + triangles.size()),
        patch_of_(triangles.size()) {}

  Result<Patches> run() {
    if (!number_patches()) return cancelled();
    group_triangles();
    if (!find_closed()) return cancelled();
    return std::move(patches_);
  }

 private:
  // This and find_closed return false if the search was stopped.
  bool number_patches() {
    UnionFind sets(triangles_.size());
    for (uint32_t e = 0; e < edges_.count(); ++e) {
      if (!pace_.step()) return false;
      const auto sides = edges_.sides_of(e);
      if (sides.size() == 2) sets.unite(sides[0] / 3, sides[1] / 3);
    }
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!pace_.step()) return false;
      const uint32_t lowest = sets.find(t);
      patch_of_[t] = lowest == t ? patch_count_++ : patch_of_[lowest];
    }
    return true;
  }

  void group_triangles() {
    patches_.first.assign(patch_count_ + 1, 0);
    for (const uint32_t p : patch_of_) ++patches_.first[p + 1];
    for (size_t p = 0; p < patch_count_; ++p) patches_.first[p + 1] += patches_.first[p];
    std::vector<uint32_t> next(patches_.first.begin(), patches_.first.end() - 1);
    patches_.triangles.resize(triangles_.size());
    for (uint32_t t = 0; t < triangles_.size(); ++t) patches_.triangles[next[patch_of_[t]]++] = t;
  }

  bool find_closed() {
    patches_.closed.assign(patch_count_, true);
    for (uint32_t e = 0; e < edges_.count(); ++e) {
      if (!pace_.step()) return false;
      open_unbalanced(edges_.sides_of(e));
    }
    return true;
  }

  // Marks those patches as open that traverse an edge more often one way than the other.
  void open_unbalanced(std::span<const uint32_t> sides) {
    around_.clear();
    for (const uint32_t s : sides) around_.push_back({patch_of_[s / 3], goes_up(s) ? 1 : -1});
    std::sort(around_.begin(), around_.end());
    for (size_t begin = 0, end = 0; begin < around_.size(); begin = end) {
      int balance = 0;
      for (; end < around_.size() && around_[end].first == around_[begin].first; ++end)
        balance += around_[end].second;
      if (balance != 0) patches_.closed[around_[begin].first] = false;
    }
  }

  bool goes_up(uint32_t side) const {
    const auto& t = triangles_[side / 3];
    return t[side % 3] < t[(side % 3 + 1) % 3];
  }

  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const SoupEdges& edges_;
  Pace pace_;
  std::vector<uint32_t> patch_of_;
  uint32_t patch_count_ = 0;
  std::vector<std::pair<uint32_t, int>> around_;  // patch and direction of the sides of one edge
  Patches patches_;
};

}  // namespace

Result<Patches> find_patches(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
                             const Progress* progress) {
  assert(edges.edge_of.size() == 3 * triangles.size());
  return PatchFinder(triangles, edges, progress).run();
}

}  // namespace kerf
