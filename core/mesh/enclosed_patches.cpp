#include "core/mesh/enclosed_patches.h"

#include <algorithm>
#include <cmath>

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

// Points of a plane by cells of equal size, about as many as there are points.
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

  // Calls visit(i) for each point in the cells that a rectangle meets.
  template <typename Visit>
  void visit(const Vec2& low, const Vec2& high, Visit&& visit) const {
    if (high.x < low_.x || high.y < low_.y || high_.x < low.x || high_.y < low.y) return;
    for (uint32_t row = place(low, 1); row <= place(high, 1); ++row) {
      const size_t from = size_t{row} * side_ + place(low, 0), to = size_t{row} * side_ + place(high, 0);
      for (uint32_t i = first_[from]; i < first_[to + 1]; ++i) visit(items_[i]);
    }
  }

 private:
  // Column (axis 0) or row (axis 1) of the cell that is nearest to a point.
  uint32_t place(const Vec2& p, int axis) const {
    const double extent = high_[axis] - low_[axis];
    if (!(extent > 0)) return 0;
    const double at = (p[axis] - low_[axis]) / extent * side_;
    return static_cast<uint32_t>(std::clamp(at, 0.0, side_ - 1.0));
  }
  size_t cell(const Vec2& p) const { return size_t{place(p, 1)} * side_ + place(p, 0); }

  uint32_t side_ = 1;  // cells in a row and in a column
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
    choose_axes();
    std::vector<Vec2> origins;
    for (size_t i = 0; i < odd_.size(); ++i) origins.push_back(flat(origin(i)));
    const Grid grid(origins);
    for (uint32_t patch = 0; patch < patches_.count(); ++patch) {
      if (patches_.closed[patch]) test_against(patch, grid);
    }
    return std::move(enclosing_);
  }

 private:
  // The origin of a ray. Those of one patch are corners of triangles spread over it.
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

  void choose_axes() {
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

  // Whether the ray from p in the direction of +w crosses a triangle. Triangles on a common edge agree on
  // which side of the edge the ray passes.
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

  // Whether the half-line from the origin in the direction of +u crosses the segment from a to b, of whose
  // ends one with v = 0 counts as below.
  static bool passes_right_of(const Vec2& a, const Vec2& b) {
    if ((a.y > 0) == (b.y > 0)) return false;
    return (cross2(a, b) > 0) == (b.y > a.y);
  }

  std::span<const Vec3> positions_;
  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const Patches& patches_;
  std::span<const uint32_t> asked_;
  std::vector<Box> boxes_;  // one per entry of asked_
  uint32_t rays_;           // for each entry of asked_: ray r is of the entry r / rays_
  // By ray: whether it crosses the patch being tested an odd number of times.
  std::vector<bool> odd_;
  std::vector<uint32_t> enclosing_;  // by entry of asked_
  std::vector<uint32_t> crossed_;    // rays that cross the patch being tested
  int u_ = 0, v_ = 1, w_ = 2;        // axes; the rays go along w
};

}  // namespace

std::vector<uint32_t> count_enclosing(std::span<const Vec3> positions,
                                      const std::vector<std::array<uint32_t, 3>>& triangles,
                                      const Patches& patches, std::span<const uint32_t> asked,
                                      uint32_t rays) {
  if (asked.empty()) return {};
  return EnclosureTest(positions, triangles, patches, asked, rays).run();
}

std::vector<bool> find_enclosed(std::span<const Vec3> positions,
                                const std::vector<std::array<uint32_t, 3>>& triangles, const Patches& patches,
                                std::span<const uint32_t> asked) {
  const std::vector<uint32_t> enclosing = count_enclosing(positions, triangles, patches, asked, 1);
  return {enclosing.begin(), enclosing.end()};
}

}  // namespace kerf
