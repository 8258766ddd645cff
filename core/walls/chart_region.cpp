#include "core/walls/chart_region_internal.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

ChartSweep::ChartSweep(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width)
    : vertices_(vertices), width_(width), first_(vertices.size() + 1), ending_(vertices.size()) {
  KERF_ASSERT(width > 0);
  for (const ChartEdge& e : edges) {
    KERF_ASSERT(std::max(e.from, e.to) < vertices.size());
    const ChartVertex &from = vertices[e.from], &to = vertices[e.to];
    KERF_ASSERT((from.x + e.dx - to.x) % width == 0);
    const bool forward = e.dx > 0 || (e.dx == 0 && to.y > from.y);
    Span span{e.from, e.to, from.x, from.x + e.dx, 1};
    if (!forward) span = {e.to, e.from, to.x, to.x - e.dx, -1};
    spans_.push_back(span);
    ++ending_[span.right];
    ++first_[span.left + 1];
  }
  for (size_t v = 0; v < vertices.size(); ++v) first_[v + 1] += first_[v];
  starting_.resize(spans_.size());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t s = 0; s < spans_.size(); ++s) starting_[next[spans_[s].left]++] = s;
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    if (ending_[v] > 0 || first_[v + 1] > first_[v]) order_.push_back(v);
  }
}

void ChartSweep::note(int winding, uint32_t v) {
  if (winding < winding_.least) {
    winding_.least = winding;
    winding_.least_at = v;
  }
  if (winding > winding_.largest) {
    winding_.largest = winding;
    winding_.largest_at = v;
  }
}

// Returns 1 if the point lies above the edge, -1 below, 0 on its line.
int ChartSweep::side_of(const Span& s, int64_t x, int64_t y) const {
  const int64_t base = vertices_[s.left].y;
  const Wide turn = doubled_area(s.right_x - s.left_x, vertices_[s.right].y - base, x - s.left_x, y - base);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

// Stores as conflict a vertex, the ends of active edges, and those of the edge before and after them.
bool ChartSweep::fail_at(uint32_t v, size_t first, size_t end) {
  conflict_ = {v};
  for (size_t i = first > 0 ? first - 1 : 0; i < std::min(end + 1, active_.size()); ++i)
    conflict_.insert(conflict_.end(), {active_[i].span.left, active_[i].span.right});
  return false;
}

Task<bool> ChartSweep::run() {
  co_await yield_after(order_.size() / 8);
  std::sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
    const ChartVertex &p = vertices_[a], &q = vertices_[b];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  co_await yield_after(order_.size() / 8);
  for (size_t i = 0; i + 1 < order_.size(); ++i) {
    const ChartVertex &a = vertices_[order_[i]], &b = vertices_[order_[i + 1]];
    if (a.x == b.x && a.y == b.y) {
      conflict_ = {order_[i], order_[i + 1]};
      co_return false;
    }
  }
  if (!start_at_seam()) co_return false;
  for (const uint32_t v : order_) {
    if (!pass(v)) co_return false;
    co_await yield_after(1);
  }
  co_return end_at_seam();
}

// Finds the edges that run across x = -1/2, from below.
bool ChartSweep::start_at_seam() {
  for (const Span& s : spans_) {
    if (s.right_x < width_ || s.left_x >= width_) continue;
    Span before = s;
    before.left_x -= width_;
    before.right_x -= width_;
    at_seam_.push_back(before);
  }
  // y at the seam is (sum over both ends of y times twice the distance of the other end) / (2 * length).
  const auto scaled = [&](const Span& s) {
    return static_cast<Wide>(vertices_[s.left].y) * (2 * s.right_x + 1) -
           static_cast<Wide>(vertices_[s.right].y) * (2 * s.left_x + 1);
  };
  const auto is_below = [&](const Span& a, const Span& b) {
    return scaled(a) * (b.right_x - b.left_x) < scaled(b) * (a.right_x - a.left_x);
  };
  std::sort(at_seam_.begin(), at_seam_.end(), is_below);
  for (size_t i = 0; i + 1 < at_seam_.size(); ++i) {
    if (is_below(at_seam_[i], at_seam_[i + 1])) continue;
    for (const Span& s : {at_seam_[i], at_seam_[i + 1]}) conflict_.insert(conflict_.end(), {s.left, s.right});
    return false;
  }
  int winding = 0;
  for (size_t i = 0; i < at_seam_.size(); ++i) {
    note(winding += at_seam_[i].sign, at_seam_[i].left);
    active_.push_back({at_seam_[i], winding, {0, 0, static_cast<int>(i)}});
  }
  winding_.above = winding;
  return true;
}

bool ChartSweep::pass(uint32_t v) {
  const int64_t x = vertices_[v].x, y = vertices_[v].y;
  const auto first = std::partition_point(active_.begin(), active_.end(),
                                          [&](const Active& a) { return side_of(a.span, x, y) > 0; });
  const size_t at = static_cast<size_t>(first - active_.begin()), ending = ending_[v];
  if (at + ending > active_.size()) return fail_at(v, at, active_.size());
  for (size_t i = at; i < at + ending; ++i) {
    if (active_[i].span.right != v || active_[i].span.right_x != x) return fail_at(v, at, at + ending + 1);
  }
  if (at > 0 && side_of(active_[at - 1].span, x, y) <= 0) return fail_at(v, at - 1, at);
  if (at + ending < active_.size() && side_of(active_[at + ending].span, x, y) >= 0)
    return fail_at(v, at + ending, at + ending + 1);
  for (size_t i = at; i <= at + ending; ++i) {
    if (i > 0) close(i - 1, v);
  }
  active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(at),
                active_.begin() + static_cast<std::ptrdiff_t>(at + ending));
  if (at > 0) active_[at - 1].start = {v, x, -1};
  return insert_starting(v, at, at > 0 ? active_[at - 1].winding : 0);
}

