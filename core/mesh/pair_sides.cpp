#include "core/mesh/pair_sides.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/mesh/half_edges_internal.h"

namespace kerf {

namespace {

// Triangles around an edge whose directions differ by less than this fraction of a right angle coincide,
// within the rounding of single-precision coordinates.
constexpr double kSameDirection = 1e-6;
// A triangle has no direction if the distance of its corner from the line of the edge is less than this
// fraction of the distance from the edge's end.
constexpr double kMinHeight = 1e-12;

// A side seen along its edge from the lower to the higher end.
struct AroundEdge {
  double turn;  // 0 <= turn < 4, counter-clockwise; 1 is about a right angle
  bool begins;  // the inside is counter-clockwise from the triangle
  uint32_t side, patch;
};

class ShellPairing {
 public:
  ShellPairing(std::span<const Vec3> positions, std::span<const std::array<uint32_t, 3>> triangles,
               const SoupEdges& edges, std::span<const uint32_t> patch_of, std::vector<uint32_t>& partner)
      : positions_(positions), triangles_(triangles), edges_(edges), patch_of_(patch_of), partner_(partner) {}

  std::vector<uint32_t> run(std::span<const uint32_t> several) {
    for (const uint32_t e : several) pair_around(e);
    if (!paired_.empty()) drop_pairs_of_open_shells();
    return std::move(paired_);
  }

 private:
  uint32_t corner(uint32_t side, uint32_t after) const {
    return triangles_[side / 3][(side % 3 + after) % 3];
  }

  // Returns the sides of an edge in their order around it; empty if a triangle has no direction.
  std::vector<AroundEdge> sides_around(uint32_t edge) const {
    const auto sides = edges_.sides_of(edge);
    const auto [low, high] = std::minmax({corner(sides[0], 0), corner(sides[0], 1)});
    const Vec3 origin = positions_[low], along = glm::normalize(positions_[high] - origin);
    std::optional<Vec3> right, up;
    std::vector<AroundEdge> around;
    for (const uint32_t s : sides) {
      const Vec3 to_corner = positions_[corner(s, 2)] - origin;
      const Vec3 across = to_corner - glm::dot(to_corner, along) * along;
      if (!(glm::length(across) > kMinHeight * glm::length(to_corner))) return {};
      if (!right) {
        right = glm::normalize(across);
        up = glm::cross(along, *right);
      }
      const double x = glm::dot(to_corner, *right), y = glm::dot(to_corner, *up);
      const double part = y / (std::abs(x) + std::abs(y));
      const double turn = x < 0 ? 2 - part : y < 0 ? 4 + part : part;
      around.push_back({turn < 4 ? turn : 0, corner(s, 0) != low, s, patch_of_[s / 3]});
    }
    return around;
  }

  // Sorts the sides counter-clockwise; of sides in the same direction, those that end a shell precede those
  // that begin one. The first one follows a gap, if there is one.
  static void sort(std::vector<AroundEdge>& around) {
    const size_t n = around.size();
    std::sort(around.begin(), around.end(), [](const AroundEdge& a, const AroundEdge& b) {
      return a.turn != b.turn ? a.turn < b.turn : a.side < b.side;
    });
    const auto follows_gap = [&](size_t i) {
      const double before = i > 0 ? around[i - 1].turn : around[n - 1].turn - 4;
      return around[i].turn - before >= kSameDirection;
    };
    size_t first = 0;
    while (first < n && !follows_gap(first)) ++first;
    std::vector<bool> starts(n);
    for (size_t i = 0; i < n; ++i) starts[i] = follows_gap((first + i) % n);
    std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(first % n), around.end());
    for (size_t i = 0; i < n;) {
      size_t end = i + 1;
      while (end < n && !starts[end]) ++end;
      const auto at = around.begin();
      std::sort(at + static_cast<std::ptrdiff_t>(i), at + static_cast<std::ptrdiff_t>(end),
                [](const AroundEdge& a, const AroundEdge& b) {
                  return a.begins != b.begins ? b.begins : a.side < b.side;
                });
      i = end;
    }
  }

  // Rotates the sides to begin where the fewest shells overlap.
  static void rotate_to_outside(std::vector<AroundEdge>& around) {
    int depth = 0, least = 0;
    size_t first = 0;
    for (size_t i = 0; i < around.size(); ++i) {
      depth += around[i].begins ? 1 : -1;
      if (depth >= least) continue;
      least = depth;
      first = i + 1;
    }
    std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(first), around.end());
  }

  static int balance_of(std::span<const AroundEdge> around) {
    int balance = 0;
    for (const AroundEdge& a : around) balance += a.begins ? 1 : -1;
    return balance;
  }

  void pair_around(uint32_t edge) {
    std::vector<AroundEdge> around = sides_around(edge);
    if (around.empty()) return;
    sort(around);
    if (balance_of(around) == 0) return pair_balanced(std::move(around));
    // A shell that is one patch here is paired regardless of the other sides on the edge.
    std::map<uint32_t, std::vector<AroundEdge>> by_patch;
    for (const AroundEdge& a : around) by_patch[a.patch].push_back(a);
    for (auto& [patch, own] : by_patch) {
      if (balance_of(own) == 0) pair_balanced(std::move(own));
    }
  }

