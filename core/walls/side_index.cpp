#include "core/walls/side_index.h"

#include "core/base/assert.h"

namespace kerf {

SideIndex::SideIndex(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices)
    : first_(vertices + 1), sides_(3 * triangles.size()) {
  for (const auto& t : triangles) {
    for (const uint32_t v : t) {
      KERF_ASSERT(v < vertices);
      ++first_[v + 1];
    }
  }
  for (size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    for (uint32_t k = 0; k < 3; ++k) sides_[next[t[k]]++] = {t[(k + 1) % 3], i, k};
  }
}

const SideIndex::Side* SideIndex::find(uint32_t v, uint32_t to) const {
  for (const Side& s : from(v)) {
    if (s.to == to) return &s;
  }
  return nullptr;
}

const SideIndex::Side* SideIndex::find_repeated() const {
  for (uint32_t v = 0; v + 1 < first_.size(); ++v) {
    for (const Side& s : from(v)) {
      if (s.to == v || find(v, s.to) != &s) return &s;
    }
  }
  return nullptr;
}

}  // namespace kerf