bool ChartSweep::insert_starting(uint32_t v, size_t at, int winding) {
  const auto [x, y] = vertices_[v];
  std::vector<Span> fresh;
  for (uint32_t i = first_[v]; i < first_[v + 1]; ++i) fresh.push_back(spans_[starting_[i]]);
  std::sort(fresh.begin(), fresh.end(),
            [&](const Span& a, const Span& b) { return side_of(a, b.right_x, vertices_[b.right].y) > 0; });
  std::vector<Active> inserted;
  for (size_t i = 0; i < fresh.size(); ++i) {
    if (i > 0 && side_of(fresh[i - 1], fresh[i].right_x, vertices_[fresh[i].right].y) <= 0) {
      conflict_ = {v, fresh[i - 1].right, fresh[i].right};
      return false;
    }
    note(winding += fresh[i].sign, v);
    inserted.push_back({fresh[i], winding, {v, x, -1}});
  }
  active_.insert(active_.begin() + static_cast<std::ptrdiff_t>(at), inserted.begin(), inserted.end());
  return true;
}

// Ends the trapezoid above an active edge at a vertex.
void ChartSweep::close(size_t below, uint32_t v) {
  const Active& a = active_[below];
  if (a.winding != 1 || below + 1 == active_.size()) return;
  const Span& above = active_[below + 1].span;
  const int64_t x = vertices_[v].x;
  if (a.start.unknown >= 0) {
    closed_.push_back({a.start.unknown, v, x, a.span, above});
  } else {
    join(a.start, v, x, a.span, above);
  }
}

void ChartSweep::join(const Start& start, uint32_t v, int64_t x, const Span& below, const Span& above) {
  for (const Span* s : {&below, &above}) {
    if (s->left == start.vertex && s->left_x == start.x && s->right == v && s->right_x == x) return;
  }
  diagonals_.push_back({start.vertex, v, x - start.x});
}

