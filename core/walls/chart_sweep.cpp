#include "core/walls/chart_sweep.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

ChartSweep::ChartSweep(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width)
    : vertices_(vertices), width_(width), first_(vertices.size() + 1), ending_(vertices.size()) {
  for (const ChartEdge& e : edges) {
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

// 1 where the point lies above the edge, -1 below, 0 on its line.
int ChartSweep::side_of(const Span& s, int64_t x, int64_t y) const {
  const int64_t base = vertices_[s.left].y;
  const Wide turn = turn_of(s.right_x - s.left_x, vertices_[s.right].y - base, x - s.left_x, y - base);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

// Notes a vertex and the ends of active edges, and those of the edge before and after them, as a conflict.
bool ChartSweep::fail_at(uint32_t v, size_t first, size_t end) {
  conflict_ = {v};
  for (size_t i = first > 0 ? first - 1 : 0; i < std::min(end + 1, active_.size()); ++i)
    conflict_.insert(conflict_.end(), {active_[i].span.left, active_[i].span.right});
  return false;
}

Resumable<bool> ChartSweep::run() {
  co_await worked(order_.size() / 8);
  std::sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
    const ChartVertex &p = vertices_[a], &q = vertices_[b];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  co_await worked(order_.size() / 8);
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
    co_await worked(1);
  }
  co_return end_at_seam();
}

// The edges that run across x = -1/2, from below.
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

// The trapezoid above an active edge ends at a vertex.
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

}  // namespace kerf
