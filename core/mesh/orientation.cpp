#include "core/mesh/orientation.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/tolerances.h"

namespace kerf {

namespace {

struct Box {
  Vec3 min, max;

  void add(const Vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  bool contains(const Box& b) const {
    return min.x <= b.min.x && min.y <= b.min.y && min.z <= b.min.z && b.max.x <= max.x && b.max.y <= max.y &&
           b.max.z <= max.z;
  }
};

// Points of a plane in square cells, about as many as there are points.
class Grid {
 public:
  explicit Grid(std::span<const Vec2> points) {
    side_ = 1 + static_cast<uint32_t>(std::sqrt(static_cast<double>(points.size())));
    low_ = high_ = points[0];
    for (const Vec2& p : points) {
      low_ = glm::min(low_, p);
      high_ = glm::max(high_, p);
    }
    first_.assign(size_t{side_} * side_ + 1, 0);
    for (const Vec2& p : points) ++first_[cell(p) + 1];
    for (size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    items_.resize(points.size());
    for (uint32_t i = 0; i < points.size(); ++i) items_[next[cell(points[i])]++] = i;
  }

  // Calls visit(i) for each point in the cells that meet a rectangle.
  template <typename Visit>
  void visit(const Vec2& low, const Vec2& high, Visit&& visit) const {
    if (high.x < low_.x || high.y < low_.y || high_.x < low.x || high_.y < low.y) return;
    for (uint32_t row = place(low, 1); row <= place(high, 1); ++row) {
      const size_t from = size_t{row} * side_ + place(low, 0), to = size_t{row} * side_ + place(high, 0);
      for (uint32_t i = first_[from]; i < first_[to + 1]; ++i) visit(items_[i]);
    }
  }

 private:
  // Returns the column (axis 0) or row (axis 1) of the cell nearest to a point.
  uint32_t place(const Vec2& p, int axis) const {
    const double extent = high_[axis] - low_[axis];
    if (!(extent > 0 && std::isfinite(extent))) return 0;
    const double at = (p[axis] - low_[axis]) / extent * side_;
    return static_cast<uint32_t>(std::clamp(at, 0.0, side_ - 1.0));
  }
  size_t cell(const Vec2& p) const { return size_t{place(p, 1)} * side_ + place(p, 0); }

  uint32_t side_ = 1;  // cells per row and per column
  Vec2 low_, high_;
  std::vector<uint32_t> first_, items_;  // cell c holds items_[first_[c]] .. items_[first_[c + 1] - 1]
};

class EnclosureTest {
 public:
  EnclosureTest(std::span<const Vec3> positions, const std::vector<std::array<uint32_t, 3>>& triangles,
                const Patches& patches, std::span<const uint32_t> asked, uint32_t rays)
      : positions_(positions),
        triangles_(triangles),
        patches_(patches),
        asked_(asked),
        rays_(rays),
        odd_(asked.size() * rays),
        enclosing_(asked.size()) {}

  std::vector<uint32_t> run() {
    for (const uint32_t patch : asked_) boxes_.push_back(box_of(patch));
    select_axes();
    std::vector<Vec2> origins;
    for (size_t i = 0; i < odd_.size(); ++i) origins.push_back(flat(origin(i)));
    const Grid grid(origins);
    for (uint32_t patch = 0; patch < patches_.count(); ++patch) {
      if (patches_.closed[patch]) test_against(patch, grid);
    }
    return std::move(enclosing_);
  }

 private:
  // Returns the origin of a ray: for one patch, corners of triangles spread over it.
  const Vec3& origin(size_t ray) const {
    const auto triangles = patches_.triangles_of(asked_[ray / rays_]);
    const size_t k = ray % rays_;
    return positions_[triangles_[triangles[k * triangles.size() / rays_]][k % 3]];
  }
  Vec2 flat(const Vec3& p) const { return {p[u_], p[v_]}; }

