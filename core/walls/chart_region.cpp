#include "core/walls/chart_region.h"

#include <algorithm>

#include "core/walls/chart_sweep.h"

namespace kerf {

namespace {

// A polygon of a region, counter-clockwise; x may go beyond the width of the strip.
struct PolygonCorner {
  uint32_t vertex;
  int64_t x, y;
};

bool precedes(const PolygonCorner& a, const PolygonCorner& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// Splits a polygon one of whose sides runs from its first to its last vertex in the order of x: the vertices
// between are visited in this order, and a corner is cut off where it is convex.
bool append_triangles(std::vector<PolygonCorner>& polygon, std::vector<ChartTriangle>& out) {
  if (polygon.size() < 3) return false;
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), precedes), polygon.end());
  const auto last = std::max_element(polygon.begin(), polygon.end(), precedes);
  const bool base_below = last == polygon.begin() + 1;
  if (!base_below && last + 1 != polygon.end()) return false;
  // The chain from left to right; on the far side of the base it is walked against the polygon's sense.
  if (base_below) std::reverse(polygon.begin() + 1, polygon.end());
  for (size_t i = 0; i + 1 < polygon.size(); ++i) {
    if (!precedes(polygon[i], polygon[i + 1])) return false;
  }
  std::vector<PolygonCorner> left;
  for (const PolygonCorner& c : polygon) {
    while (left.size() >= 2) {
      const PolygonCorner &a = left[left.size() - 2], &b = left.back();
      const Wide turn = turn_of(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
      if (base_below ? turn >= 0 : turn <= 0) break;
      if (base_below) {
        out.push_back({{a.vertex, c.vertex, b.vertex}, {a.x, c.x, b.x}});
      } else {
        out.push_back({{a.vertex, b.vertex, c.vertex}, {a.x, b.x, c.x}});
      }
      left.pop_back();
    }
    left.push_back(c);
  }
  return left.size() == 2;
}

// The edges and diagonals of a region around its vertices, from which its polygons follow.
class Polygons {
 public:
  Polygons(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges,
           std::span<const ChartEdge> diagonals)
      : vertices_(vertices), first_(vertices.size() + 1) {
    for (const ChartEdge& e : edges) add(e, true, false);
    for (const ChartEdge& e : diagonals) add(e, true, true);
  }

  Resumable<bool> append_triangles_of_all(std::vector<ChartTriangle>& out) {
    co_await worked(halves_.size() / 16);
    list_by_vertex();
    for (uint32_t v = 0; v < vertices_.size(); ++v) {
      sort_around(v);
      co_await worked(1);
    }
    std::vector<bool> used(halves_.size());
    std::vector<PolygonCorner> polygon;
    for (uint32_t start = 0; start < halves_.size(); ++start) {
      if (used[start] || !halves_[start].inside) continue;
      polygon.clear();
      int64_t x = vertices_[halves_[start].from].x;
      uint32_t h = start;
      do {
        if (used[h] || !halves_[h].inside) co_return false;
        used[h] = true;
        polygon.push_back({halves_[h].from, x, vertices_[halves_[h].from].y});
        x += halves_[h].dx;
        h = after(h);
      } while (h != start);
      co_await worked(polygon.size() / 2 + 1);
      if (x != polygon.front().x || !append_triangles(polygon, out)) co_return false;
    }
    co_return true;
  }

 private:
  // A directed edge; `inside` where the region lies on its left. The other direction is the next one or the
  // one before.
  struct Half {
    uint32_t from, to;
    int64_t dx, dy;
    bool inside;
    uint32_t place;  // of around_
  };

  void add(const ChartEdge& e, bool inside, bool back_inside) {
    const int64_t dy = vertices_[e.to].y - vertices_[e.from].y;
    halves_.push_back({e.from, e.to, e.dx, dy, inside, 0});
    halves_.push_back({e.to, e.from, -e.dx, -dy, back_inside, 0});
  }

  void list_by_vertex() {
    for (const Half& h : halves_) ++first_[h.from + 1];
    for (size_t v = 0; v < vertices_.size(); ++v) first_[v + 1] += first_[v];
    around_.resize(halves_.size());
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    for (uint32_t h = 0; h < halves_.size(); ++h) around_[next[halves_[h].from]++] = h;
  }

  void sort_around(uint32_t v) {
    std::sort(around_.begin() + first_[v], around_.begin() + first_[v + 1],
              [&](uint32_t a, uint32_t b) { return turns_before(halves_[a], halves_[b]); });
    for (uint32_t i = first_[v]; i < first_[v + 1]; ++i) halves_[around_[i]].place = i;
  }

  static bool in_upper_half(const Half& h) { return h.dy > 0 || (h.dy == 0 && h.dx > 0); }
  static bool turns_before(const Half& a, const Half& b) {
    if (in_upper_half(a) != in_upper_half(b)) return in_upper_half(a);
    return turn_of(a.dx, a.dy, b.dx, b.dy) > 0;
  }

  // The next side of the polygon on the left: the first one clockwise from the way back.
  uint32_t after(uint32_t h) const {
    const Half& back = halves_[h ^ 1];
    const uint32_t begin = first_[back.from], end = first_[back.from + 1];
    return around_[back.place > begin ? back.place - 1 : end - 1];
  }

  std::span<const ChartVertex> vertices_;
  std::vector<Half> halves_;
  std::vector<uint32_t> first_, around_;  // half-edges by vertex, counter-clockwise
};

}  // namespace

Resumable<std::optional<ChartRegion::Winding>> ChartRegion::winding(std::vector<uint32_t>* conflict) const {
  ChartSweep sweep(vertices_, edges_, width_);
  if (co_await sweep.run()) co_return sweep.winding();
  if (conflict != nullptr) *conflict = sweep.conflict();
  co_return std::nullopt;
}

Resumable<std::optional<std::vector<ChartTriangle>>> ChartRegion::triangles(
    std::vector<uint32_t>* conflict) const {
  ChartSweep sweep(vertices_, edges_, width_);
  if (!co_await sweep.run()) {
    if (conflict != nullptr) *conflict = sweep.conflict();
    co_return std::nullopt;
  }
  const Winding winding = sweep.winding();
  if (conflict != nullptr) *conflict = {winding.least < 0 ? winding.least_at : winding.largest_at};
  if (winding.least < 0 || winding.largest > 1 || winding.above != 0) co_return std::nullopt;
  std::vector<ChartTriangle> triangles;
  Polygons polygons(vertices_, edges_, sweep.diagonals());
  co_await worked(vertices_.size() / 8);
  if (!co_await polygons.append_triangles_of_all(triangles)) co_return std::nullopt;
  co_return triangles;
}

}  // namespace kerf
