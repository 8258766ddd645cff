#include "core/cut/stroke_region.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/base/root.h"

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

void StrokeRegion::record_near(FaceId f, uint32_t part) {
  uint32_t& list = list_of_.at(f.index);
  if (list == 0) {
    lists_.emplace_back();
    list = static_cast<uint32_t>(lists_.size());
  }
  assert(lists_[list - 1].first == kNone || entries_[lists_[list - 1].last].part < part);
  append(lists_[list - 1], part);
}

// Returns the index plus one of a list with the parts of two. Children share lists, so these are immutable.
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

// Returns true if a point of a grid over a triangle, no larger than the beam, lies this deep in the volume.
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

constexpr size_t kMaxOfLeaf = 4;
constexpr size_t kDeepest = 64;  // exceeds any possible depth of the tree

class ChordTest {
 public:
  ChordTest(const StrokeRegion& region, FaceId face, const Triangle& at, const std::array<double, 3>& d,
            double chord, double graze)
      : region_(region), face_(face), at_(at), d_(d), chord_(chord), graze_(graze) {}

  bool fails() {
    const bool any_inside = d_[0] < 0 || d_[1] < 0 || d_[2] < 0;
    const bool any_outside = d_[0] > 0 || d_[1] > 0 || d_[2] > 0;
    if (!any_inside && any_outside && reaches_into()) return true;
    for (int i = 0; i < 3; ++i) {
      if (edge_fails(i, (i + 1) % 3)) return true;
    }
    if (!any_outside) return region_.signed_distance(face_, (at_[0] + at_[1] + at_[2]) / 3.0) > graze_;
    return any_inside && cut_fails();
  }

 private:
  // Of a crossing, as a share of the edge: far below the accepted deviations.
  static constexpr double kPrecision = 0x1p-24;

  // Every point of a triangle is nearer to one of its corners than its longest edge.
  bool reaches_into() const {
    const double least = std::min({d_[0], d_[1], d_[2]});
    return least <= region_.steepest() * std::sqrt(longest_edge2(at_)) &&
           region_.reaches_into(face_, at_, graze_);
  }

  // A point with its distance from the boundary.
  struct End {
    Vec3 at;
    double distance;
  };
  End corner(int i) const { return {at_[i], d_[i]}; }

  bool edge_fails(int i, int k) {
    if (d_[i] > 0 && d_[k] > 0) return passes_through(corner(i), corner(k));
    if (d_[i] == 0 && d_[k] == 0) return leaves_boundary(at_[i], at_[k]);
    if (d_[i] <= 0 && d_[k] <= 0) return leaves_region(corner(i), corner(k));
    const int in = d_[i] < d_[k] ? i : k, out = in == i ? k : i;
    if (d_[in] == 0) return passes_through(corner(in), corner(out));
    const End crossing{region_.crossing(face_, at_[in], at_[out], kPrecision), 0};
    if (leaves_region(corner(in), crossing) || passes_through(crossing, corner(out))) return true;
    ends_[ends_count_++] = crossing.at;
    return false;
  }

  // Returns how far the distance may change on the way to the nearer end of a segment and back.
  double change(const End& a, const End& b) const { return region_.steepest() * glm::length(b.at - a.at); }

  bool passes_through(const End& a, const End& b) const {
    const double least = 0.5 * (a.distance + b.distance - change(a, b));
    return least <= 0 && region_.reaches_into(face_, {a.at, b.at, b.at}, graze_);
  }

  // Tests seven points between the ends, without those that are certainly in the region.
  bool leaves_region(const End& a, const End& b, int halvings = 3) const {
    const double most = 0.5 * (a.distance + b.distance + change(a, b));
    if (most <= 0 || halvings == 0) return false;
    const Vec3 at = 0.5 * (a.at + b.at);
    const End middle{at, region_.signed_distance(face_, at)};
    return middle.distance > graze_ || leaves_region(a, middle, halvings - 1) ||
           leaves_region(middle, b, halvings - 1);
  }

  // The middle, where an arc is farthest from its chord, comes first.
  bool leaves_boundary(const Vec3& a, const Vec3& b) const {
    constexpr std::array<double, 7> kShares{0.5, 0.25, 0.75, 0.375, 0.625, 0.125, 0.875};
    return std::ranges::any_of(kShares, [&](double share) {
      return std::abs(region_.signed_distance(face_, a + share * (b - a))) > chord_;
    });
  }