  Box box_of(uint32_t patch) const {
    const Vec3& any = positions_[triangles_[patches_.triangles_of(patch)[0]][0]];
    Box box{any, any};
    for (const uint32_t t : patches_.triangles_of(patch)) {
      for (const uint32_t corner : triangles_[t]) box.add(positions_[corner]);
    }
    return box;
  }

  void select_axes() {
    Box whole = boxes_[0];
    for (const Box& box : boxes_) {
      whole.add(box.min);
      whole.add(box.max);
    }
    const Vec3 size = whole.max - whole.min;
    if (size.x < size[w_]) w_ = 0;
    if (size.y < size[w_]) w_ = 1;
    u_ = (w_ + 1) % 3;
    v_ = (w_ + 2) % 3;
  }

  void test_against(uint32_t patch, const Grid& grid) {
    crossed_.clear();
    for (const uint32_t t : patches_.triangles_of(patch)) {
      const Vec2 a = flat(corner(t, 0)), b = flat(corner(t, 1)), c = flat(corner(t, 2));
      grid.visit(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), [&](uint32_t ray) {
        if (!ray_crosses(origin(ray), t)) return;
        odd_[ray] = !odd_[ray];
        crossed_.push_back(ray);
      });
    }
    if (crossed_.empty()) return;
    const Box box = box_of(patch);
    std::sort(crossed_.begin(), crossed_.end());
    crossed_.erase(std::unique(crossed_.begin(), crossed_.end()), crossed_.end());
    for (const uint32_t ray : crossed_) {
      const size_t i = ray / rays_;
      if (ray % rays_ == 0 && all_odd(i) && asked_[i] != patch && box.contains(boxes_[i])) ++enclosing_[i];
    }
    for (const uint32_t ray : crossed_) odd_[ray] = false;
  }

  bool all_odd(size_t asked) const {
    for (size_t ray = asked * rays_; ray < (asked + 1) * rays_; ++ray) {
      if (!odd_[ray]) return false;
    }
    return true;
  }

  const Vec3& corner(uint32_t triangle, int i) const { return positions_[triangles_[triangle][i]]; }

  // Returns true if the ray from p in the direction of +w crosses a triangle. Triangles on a common edge
  // agree on which side of the edge the ray passes.
  bool ray_crosses(const Vec3& p, uint32_t triangle) const {
    bool within = false;
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles_[triangle][i], triangles_[triangle][(i + 1) % 3]);
      within ^= passes_right_of(flat(positions_[low] - p), flat(positions_[high] - p));
    }
    if (!within) return false;
    const Vec3 a = corner(triangle, 0) - p, b = corner(triangle, 1) - p, c = corner(triangle, 2) - p;
    const double ab = cross2(flat(a), flat(b)), bc = cross2(flat(b), flat(c)), ca = cross2(flat(c), flat(a));
    const double area = ab + bc + ca, height = a[w_] * bc + b[w_] * ca + c[w_] * ab;  // times that area
    return area > 0 ? height > 0 : height < 0;
  }

  // Returns true if the half-line from the origin in the direction of +u crosses the segment from a to b; an
  // end with v = 0 counts as below.
  static bool passes_right_of(const Vec2& a, const Vec2& b) {
    if ((a.y > 0) == (b.y > 0)) return false;
    return (cross2(a, b) > 0) == (b.y > a.y);
  }