  void pair_balanced(std::vector<AroundEdge> around) {
    rotate_to_outside(around);
    std::deque<uint32_t> begun;                              // of any patch, some already paired
    std::unordered_map<uint32_t, std::deque<uint32_t>> own;  // by patch
    std::unordered_set<uint32_t> paired;
    for (const AroundEdge& a : around) {
      if (a.begins) {
        begun.push_back(a.side);
        own[a.patch].push_back(a.side);
        continue;
      }
      std::deque<uint32_t>* first = &begun;
      for (std::deque<uint32_t>* list : {&begun, &own[a.patch]}) {
        while (!list->empty() && paired.contains(list->front())) list->pop_front();
        if (!list->empty()) first = list;
      }
      const uint32_t side = first->front();
      paired.insert(side);
      // Copies of one triangle stay separate (see Mesh).
      if (corner(side, 2) != corner(a.side, 2)) pair(a.side, side);
    }
  }

  void pair(uint32_t side, uint32_t other) {
    partner_[side] = other;
    partner_[other] = side;
    paired_.push_back(side);
  }

  void drop_pairs_of_open_shells() {
    UnionFind shells(triangles_.size());
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (partner_[s] != kNoSide && partner_[s] > s) shells.unite(s / 3, partner_[s] / 3);
    }
    std::vector<bool> open(triangles_.size());
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (partner_[s] == kNoSide) open[shells.find(s / 3)] = true;
    }
    std::erase_if(paired_, [&](uint32_t s) {
      if (!open[shells.find(s / 3)]) return false;
      partner_[partner_[s]] = kNoSide;
      partner_[s] = kNoSide;
      return true;
    });
  }

  std::span<const Vec3> positions_;
  std::span<const std::array<uint32_t, 3>> triangles_;
  const SoupEdges& edges_;
  std::span<const uint32_t> patch_of_;
  std::vector<uint32_t>& partner_;
  std::vector<uint32_t> paired_;  // one side of each pair
};

// Merges the patches of each shell into a closed one. `pairs`: from pair_sides_of_shells().
void join_patches(Patches& patches, std::span<const uint32_t> partner, std::span<const uint32_t> pairs) {
  if (pairs.empty()) return;
  KERF_ASSERT(partner.size() == 3 * patches.patch_of.size());
  constexpr uint32_t kNone = 0xffffffffu;
  UnionFind shells(patches.count());
  std::vector<bool> closed = std::move(patches.closed);
  for (const uint32_t s : pairs) {
    const uint32_t one = patches.patch_of[s / 3], other = patches.patch_of[partner[s] / 3];
    shells.unite(one, other);
    closed[one] = closed[other] = true;
  }
  std::vector<uint32_t> number(closed.size(), kNone);
  patches.closed.clear();
  for (uint32_t p = 0; p < closed.size(); ++p) {
    const uint32_t first = shells.find(p);
    if (number[first] == kNone) {
      number[first] = static_cast<uint32_t>(patches.closed.size());
      patches.closed.push_back(closed[first]);
    }
    number[p] = number[first];
  }
  patches.first.assign(patches.closed.size() + 1, 0);
  for (uint32_t& p : patches.patch_of) {
    p = number[p];
    ++patches.first[p + 1];
  }
  for (size_t p = 0; p < patches.closed.size(); ++p) patches.first[p + 1] += patches.first[p];
  std::vector<uint32_t> next(patches.first.begin(), patches.first.end() - 1);
  for (uint32_t t = 0; t < patches.patch_of.size(); ++t) patches.triangles[next[patches.patch_of[t]]++] = t;
}

}  // namespace

bool pair_two_sides(std::span<const std::array<uint32_t, 3>> triangles, std::span<const uint32_t> sides,
                    std::vector<uint32_t>& partner) {
  const auto corner = [&](uint32_t side, uint32_t after) {
    return triangles[side / 3][(side % 3 + after) % 3];
  };
  if (sides.size() != 2 || corner(sides[0], 0) == corner(sides[1], 0) ||
      corner(sides[0], 2) == corner(sides[1], 2))
    return false;
  partner[sides[0]] = sides[1];
  partner[sides[1]] = sides[0];
  return true;
}

std::vector<uint32_t> pair_sides_of_shells(std::span<const Vec3> positions,
                                           std::span<const std::array<uint32_t, 3>> triangles,
                                           const SoupEdges& edges, std::span<const uint32_t> several,
                                           std::span<const uint32_t> patch_of,
                                           std::vector<uint32_t>& partner) {
  if (several.empty()) return {};
  KERF_ASSERT(partner.size() == 3 * triangles.size() && patch_of.size() == triangles.size());
  return ShellPairing(positions, triangles, edges, patch_of, partner).run(several);
}

void join_patches_of_shells(std::span<const Vec3> positions,
                            std::span<const std::array<uint32_t, 3>> triangles, const SoupEdges& edges,
                            Patches& patches) {
  std::vector<uint32_t> several;
  for (uint32_t e = 0; e < edges.count(); ++e) {
    if (edges.sides_of(e).size() > 2) several.push_back(e);
  }
  if (several.empty()) return;
  std::vector<uint32_t> partner(3 * triangles.size(), kNoSide);
  for (uint32_t e = 0; e < edges.count(); ++e) pair_two_sides(triangles, edges.sides_of(e), partner);
  const std::vector<uint32_t> pairs =
      pair_sides_of_shells(positions, triangles, edges, several, patches.patch_of, partner);
  join_patches(patches, partner, pairs);
}

}  // namespace kerf
