#include "tests/core/walls/chart_lattice.h"

#include <algorithm>
#include <cstdlib>

namespace kerf::test {

namespace {

void place_corners(ChartLattice& lattice, int64_t shift_x, int64_t shift_y, Random& random) {
  const auto shift = [&](int64_t most) {
    return static_cast<int64_t>(random.below(static_cast<uint64_t>(2 * most + 1))) - most;
  };
  for (int j = 0; j <= lattice.rows; ++j) {
    for (int i = 0; i < lattice.columns; ++i) {
      const int64_t x = i * ChartLattice::kCell + j * lattice.lean + shift(shift_x);
      lattice.unwrapped.push_back(x);
      lattice.corners.push_back({wrapped_x(x, lattice.width()), j * ChartLattice::kCell + shift(shift_y)});
    }
  }
}

}  // namespace

ChartLattice random_lattice(Random& random, int least, int largest) {
  ChartLattice lattice;
  lattice.columns = 8 + static_cast<int>(random.below(10));
  lattice.rows = 3 + static_cast<int>(random.below(10));
  lattice.windings.resize(static_cast<size_t>(lattice.columns * lattice.rows));
  const auto is_fine = [&] {
    for (int j = 0; j <= lattice.rows; ++j) {
      for (int i = 0; i < lattice.columns; ++i) {
        const int own = lattice.winding(i, j);
        if (own < least || own > largest || std::abs(own - lattice.winding(i - 1, j)) > 1 ||
            std::abs(own - lattice.winding(i, j - 1)) > 1)
          return false;
      }
    }
    return true;
  };
  const auto below = [&](int n) { return static_cast<int>(random.below(static_cast<uint64_t>(n))); };
  const int rectangles = 5 + below(40);
  for (int n = 0; n < rectangles; ++n) {
    const ChartLattice before = lattice;
    const int i0 = below(lattice.columns), j0 = below(lattice.rows), tall = 1 + below(lattice.rows);
    const int wide = below(6) == 0 ? lattice.columns : 1 + below(lattice.columns / 2);
    const int by = below(2) == 0 ? 1 : -1;
    for (int j = j0; j < std::min(j0 + tall, lattice.rows); ++j) {
      for (int i = i0; i < i0 + wide; ++i)
        lattice.windings[static_cast<size_t>(j * lattice.columns + lattice.column(i))] += by;
    }
    if (wide == lattice.columns && j0 + tall > lattice.rows) lattice.above += by;
    if (!is_fine()) lattice = before;
  }
  constexpr int64_t kShifts[] = {0, 0, 3, 250};
  lattice.lean = below(3) == 0 ? below(3000) - 1500 : 0;
  place_corners(lattice, kShifts[below(4)], kShifts[below(4)], random);
  return lattice;
}

std::vector<ChartEdge> edges_between_cells(const ChartLattice& lattice) {
  std::vector<ChartEdge> edges;
  const auto add = [&](int i0, int j0, int i1, int j1, int left, int right) {
    if (left == right) return;
    uint32_t from = lattice.corner(i0, j0), to = lattice.corner(i1, j1);
    int64_t dx = lattice.unwrapped[to] - lattice.unwrapped[from];
    if (i1 >= lattice.columns) dx += lattice.width();
    if (left < right) {
      std::swap(from, to);
      dx = -dx;
    }
    edges.push_back({from, to, dx});
  };
  for (int j = 0; j <= lattice.rows; ++j) {
    for (int i = 0; i < lattice.columns; ++i) {
      add(i, j, i + 1, j, lattice.winding(i, j), lattice.winding(i, j - 1));
      if (j < lattice.rows) add(i, j, i, j + 1, lattice.winding(i - 1, j), lattice.winding(i, j));
    }
  }
  return edges;
}

}  // namespace kerf::test
