#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/walls/chart_region_internal.h"

namespace kerf::test {

// Directed edges on a ring between cells of a lattice, with the larger number of windings on their left.
// Moving its corners by less than a fourth of a cell keeps every cell convex, so that no edges cross.
struct ChartLattice {
  static constexpr int64_t kCell = 1024;

  int columns = 0, rows = 0;
  std::vector<int> windings;  // by cell, row by row
  int above = 0;
  std::vector<ChartVertex> corners;  // one row more than of cells
  std::vector<int64_t> unwrapped;    // x of the corners as it was before it was wrapped
  int64_t lean = 0;                  // by how much each row is further to the right than the one below

  int64_t width() const { return columns * kCell; }
  int column(int i) const { return (i + columns) % columns; }
  int winding(int i, int j) const {
    if (j < 0) return 0;
    return j < rows ? windings[static_cast<size_t>(j * columns + column(i))] : above;
  }
  uint32_t corner(int i, int j) const { return static_cast<uint32_t>(j * columns + column(i)); }
  ChartRegion region(const std::vector<ChartEdge>& edges) const { return {corners, edges, width()}; }
};

inline int64_t wrapped_x(int64_t x, int64_t width) { return ((x % width) + width) % width; }

// A lattice of which rectangles of cells were raised or lowered: some reach all around, and some to the upper
// end. The numbers of neighbours differ by one at most, and lie between the limits.
ChartLattice random_lattice(Random& random, int least, int largest);

std::vector<ChartEdge> edges_between_cells(const ChartLattice& lattice);

}  // namespace kerf::test