  // The chord runs between two crossings, or from one to a corner on the boundary.
  bool cut_fails() {
    for (int i = 0; i < 3; ++i) {
      if (d_[i] == 0 && ends_count_ < 2) ends_[ends_count_++] = at_[i];
    }
    return ends_count_ == 2 && leaves_boundary(ends_[0], ends_[1]);
  }

  const StrokeRegion& region_;
  FaceId face_;
  const Triangle& at_;
  const std::array<double, 3>& d_;
  double chord_, graze_;
  std::array<Vec3, 3> ends_{};
  int ends_count_ = 0;
};

}  // namespace

bool StrokeRegion::reaches_into(FaceId near, const Triangle& t, double graze) const {
  bool any = false;
  for_each_part_near(near, [&](uint32_t i) {
    const SweptCylinder& part = parts_[i];
    if (any || !part.touches(t, part.radius() - graze)) return;
    any = part.touches_exactly(t) || longest_edge2(t) > part.radius() * part.radius() ||
          has_point_within(part, t, graze);
  });
  return any;
}

class StrokeRegion::PartsOnSegment {
 public:
  PartsOnSegment(const StrokeRegion& region, FaceId near) : region_(region), near_(near) {
    region.for_each_part_near(near, [&](uint32_t i) {
      if (count_ < kMost) parts_[count_] = i;
      ++count_;
    });
  }

  // Returns the signed distance of an end of the rest of a segment, which has this length. Drops the parts
  // that cannot reach the rest; the rounding of the distances is far below the margin.
  double distance(const Vec3& p, double length) {
    if (count_ > kMost) return region_.signed_distance(near_, p);
    size_t kept = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < count_; ++i) {
      const SweptCylinder& part = region_.parts_[parts_[i]];
      const double distance = part.signed_distance(p);
      least = std::min(least, distance);
      if (distance <= part.steepest() * length + kMargin * part.radius()) parts_[kept++] = parts_[i];
    }
    count_ = kept;
    return least;
  }

 private:
  static constexpr size_t kMost = 64;
  static constexpr double kMargin = 1e-3;  // of the radius

  const StrokeRegion& region_;
  FaceId near_;
  std::array<uint32_t, kMost> parts_;
  size_t count_ = 0;
};

Vec3 StrokeRegion::crossing(FaceId near, const Vec3& inside, const Vec3& outside, double precision) const {
  const Vec3 way = outside - inside;
  const double length = glm::length(way);
  PartsOnSegment parts(*this, near);
  const double low = parts.distance(inside, length), high = parts.distance(outside, length);
  const auto distance = [&](double share, double rest) {
    return parts.distance(inside + share * way, rest * length);
  };
  const double rounding = 0x1p-53 * (glm::length(inside) + glm::length(outside)) / length;
  const double share = upper_end_of_root(low, high, std::max(precision, rounding), distance);
  return inside + share * way;
}

SweptDistance::SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves) {
  KERF_ASSERT(region.parts() == moves.size() && !moves.empty());
  for (size_t i = 0; i < region.parts(); ++i) parts_.push_back(region.part(i));
  nodes_.push_back({0, moves.size(), {}, {}, {}});
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    bound(i, moves);
    const auto [first, end] = std::pair(nodes_[i].first, nodes_[i].end);
    if (end - first <= kMaxOfLeaf) continue;
    nodes_[i].halves = static_cast<uint32_t>(nodes_.size());
    const size_t middle = first + (end - first) / 2;
    nodes_.push_back({first, middle, {}, {}, {}});
    nodes_.push_back({middle, end, {}, {}, {}});
  }
}

