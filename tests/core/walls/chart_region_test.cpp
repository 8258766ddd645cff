#include "core/walls/chart_region_internal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "tests/core/walls/chart_lattice.h"
#include "tests/support/runs.h"

namespace kerf::test {
namespace {

// Makes one edge of two that are equal and follow each other, where nothing else is at the vertex between.
void join_straight_edges(std::vector<ChartEdge>& edges, std::span<const ChartVertex> vertices,
                         int64_t width) {
  for (bool joined = true; joined;) {
    joined = false;
    std::map<uint32_t, std::vector<size_t>> at;
    for (size_t i = 0; i < edges.size(); ++i) {
      at[edges[i].from].push_back(i);
      at[edges[i].to].push_back(i);
    }
    for (const auto& [v, own] : at) {
      if (own.size() != 2) continue;
      const bool first = edges[own[0]].to == v;
      ChartEdge &in = edges[own[first ? 0 : 1]], &out = edges[own[first ? 1 : 0]];
      if (in.to != v || out.from != v) continue;
      const int64_t in_dy = vertices[v].y - vertices[in.from].y, out_dy = vertices[out.to].y - vertices[v].y;
      if (doubled_area(in.dx, in_dy, out.dx, out_dy) != 0 || std::abs(in.dx + out.dx) >= width) continue;
      in.to = out.to;
      in.dx += out.dx;
      edges.erase(edges.begin() + (&out - edges.data()));
      joined = true;
      break;
    }
  }
}

// Twice the area on the left of the edges.
Wide enclosed_area(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges) {
  Wide area = 0;
  for (const ChartEdge& e : edges) area -= static_cast<Wide>(vertices[e.from].y + vertices[e.to].y) * e.dx;
  return area;
}

void expect_covers(const std::vector<ChartTriangle>& triangles, std::span<const ChartVertex> vertices,
                   std::span<const ChartEdge> edges, int64_t width) {
  Wide area = 0;
  using Side = std::tuple<uint32_t, uint32_t, int64_t>;  // the third is by how much x grows along it
  std::map<Side, int> sides, boundary;
  for (const ChartEdge& e : edges) ++boundary[{e.from, e.to, e.dx}];
  for (const ChartTriangle& t : triangles) {
    std::array<int64_t, 3> y{};
    for (size_t k = 0; k < 3; ++k) {
      ASSERT_EQ((t.x[k] - vertices[t.corners[k]].x) % width, 0);
      y[k] = vertices[t.corners[k]].y;
      const size_t next = (k + 1) % 3;
      ++sides[{t.corners[k], t.corners[next], t.x[next] - t.x[k]}];
    }
    const Wide own = doubled_area(t.x[1] - t.x[0], y[1] - y[0], t.x[2] - t.x[0], y[2] - y[0]);
    ASSERT_TRUE(own > 0) << "a triangle without area, or turned over";
    area += own;
  }
  EXPECT_TRUE(area == enclosed_area(vertices, edges));
  for (const auto& [side, times] : boundary) {
    ASSERT_EQ(times, 1);
    ASSERT_EQ(sides[side], 1) << "an edge of the boundary has not one triangle";
  }
  for (const auto& [side, times] : sides) {
    const auto& [from, to, dx] = side;
    ASSERT_EQ(times, 1) << "a side is used twice";
    if (!boundary.contains(side)) ASSERT_TRUE(sides.contains({to, from, -dx}));
  }
}

TEST(ChartRegion, is_triangulated_between_its_loops) {
  size_t triangulated = 0, wrapping = 0;
  for (uint64_t seed = 1; seed <= runs(4000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ChartLattice lattice = random_lattice(random, 0, 1);
    std::vector<ChartEdge> edges = edges_between_cells(lattice);
    if (random.below(2) == 0) join_straight_edges(edges, lattice.corners, lattice.width());
    const auto triangles = run_to_completion(lattice.region(edges).triangles());
    if (lattice.above != 0) {
      ASSERT_FALSE(triangles) << "it has no upper end";
      continue;
    }
    ASSERT_TRUE(triangles);
    ASSERT_NO_FATAL_FAILURE(expect_covers(*triangles, lattice.corners, edges, lattice.width()));
    triangulated += !triangles->empty();
    for (int j = 0; j < lattice.rows; ++j) {
      int filled = 0;
      for (int i = 0; i < lattice.columns; ++i) filled += lattice.winding(i, j);
      if (filled < lattice.columns) continue;
      ++wrapping;
      break;
    }
  }
  EXPECT_GT(triangulated, runs(4000) / 2);
  EXPECT_GT(wrapping, runs(4000) / 20);
}

// How often the edges wind around a point: those that cross the ray from it downwards.
int count_windings(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width,
                   const ChartVertex& p) {
  int windings = 0;
  for (const ChartEdge& e : edges) {
    for (int64_t turn = -2; turn <= 2; ++turn) {
      const int64_t from = vertices[e.from].x + turn * width, to = from + e.dx;
      const bool forward = from <= p.x && p.x < to, back = to <= p.x && p.x < from;
      if (!forward && !back) continue;
      const int64_t dy = vertices[e.to].y - vertices[e.from].y;
      const Wide side = doubled_area(e.dx, dy, p.x - from, p.y - vertices[e.from].y);
      if (forward && side > 0) ++windings;
      if (back && side < 0) --windings;
    }
  }
  return windings;
}

TEST(ChartRegion, winding_number_matches_ray_crossings) {
  size_t above = 0;
  for (uint64_t seed = 1; seed <= runs(1200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ChartLattice lattice = random_lattice(random, -2, 3);
    for (ChartVertex& v : lattice.corners) v = {4 * v.x, 4 * v.y};  // the middle of a cell is a whole number
    for (int64_t& x : lattice.unwrapped) x *= 4;
    std::vector<ChartEdge> edges;
    for (ChartEdge e : edges_between_cells(lattice)) {
      const int64_t turns = e.dx - (lattice.unwrapped[e.to] - lattice.unwrapped[e.from]);
      edges.push_back({e.from, e.to, e.dx + 3 * turns});  // the width is four times as large, too
    }
    const int64_t width = 4 * lattice.width();
    const auto winding = run_to_completion(ChartRegion(lattice.corners, edges, width).winding());
    ASSERT_TRUE(winding);
    int least = 0, largest = 0;
    for (int j = 0; j <= lattice.rows; ++j) {
      for (int i = 0; i < lattice.columns; ++i) {
        const uint32_t corner = lattice.corner(i, std::min(j, lattice.rows));
        ChartVertex p{0, 4 * (lattice.rows + 1) * ChartLattice::kCell};
        if (j < lattice.rows) {
          p.y = 0;
          for (const uint32_t v :
               {corner, lattice.corner(i + 1, j), lattice.corner(i, j + 1), lattice.corner(i + 1, j + 1)}) {
            p.x += lattice.unwrapped[v] / 4 +
                   (i + 1 == lattice.columns && v % lattice.columns == 0 ? width / 4 : 0);
            p.y += lattice.corners[v].y / 4;
          }
          p.x = wrapped_x(p.x, width);
        }
        const int counted = count_windings(lattice.corners, edges, width, p);
        ASSERT_EQ(counted, lattice.winding(i, j)) << "at " << i << ' ' << j;
        least = std::min(least, counted);
        largest = std::max(largest, counted);
      }
    }
    EXPECT_EQ(winding->least, least);
    EXPECT_EQ(winding->largest, largest);
    EXPECT_EQ(winding->above, lattice.above);
    above += lattice.above != 0;
    const bool is_region = least == 0 && largest <= 1 && lattice.above == 0;
    EXPECT_EQ(run_to_completion(ChartRegion(lattice.corners, edges, width).triangles()).has_value(),
              is_region);
  }
  EXPECT_GT(above, runs(1200) / 20);
}

// Two squares, one in the other, both counter-clockwise.
TEST(ChartRegion, names_a_vertex_if_covered_twice) {
  const std::vector<ChartVertex> vertices{{0, 0},   {90, 0},  {90, 90}, {0, 90},
                                          {30, 30}, {60, 30}, {60, 60}, {30, 60}};
  std::vector<ChartEdge> edges;
  for (const uint32_t first : {0u, 4u}) {
    for (uint32_t i = 0; i < 4; ++i) {
      const uint32_t from = first + i, to = first + (i + 1) % 4;
      edges.push_back({from, to, vertices[to].x - vertices[from].x});
    }
  }
  const ChartRegion region(vertices, edges, 1000);
  const auto winding = run_to_completion(region.winding());
  ASSERT_TRUE(winding);
  EXPECT_EQ(winding->largest, 2);
  EXPECT_EQ(winding->largest_at, 4u);
  std::vector<uint32_t> conflict;
  EXPECT_FALSE(run_to_completion(region.triangles(&conflict)));
  EXPECT_EQ(conflict, std::vector<uint32_t>{4});
}

}  // namespace
}  // namespace kerf::test