bool ChartSweep::end_at_seam() {
  if (active_.size() != at_seam_.size()) return false;
  for (size_t i = 0; i < active_.size(); ++i) {
    const Span &s = active_[i].span, &seam = at_seam_[i];
    if (s.left == seam.left && s.right == seam.right && s.right_x - width_ == seam.right_x) continue;
    conflict_ = {s.left, s.right, seam.left, seam.right};
    return false;
  }
  for (const Closed& c : closed_) {
    Start start = active_[static_cast<size_t>(c.unknown)].start;
    if (start.unknown >= 0) return false;
    start.x -= width_;
    join(start, c.vertex, c.x, c.below, c.above);
  }
  if (active_.empty()) winding_.above = 0;
  return true;
}

namespace {

// A corner of a counter-clockwise polygon of a region; x may exceed the width of the strip.
struct PolygonCorner {
  uint32_t vertex;
  int64_t x, y;
};

bool lexicographic_less(const PolygonCorner& a, const PolygonCorner& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// Triangulates a polygon one of whose sides runs from its first to its last vertex in the order of x:
// visits the vertices between in this order, and cuts off convex corners.
bool append_triangles(std::vector<PolygonCorner>& polygon, std::vector<ChartTriangle>& out) {
  if (polygon.size() < 3) return false;
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), lexicographic_less),
              polygon.end());
  const auto last = std::max_element(polygon.begin(), polygon.end(), lexicographic_less);
  const bool base_below = last == polygon.begin() + 1;
  if (!base_below && last + 1 != polygon.end()) return false;
  // The chain from left to right; on the far side of the base it runs against the sense of the polygon.
  if (base_below) std::reverse(polygon.begin() + 1, polygon.end());
  for (size_t i = 0; i + 1 < polygon.size(); ++i) {
    if (!lexicographic_less(polygon[i], polygon[i + 1])) return false;
  }
  std::vector<PolygonCorner> left;
  for (const PolygonCorner& c : polygon) {
    while (left.size() >= 2) {
      const PolygonCorner &a = left[left.size() - 2], &b = left.back();
      const Wide turn = doubled_area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
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

// Edges and diagonals of a region around its vertices; they determine its polygons.
class Polygons {
 public:
  Polygons(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges,
           std::span<const ChartEdge> diagonals)
      : vertices_(vertices), first_(vertices.size() + 1) {
    for (const ChartEdge& e : edges) add(e, true, false);
    for (const ChartEdge& e : diagonals) add(e, true, true);
  }

  Task<bool> append_triangles_of_all(std::vector<ChartTriangle>& out) {
    co_await yield_after(halves_.size() / 16);
    list_by_vertex();
    for (uint32_t v = 0; v < vertices_.size(); ++v) {
      sort_around(v);
      co_await yield_after(1);
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
      co_await yield_after(polygon.size() / 2 + 1);
      if (x != polygon.front().x || !append_triangles(polygon, out)) co_return false;
    }
    co_return true;
  }

 private:
  // A directed edge; `inside` if the region lies on its left. Its opposite is the next or the previous one.
  struct Half {
    uint32_t from, to;
    int64_t dx, dy;
    bool inside;
    uint32_t place;  // index in around_
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
    return doubled_area(a.dx, a.dy, b.dx, b.dy) > 0;
  }

  // Returns the next side of the polygon on the left: the first one clockwise from the opposite edge.
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

Task<std::optional<ChartRegion::Winding>> ChartRegion::winding(std::vector<uint32_t>* conflict) const {
  ChartSweep sweep(vertices_, edges_, width_);
  if (co_await sweep.run()) co_return sweep.winding();
  if (conflict != nullptr) *conflict = sweep.conflict();
  co_return std::nullopt;
}

Task<std::optional<std::vector<ChartTriangle>>> ChartRegion::triangles(
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
  co_await yield_after(vertices_.size() / 8);
  if (!co_await polygons.append_triangles_of_all(triangles)) co_return std::nullopt;
  co_return triangles;
}

}  // namespace kerf
