#include "core/cut/stroke_region.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace kerf {

template <typename Visit>
void StrokeRegion::for_each_part_near(FaceId f, Visit visit) const {
  const uint32_t list = list_of_.get(f.index);
  if (list == 0) return;
  for (uint32_t at = lists_[list - 1].first; at != kNone; at = entries_[at].next) visit(entries_[at].part);
}

void StrokeRegion::append(List& list, uint32_t part) {
  const auto added = static_cast<uint32_t>(entries_.size());
  entries_.push_back({part, kNone});
  (list.first == kNone ? list.first : entries_[list.last].next) = added;
  list.last = added;
}

void StrokeRegion::note_near(FaceId f, uint32_t part) {
  uint32_t& list = list_of_.at(f.index);
  if (list == 0) {
    lists_.emplace_back();
    list = static_cast<uint32_t>(lists_.size());
  }
  assert(lists_[list - 1].first == kNone || entries_[lists_[list - 1].last].part < part);
  append(lists_[list - 1], part);
}

// The number of a list with the parts of two, plus one like theirs. Children share the lists of their
// parents, so that a list is never changed once it was inherited.
uint32_t StrokeRegion::list_of_both(uint32_t a, uint32_t b) {
  if (a == b) return a;
  List both;
  uint32_t i = lists_[a - 1].first, k = lists_[b - 1].first;
  bool more_than_a = false, more_than_b = false;
  while (i != kNone || k != kNone) {
    const uint32_t of_a = i != kNone ? entries_[i].part : kNone, of_b = k != kNone ? entries_[k].part : kNone;
    more_than_a |= of_b < of_a;
    more_than_b |= of_a < of_b;
    append(both, std::min(of_a, of_b));
    if (of_a <= of_b) i = entries_[i].next;
    if (of_b <= of_a) k = entries_[k].next;
  }
  if (!more_than_a || !more_than_b) {
    entries_.resize(both.first);
    return more_than_a ? b : a;
  }
  lists_.push_back(both);
  return static_cast<uint32_t>(lists_.size());
}

void StrokeRegion::inherit(std::span<const FaceId> children, std::span<const FaceId> parents) {
  uint32_t list = 0;
  for (const FaceId parent : parents) {
    const uint32_t own = list_of_.get(parent.index);
    if (own != 0) list = list != 0 ? list_of_both(list, own) : own;
  }
  assert(list != 0 && "no parent is near");
  for (const FaceId child : children) list_of_.at(child.index) = list;
}

double StrokeRegion::signed_distance(FaceId near, const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for_each_part_near(near, [&](uint32_t i) { least = std::min(least, parts_[i].signed_distance(p)); });
  return least;
}

namespace {

// Whether a point of a grid over a triangle lies this deep in the volume. The triangle is no larger than the
// beam.
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
  bool any = false;
  for_each_part_near(near, [&](uint32_t i) {
    const SweptCylinder& part = parts_[i];
    if (any || !part.touches(t, part.radius() - graze)) return;
    any =
        !part.tilts() || longest_edge2(t) > part.radius() * part.radius() || has_point_within(part, t, graze);
  });
  return any;
}

class StrokeRegion::PartsOnSegment {
 public:
  PartsOnSegment(const StrokeRegion& region, FaceId near) : region_(region) {
    region.for_each_part_near(near, [&](uint32_t i) {
      if (count_ < kMost) parts_[count_] = i;
      ++count_;
    });
  }
  // Whether there are few enough of them.
  bool fit() const { return count_ <= kMost; }

  // Whether any part holds the point, the middle of a segment of which one half is to be looked at next.
  // Leaves out the parts whose boundary is too far from `p` to reach that half of `length` metres; the
  // rounding of the distances is far below the margin.
  bool hold(const Vec3& p, double length) {
    size_t kept = 0;
    bool held = false;
    for (size_t i = 0; i < count_; ++i) {
      const SweptCylinder& part = region_.parts_[parts_[i]];
      const double distance = part.signed_distance(p);
      held |= distance <= 0;
      if (distance <= part.steepest() * length + kMargin * part.radius()) parts_[kept++] = parts_[i];
    }
    count_ = kept;
    return held;
  }

 private:
  static constexpr size_t kMost = 64;
  static constexpr double kMargin = 1e-3;  // of the radius

  const StrokeRegion& region_;
  std::array<uint32_t, kMost> parts_;
  size_t count_ = 0;
};

Vec3 StrokeRegion::crossing(FaceId near, const Vec3& inside, const Vec3& outside) const {
  constexpr int kHalvings = 52;  // the precision of the share of the segment
  const Vec3 way = outside - inside;
  PartsOnSegment parts(*this, near);
  double low = 0, high = 1, length = glm::length(way);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const Vec3 p = inside + middle * way;
    length *= 0.5;
    const bool held = parts.fit() ? parts.hold(p, length) : signed_distance(near, p) <= 0;
    (held ? low : high) = middle;
  }
  return inside + high * way;
}

}  // namespace kerf