void SweptDistance::bound(uint32_t node, std::span<const BeamMove> moves) {
  Node& n = nodes_[node];
  KERF_ASSERT(n.first < n.end && n.end <= moves.size());
  const auto own = moves.subspan(n.first, n.end - n.first);
  n.middle = own[own.size() / 2].from;
  n.from = own.front().from;
  n.to = own.back().to;
  const auto for_each_pose = [&](const auto& visit) {
    for (const BeamMove& m : own) {
      visit(m.from);
      visit(m.to);
    }
  };
  for_each_pose([&](const Pose& pose) {
    const Vec3 moved = pose.origin - n.middle.origin;
    n.aside = std::max(n.aside, glm::length(moved));
    n.shift = std::max(n.shift, std::abs(glm::dot(moved, n.middle.direction)));
    n.apart = std::max(n.apart, glm::length(pose.direction - n.middle.direction));
  });
  // Displacement and turn count alike in the search for the nearest pose on the straight way.
  const double metres = n.apart > 0 ? n.aside / n.apart : 0;
  const Vec3 way = n.to.origin - n.from.origin, turn = metres * (n.to.direction - n.from.direction);
  const double length2 = glm::dot(way, way) + glm::dot(turn, turn);
  for_each_pose([&](const Pose& pose) {
    const Vec3 moved = pose.origin - n.from.origin, turned = metres * (pose.direction - n.from.direction);
    const double along = glm::dot(moved, way) + glm::dot(turned, turn);
    const double share = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
    n.bulge = std::max(n.bulge, glm::length(moved - share * way));
    n.bend =
        std::max(n.bend, glm::length(pose.direction - glm::mix(n.from.direction, n.to.direction, share)));
  });
}

// At the depth of the point along the middle direction, the points of all axes are near the segment between
// those of the first and the last axis. The vector w from such a point to p is nearly perpendicular to the
// axis: its component along the axis is at most e = |w| apart + shift + |depth| apart^2 / 2, so that p is at
// least sqrt(|w|^2 - e^2) from the axis. This increases with |w| wherever it is real.
SweptDistance::Estimate SweptDistance::estimate(const Node& node, const Vec3& p) const {
  constexpr double kRounding = 1e-9;  // relative
  // The volume of a tilting part also errs by the angle squared: its corners move on straight lines, and its
  // distances are measured across a single direction.
  constexpr double kTilt = 4;
  const Vec3 from = p - node.middle.origin;
  const SweptCylinder& part = parts_[node.first];  // all have its radius and range
  const double away = glm::length(from), depth = glm::dot(from, node.middle.direction);
  const double beyond = std::max(depth - part.range().high, part.range().low - depth);
  const Vec3 first = node.from.origin + depth * node.from.direction - p;
  const Vec3 way = node.to.origin + depth * node.to.direction - p - first;
  const double length2 = glm::dot(way, way);
  const double share = length2 > 0 ? std::clamp(-glm::dot(first, way) / length2, 0.0, 1.0) : 0;
  const double reach =
      std::max(0.0, glm::length(first + share * way) - node.bulge - std::abs(depth) * node.bend);
  const double slope = reach * node.apart + node.shift + 0.5 * std::abs(depth) * node.apart * node.apart;
  const double beside = std::sqrt(std::max(0.0, (reach - slope) * (reach + slope)));
  const double drift = node.aside + node.apart * (away + node.aside);
  const double error = (kRounding + kTilt * node.apart * node.apart) * (away + node.aside);
  return {std::max(beside - part.radius(), beyond - drift) - error,
          std::max(glm::length(from - depth * node.middle.direction) - part.radius(), beyond)};
}

double SweptDistance::operator()(const Vec3& p) const {
  struct Visit {
    double at_least;
    uint32_t node;
  };
  std::array<Visit, kDeepest> stack;
  size_t waiting = 0;
  stack[waiting++] = {-std::numeric_limits<double>::infinity(), 0};
  double least = std::numeric_limits<double>::infinity();
  while (waiting > 0) {
    const Visit visit = stack[--waiting];
    if (visit.at_least >= least) continue;
    const Node& node = nodes_[visit.node];
    if (node.halves == 0) {
      for (size_t i = node.first; i < node.end; ++i) least = std::min(least, parts_[i].signed_distance(p));
      continue;
    }
    KERF_ASSERT(waiting + 2 <= kDeepest);
    const Estimate one = estimate(nodes_[node.halves], p), other = estimate(nodes_[node.halves + 1], p);
    stack[waiting++] = {one.at_least, node.halves};
    stack[waiting++] = {other.at_least, node.halves + 1};
    if (one.from_middle < other.from_middle) std::swap(stack[waiting - 2], stack[waiting - 1]);
  }
  return least;
}

bool chord_fails(const StrokeRegion& region, FaceId face, const Triangle& at,
                 const std::array<double, 3>& distances, double chord, double graze) {
  return ChordTest(region, face, at, distances, chord, graze).fails();
}

}  // namespace kerf
