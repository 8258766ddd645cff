#include "core/mesh/remesh/collapse_rules.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

void CollapseRules::look_at(uint32_t v, Ring& ring) {
  KERF_ASSERT(surface_.in_use(v));
  ring.sides.clear();
  ring.vertices.clear();
  ++stamp_;
  surface_.for_each_face(v, [&](const FlatSurface::Opposite& side) {
    ring.sides.push_back(side);
    for (const uint32_t w : {side.from, side.to}) {
      if (std::exchange(mark_[w], stamp_) != stamp_) ring.vertices.push_back(w);
    }
  });
}

bool CollapseRules::allows(uint32_t v, uint32_t to, const Ring& ring) {
  KERF_ASSERT(!sheets_.locked[v]);
  return !turns_too_far(v, to, ring) && keeps_topology(v, to, ring) && !joins_sheets(to, ring);
}

bool CollapseRules::keeps_topology(uint32_t v, uint32_t to, const Ring& ring) {
  uint32_t between = 0;
  left_ = right_ = kNoIndex;
  for (const FlatSurface::Opposite& side : ring.sides) {
    if (side.from == to) left_ = side.to, ++between;
    if (side.to == to) right_ = side.from, ++between;
  }
  if (between != 2 || left_ == kNoIndex || right_ == kNoIndex || left_ == right_) return false;
  if (ring.sides.size() < 3) return false;
  if (is_hub(to)) return keeps_topology_of_hub(to, ring);
  // No other vertex is beside both ends, and no face with the same corners as a changed one is there.
  const auto is_third = [&](uint32_t w) { return mark_[w] == stamp_ && w != left_ && w != right_; };
  bool kept = true;
  surface_.for_each_face(to, [&](const FlatSurface::Opposite& side) {
    if (side.from == v || side.to == v) return;
    if (is_third(side.from) || is_third(side.to)) kept = false;
    if (mark_[side.from] == stamp_ && mark_[side.to] == stamp_) kept = false;
  });
  return kept;
}

// As for other vertices, but by the rings of those around the vertex.
bool CollapseRules::keeps_topology_of_hub(uint32_t to, const Ring& ring) const {
  const auto has_face = [&](uint32_t w, auto wanted) {
    bool found = false;
    surface_.for_each_face(w, [&](const FlatSurface::Opposite& side) { found = found || wanted(side); });
    return found;
  };
  const auto has = [](const FlatSurface::Opposite& side, uint32_t w) {
    return side.from == w || side.to == w;
  };
  for (const uint32_t w : ring.vertices) {
    if (w == to || w == left_ || w == right_) continue;
    if (is_hub(w) || has_face(w, [&](const auto& side) { return has(side, to); })) return false;
  }
  if (is_hub(left_) && is_hub(right_)) return false;
  const uint32_t a = is_hub(left_) ? right_ : left_, b = is_hub(left_) ? left_ : right_;
  return !has_face(a, [&](const auto& side) { return has(side, to) && has(side, b); });
}

// A new edge between two vertices that other sheets share could coincide with an edge of those.
bool CollapseRules::joins_sheets(uint32_t to, const Ring& ring) const {
  return sheets_.shared[to] && std::any_of(ring.vertices.begin(), ring.vertices.end(), [&](uint32_t w) {
           return w != to && w != left_ && w != right_ && sheets_.shared[w];
         });
}

bool CollapseRules::turns_too_far(uint32_t v, uint32_t to, const Ring& ring) const {
  const Vec3 &before = surface_.point(v), &after = surface_.point(to);
  return std::any_of(ring.sides.begin(), ring.sides.end(), [&](const FlatSurface::Opposite& side) {
    if (side.from == to || side.to == to) return false;
    const Vec3 &a = surface_.point(side.from), &b = surface_.point(side.to);
    const Vec3 was = glm::cross(a - before, b - before), is = glm::cross(a - after, b - after);
    const double cosine = glm::dot(was, is);
    return !(cosine > 0 && cosine * cosine >= least_cosine2_ * glm::dot(was, was) * glm::dot(is, is));
  });
}

}  // namespace kerf
