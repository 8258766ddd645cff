#include "core/cut/stroke_region.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <optional>

namespace kerf {

void StrokeRegion::note_near(FaceId f, uint32_t part) {
  const auto [at, fresh] = list_of_.try_emplace(f.index, static_cast<uint32_t>(lists_.size()));
  if (fresh) lists_.emplace_back();
  std::vector<uint32_t>& list = lists_[at->second];
  assert(list.empty() || list.back() < part);
  list.push_back(part);
}

// The number of a list with the parts of two. Children share the lists of their parents, so that a list is
// never changed once it was inherited.
uint32_t StrokeRegion::list_of_both(uint32_t a, uint32_t b) {
  if (a == b) return a;
  std::vector<uint32_t> both;
  std::set_union(lists_[a].begin(), lists_[a].end(), lists_[b].begin(), lists_[b].end(),
                 std::back_inserter(both));
  if (both.size() == lists_[a].size()) return a;
  if (both.size() == lists_[b].size()) return b;
  lists_.push_back(std::move(both));
  return static_cast<uint32_t>(lists_.size() - 1);
}

void StrokeRegion::inherit(std::span<const FaceId> children, std::span<const FaceId> parents) {
  std::optional<uint32_t> list;
  for (const FaceId parent : parents) {
    const auto at = list_of_.find(parent.index);
    if (at != list_of_.end()) list = list ? list_of_both(*list, at->second) : at->second;
  }
  assert(list && "no parent is near");
  for (const FaceId child : children) list_of_[child.index] = *list;
}

std::span<const uint32_t> StrokeRegion::parts_near(FaceId f) const {
  const auto at = list_of_.find(f.index);
  if (at == list_of_.end()) return {};
  return lists_[at->second];
}

double StrokeRegion::signed_distance(FaceId near, const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const uint32_t i : parts_near(near)) least = std::min(least, parts_[i].signed_distance(p));
  return least;
}

namespace {

// Whether a point of a triangle that is no larger than the beam lies so deep in the volume, by a grid of
// them.
bool has_point_within(const SweptCylinder& part, const Triangle& t, double depth) {
  constexpr int kParts = 8;
  for (int i = 0; i <= kParts; ++i) {
    for (int k = 0; i + k <= kParts; ++k) {
      const Vec3 p = t[0] + (double(i) * (t[1] - t[0]) + double(k) * (t[2] - t[0])) / double{kParts};
      if (part.signed_distance(p) < -depth) return true;
    }
  }
  return false;
}

}  // namespace

bool StrokeRegion::reaches_into(FaceId near, const Triangle& t, double graze) const {
  const auto parts = parts_near(near);
  return std::any_of(parts.begin(), parts.end(), [&](uint32_t i) {
    const SweptCylinder& part = parts_[i];
    if (!part.with_radius(part.radius() - graze).touches(t)) return false;
    return !part.tilts() || longest_edge2(t) > part.radius() * part.radius() ||
           has_point_within(part, t, graze);
  });
}

Vec3 StrokeRegion::crossing(FaceId near, const Vec3& inside, const Vec3& outside) const {
  constexpr int kHalvings = 52;  // the precision of the share of the segment
  double low = 0, high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (signed_distance(near, inside + middle * (outside - inside)) <= 0 ? low : high) = middle;
  }
  return inside + high * (outside - inside);
}

}  // namespace kerf
