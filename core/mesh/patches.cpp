#include "core/mesh/patches.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/base/union_find.h"

namespace kerf {

namespace {

class PatchFinder {
 public:
  PatchFinder(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
              const Progress* progress)
      : triangles_(triangles), edges_(edges), progress_(progress), patch_of_(patches_.patch_of) {
    patch_of_.resize(triangles.size());
  }

  Result<Patches> run() {
    ProgressShares shares(progress_);
    const Progress numbering = shares.next(0.7), closing = shares.next(0.3);
    if (!number_patches(numbering)) return cancelled();
    group_triangles();
    if (!find_closed(closing)) return cancelled();
    return std::move(patches_);
  }

 private:
  // This and find_closed return false if the search was stopped.
  bool number_patches(const Progress& progress) {
    Pace pace(&progress, edges_.count() + triangles_.size());
    UnionFind sets(triangles_.size());
    for (uint32_t e = 0; e < edges_.count(); ++e) {
      if (!pace.step()) return false;
      const auto sides = edges_.sides_of(e);
      if (sides.size() == 2) sets.unite(sides[0] / 3, sides[1] / 3);
    }
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!pace.step()) return false;
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

  bool find_closed(const Progress& progress) {
    constexpr size_t kEdges = 1 << 16;  // a range
    std::vector<std::vector<uint32_t>> open(range_count(edges_.count(), kEdges));
    const auto look = [&](size_t e, size_t end) {
      std::vector<uint32_t>& found = open[e / kEdges];
      for (; e < end; ++e) append_unbalanced(edges_.sides_of(static_cast<uint32_t>(e)), found);
    };
    if (!for_each_range(edges_.count(), kEdges, &progress, look)) return false;
    patches_.closed.assign(patch_count_, true);
    for (const auto& found : open) {
      for (const uint32_t patch : found) patches_.closed[patch] = false;
    }
    return true;
  }

  // Appends those patches that traverse an edge more often one way than the other.
  void append_unbalanced(std::span<const uint32_t> sides, std::vector<uint32_t>& found) const {
    const auto note = [&](uint32_t patch) {
      if (found.empty() || found.back() != patch) found.push_back(patch);
    };
    if (sides.size() == 1) return note(patch_of_[sides[0] / 3]);
    if (sides.size() == 2) {
      if (goes_up(sides[0]) == goes_up(sides[1])) note(patch_of_[sides[0] / 3]);
      return;
    }
    std::vector<std::pair<uint32_t, int>> around;  // patch and direction of each side
    for (const uint32_t s : sides) around.push_back({patch_of_[s / 3], goes_up(s) ? 1 : -1});
    std::sort(around.begin(), around.end());
    for (size_t begin = 0, end = 0; begin < around.size(); begin = end) {
      int balance = 0;
      for (; end < around.size() && around[end].first == around[begin].first; ++end)
        balance += around[end].second;
      if (balance != 0) note(around[begin].first);
    }
  }

  bool goes_up(uint32_t side) const {
    const auto& t = triangles_[side / 3];
    return t[side % 3] < t[(side % 3 + 1) % 3];
  }

  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const SoupEdges& edges_;
  const Progress* progress_;
  Patches patches_;
  std::vector<uint32_t>& patch_of_;
  uint32_t patch_count_ = 0;
};

}  // namespace

Result<Patches> find_patches(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
                             const Progress* progress) {
  KERF_ASSERT(edges.triangles() == triangles.size());
  return PatchFinder(triangles, edges, progress).run();
}

size_t count_components(const Patches& patches, const SoupEdges& edges) {
  size_t components = patches.count();
  if (components == 1) return 1;
  UnionFind sets(patches.count());
  for (uint32_t e = 0; e < edges.count(); ++e) {
    const auto sides = edges.sides_of(e);
    if (sides.size() < 3) continue;
    for (const uint32_t side : sides)
      components -= sets.unite(patches.patch_of[sides[0] / 3], patches.patch_of[side / 3]);
  }
  return components;
}

}  // namespace kerf
