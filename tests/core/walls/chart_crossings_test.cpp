#include "core/walls/chart_region_internal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "tests/core/walls/chart_lattice.h"
#include "tests/support/runs.h"

namespace kerf::test {
namespace {

// An edge with its ends in the plane.
struct PlacedEdge {
  int64_t ax, ay, bx, by;
  uint32_t from, to;
};

int sign_at(const PlacedEdge& e, int64_t x, int64_t y) {
  const Wide turn = doubled_area(e.bx - e.ax, e.by - e.ay, x - e.ax, y - e.ay);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

bool holds(const PlacedEdge& e, int64_t x, int64_t y) {
  return sign_at(e, x, y) == 0 && std::min(e.ax, e.bx) <= x && x <= std::max(e.ax, e.bx) &&
         std::min(e.ay, e.by) <= y && y <= std::max(e.ay, e.by);
}

// Whether they have a point in common, other than a place where both have an end.
bool do_meet(const PlacedEdge& a, const PlacedEdge& b) {
  const int b0 = sign_at(a, b.ax, b.ay), b1 = sign_at(a, b.bx, b.by);
  const int a0 = sign_at(b, a.ax, a.ay), a1 = sign_at(b, a.bx, a.by);
  if (a0 * a1 < 0 && b0 * b1 < 0) return true;
  const auto is_end = [](const PlacedEdge& e, int64_t x, int64_t y) {
    return (x == e.ax && y == e.ay) || (x == e.bx && y == e.by);
  };
  if (holds(a, b.ax, b.ay) && !is_end(a, b.ax, b.ay)) return true;
  if (holds(a, b.bx, b.by) && !is_end(a, b.bx, b.by)) return true;
  if (holds(b, a.ax, a.ay) && !is_end(b, a.ax, a.ay)) return true;
  if (holds(b, a.bx, a.by) && !is_end(b, a.bx, a.by)) return true;
  return is_end(a, b.ax, b.ay) && is_end(a, b.bx, b.by);  // the same line twice
}

// The vertices of edges that meet elsewhere than in a common vertex, by a comparison of all pairs.
std::set<uint32_t> meeting_vertices(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges,
                                    int64_t width) {
  std::set<uint32_t> meeting;
  std::map<std::pair<int64_t, int64_t>, uint32_t> at;
  std::vector<PlacedEdge> placed;
  for (const ChartEdge& e : edges) {
    for (const uint32_t v : {e.from, e.to}) {
      const uint32_t first = at.try_emplace({vertices[v].x, vertices[v].y}, v).first->second;
      if (first != v) meeting.insert({first, v});
    }
    const ChartVertex &a = vertices[e.from], &b = vertices[e.to];
    placed.push_back({a.x, a.y, a.x + e.dx, b.y, e.from, e.to});
  }
  for (size_t i = 0; i < placed.size(); ++i) {
    for (size_t k = i; k < placed.size(); ++k) {
      for (int64_t turn = -2; turn <= 2; ++turn) {
        if (i == k && turn == 0) continue;
        PlacedEdge other = placed[k];
        other.ax += turn * width;
        other.bx += turn * width;
        if (!do_meet(placed[i], other)) continue;
        for (const PlacedEdge& e : {placed[i], other}) meeting.insert({e.from, e.to});
      }
    }
  }
  return meeting;
}

struct Meetings {
  size_t apart = 0, meeting = 0;
  size_t named = 0;  // of which the sweep names a vertex

  // Compares what the sweep finds with the comparison.
  void count(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width) {
    const std::set<uint32_t> found = meeting_vertices(vertices, edges, width);
    std::vector<uint32_t> conflict;
    ASSERT_EQ(run_to_completion(ChartRegion(vertices, edges, width).winding(&conflict)).has_value(),
              found.empty());
    if (found.empty()) ASSERT_TRUE(conflict.empty());
    ++(found.empty() ? apart : meeting);
    named += std::any_of(conflict.begin(), conflict.end(), [&](uint32_t v) { return found.contains(v); });
  }
};

// Edges in a wrong order may be noticed only further on, or at the end, where none is named.
void expect_most_named(const Meetings& all) {
  std::printf("of %zu conflicts the sweep names a vertex in %zu\n", all.meeting, all.named);
  EXPECT_GE(all.named, all.meeting * 9 / 10);
}

// A closed loop through random places, which may go around the ring.
void append_loop(std::vector<ChartVertex>& vertices, std::vector<ChartEdge>& edges, int64_t width,
                 int64_t height, Random& random) {
  const auto first = static_cast<uint32_t>(vertices.size());
  const auto count = static_cast<uint32_t>(3 + random.below(3));
  const auto turns = static_cast<int64_t>(random.below(3)) - 1;
  std::vector<int64_t> x;
  for (uint32_t i = 0; i < count; ++i) {
    const auto own = static_cast<int64_t>(random.below(static_cast<uint64_t>(width)));
    x.push_back(turns == 0 ? own : own / count + turns * i * width / count);
    vertices.push_back(
        {wrapped_x(x[i], width), static_cast<int64_t>(random.below(static_cast<uint64_t>(height)))});
  }
  for (uint32_t i = 0; i < count; ++i) {
    const int64_t end = i + 1 < count ? x[i + 1] : x[0] + turns * width;
    edges.push_back({first + i, first + (i + 1) % count, end - x[i]});
  }
}

TEST(ChartCrossings, are_found_exactly_for_crossing_or_touching_edges) {
  Meetings all;
  for (uint64_t seed = 1; seed <= runs(60000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int64_t width = 4 + static_cast<int64_t>(random.below(60)), height = 2 + width / 2;
    std::vector<ChartVertex> vertices;
    std::vector<ChartEdge> edges;
    const uint64_t loops = 1 + random.below(3);
    for (uint64_t i = 0; i < loops; ++i) append_loop(vertices, edges, width, height, random);
    if (std::any_of(edges.begin(), edges.end(), [&](const ChartEdge& e) { return std::abs(e.dx) >= width; }))
      continue;
    ASSERT_NO_FATAL_FAILURE(all.count(vertices, edges, width));
  }
  EXPECT_GT(all.meeting, runs(60000) / 5);
  EXPECT_GT(all.apart, runs(60000) / 20);
  expect_most_named(all);
}

// One vertex of loops that are in order is moved anywhere.
TEST(ChartCrossings, are_found_exactly_after_a_vertex_moves) {
  Meetings all;
  for (uint64_t seed = 1; seed <= runs(1200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ChartLattice lattice = random_lattice(random, 0, 1);
    std::vector<ChartEdge> edges = edges_between_cells(lattice);
    if (edges.empty()) continue;
    const uint32_t moved = edges[random.below(edges.size())].from;
    const int64_t reach = ChartLattice::kCell << random.below(3);
    const auto by = [&] {
      return static_cast<int64_t>(random.below(static_cast<uint64_t>(2 * reach + 1))) - reach;
    };
    const int64_t x = by();
    ChartVertex& v = lattice.corners[moved];
    v = {wrapped_x(v.x + x, lattice.width()), v.y + by()};
    for (ChartEdge& e : edges) {
      if (e.to == moved) e.dx += x;
      if (e.from == moved) e.dx -= x;
    }
    if (std::any_of(edges.begin(), edges.end(),
                    [&](const ChartEdge& e) { return std::abs(e.dx) >= lattice.width(); }))
      continue;
    ASSERT_NO_FATAL_FAILURE(all.count(lattice.corners, edges, lattice.width()));
  }
  EXPECT_GT(all.meeting, runs(1200) / 5);
  EXPECT_GT(all.apart, runs(1200) / 20);
  expect_most_named(all);
}

}  // namespace
}  // namespace kerf::test