  std::span<const Vec3> positions_;
  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const Patches& patches_;
  std::span<const uint32_t> asked_;
  std::vector<Box> boxes_;  // by entry of asked_
  uint32_t rays_;           // per entry of asked_: ray r belongs to entry r / rays_
  // By ray: whether it crosses the patch being tested an odd number of times.
  std::vector<bool> odd_;
  std::vector<uint32_t> enclosing_;  // by entry of asked_
  std::vector<uint32_t> crossed_;    // rays that cross the patch being tested
  int u_ = 0, v_ = 1, w_ = 2;        // axes; rays run along w
};

using Triangles = std::vector<std::array<uint32_t, 3>>;

// Returns true if the two triangles on every edge of exactly two traverse it in opposite directions.
bool is_consistent(const Triangles& triangles, const SoupEdges& edges) {
  constexpr size_t kEdges = 1 << 16;  // per range
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
  // Returns false if stopped.
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

  void add(const Vec3& ab, const Vec3& ac, const Vec3& up) {
    sum += glm::dot(up, glm::cross(ab, ac));
    bound += glm::length(up) * glm::length(ab) * glm::length(ac);
  }
};

// Returns the volume of a patch with all lengths multiplied by a power of two.
Volume volume_of(std::span<const Vec3> positions, const Triangles& triangles, std::span<const uint32_t> patch,
                 double scale) {
  constexpr size_t kTriangles = 1 << 16;  // per range
  const Vec3& apex = positions[triangles[patch[0]][0]];
  std::vector<Volume> parts(range_count(patch.size(), kTriangles));
  for_each_range(patch.size(), kTriangles, [&](size_t i, size_t end) {
    Volume volume;
    for (const uint32_t t : patch.subspan(i, end - i)) {
      const Vec3 &a = positions[triangles[t][0]], &b = positions[triangles[t][1]],
                 &c = positions[triangles[t][2]];
      volume.add((b - a) * scale, (c - a) * scale, (a - apex) * scale);
    }
    parts[i / kTriangles] = volume;
  });
  Volume whole;
  for (const Volume& part : parts) whole = {whole.sum + part.sum, whole.bound + part.bound};
  return whole;
}

// Returns the power of two that brings a triangle to a size of about 1; 1 if it is a point.
double scale_of(std::span<const Vec3> positions, const std::array<uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 size = glm::max(glm::abs(positions[b] - positions[a]), glm::abs(positions[c] - positions[a]));
  const double longest = std::max({size.x, size.y, size.z});
  return longest > 0 ? std::ldexp(1.0, -std::ilogb(longest)) : 1;
}

// Returns the sign of the signed volume of a closed patch. The terms are bounded by the lengths of their
// edges, so that a patch without volume, whose sum is only rounding, has the sign 0.
int sign_of_volume(std::span<const Vec3> positions, const Triangles& triangles,
                   std::span<const uint32_t> patch) {
  // Products of three lengths leave the range of doubles beyond 1e102 m and below 1e-90 m.
  constexpr double kMinPlain = 0x1p-900;  // m^3
  Volume whole = volume_of(positions, triangles, patch, 1);
  if (!(whole.bound >= kMinPlain && std::isfinite(whole.bound)))
    whole = volume_of(positions, triangles, patch, scale_of(positions, triangles[patch[0]]));
  if (whole.sum < -kMinVolume * whole.bound) return -1;
  return whole.sum > kMinVolume * whole.bound ? 1 : 0;
}

}  // namespace

std::vector<uint32_t> count_enclosing(std::span<const Vec3> positions,
                                      const std::vector<std::array<uint32_t, 3>>& triangles,
                                      const Patches& patches, std::span<const uint32_t> asked,
                                      uint32_t rays) {
  if (asked.empty()) return {};
  KERF_ASSERT(rays > 0 && patches.patch_of.size() == triangles.size());
  return EnclosureTest(positions, triangles, patches, asked, rays).run();
}

std::vector<bool> find_enclosed(std::span<const Vec3> positions,
                                const std::vector<std::array<uint32_t, 3>>& triangles, const Patches& patches,
                                std::span<const uint32_t> asked) {
  const std::vector<uint32_t> enclosing = count_enclosing(positions, triangles, patches, asked, 1);
  return {enclosing.begin(), enclosing.end()};
}

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
  constexpr uint32_t kRays = 4;  // so that parts that touch the wall of a hole do not count as inside it
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
