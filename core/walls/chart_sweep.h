#pragma once

#include <vector>

#include "core/base/resumable.h"
#include "core/walls/chart_region.h"

namespace kerf {

// A sweep of a line over the edges of a region, from x = 0 once around.
class ChartSweep {
 public:
  ChartSweep(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width);

  // Returns whether no edges cross or touch.
  Resumable<bool> run();

  // Otherwise vertices of edges that do.
  const std::vector<uint32_t>& conflict() const { return conflict_; }

  const ChartRegion::Winding& winding() const { return winding_; }
  // Between two vertices that lie on the left and the right end of a trapezoid of winding number 1 and are
  // not joined by a side of it.
  const std::vector<ChartEdge>& diagonals() const { return diagonals_; }

 private:
  // An edge from left to right. Ends before the start of the sweep have x < 0.
  struct Span {
    uint32_t left = 0, right = 0;
    int64_t left_x = 0, right_x = 0;
    int sign = 0;  // what is added to the winding number on the way up across it
  };
  // The left end of a trapezoid: a vertex, or the place in the list of edges at the start of the sweep.
  struct Start {
    uint32_t vertex = 0;
    int64_t x = 0;
    int unknown = -1;
  };
  // An edge that the line meets, and the trapezoid above it.
  struct Active {
    Span span;
    int winding = 0;
    Start start;
  };
  struct Closed {
    int unknown;
    uint32_t vertex;
    int64_t x;
    Span below, above;
  };

  bool start_at_seam();
  bool pass(uint32_t v);
  bool insert_starting(uint32_t v, size_t at, int winding);
  int side_of(const Span& span, int64_t x, int64_t y) const;
  void close(size_t below, uint32_t v);
  void join(const Start& start, uint32_t v, int64_t x, const Span& below, const Span& above);
  bool end_at_seam();
  void note(int winding, uint32_t v);
  bool fail_at(uint32_t v, size_t first, size_t end);

  std::span<const ChartVertex> vertices_;
  int64_t width_;
  std::vector<Span> spans_;
  std::vector<uint32_t> first_, starting_;  // spans by their left vertex
  std::vector<uint32_t> ending_;            // by vertex: the number of spans that end there
  std::vector<uint32_t> order_;             // of vertices
  std::vector<Active> active_;              // from below
  std::vector<Span> at_seam_;
  std::vector<Closed> closed_;  // trapezoids that began before the sweep did
  ChartRegion::Winding winding_;
  std::vector<ChartEdge> diagonals_;
  std::vector<uint32_t> conflict_;
};

}  // namespace kerf
