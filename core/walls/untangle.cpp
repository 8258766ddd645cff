#include "core/walls/untangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/mesh/mesh.h"

namespace kerf {

namespace {

constexpr int kMostCuts = 256;

// The edges before and after a vertex through which a rim goes once.
struct Passage {
  size_t in, out;
};

std::optional<Passage> passage(const std::vector<ChartEdge>& edges, uint32_t v) {
  std::optional<size_t> in, out;
  for (size_t i = 0; i < edges.size(); ++i) {
    for (const auto& [end, edge] : {std::pair(edges[i].to, &in), std::pair(edges[i].from, &out)}) {
      if (end != v) continue;
      if (*edge) return std::nullopt;
      *edge = i;
    }
  }
  if (!in || !out) return std::nullopt;
  return Passage{*in, *out};
}

// The edge from the end of a passage to its start, which makes a triangle of the three.
std::optional<size_t> closing_edge(const std::vector<ChartEdge>& edges, const Passage& p) {
  for (size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].from == edges[p.out].to && edges[i].to == edges[p.in].from) return i;
  }
  return std::nullopt;
}

void cut(std::vector<ChartEdge>& edges, const Passage& p) {
  std::vector<size_t> gone{p.out};
  if (const auto third = closing_edge(edges, p)) {
    gone.insert(gone.end(), {p.in, *third});
  } else {
    edges[p.in].dx += edges[p.out].dx;
    edges[p.in].to = edges[p.out].to;
  }
  std::sort(gone.begin(), gone.end());
  for (size_t i = gone.size(); i-- > 0;) edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(gone[i]));
}

}  // namespace

Resumable<std::optional<ChartRegion::Winding>> untangle(
    RimInChart& rim, double highest, const std::function<bool(uint32_t, uint32_t)>& are_joined,
    std::vector<std::array<uint32_t, 3>>& cut_off, std::vector<uint32_t>& conflict) {
  KERF_ASSERT(rim.placed.size() == rim.at.size() && highest >= 0);
  for (int i = 0; i < kMostCuts; ++i) {
    const auto winding = co_await ChartRegion(rim.placed, rim.edges, rim.width).winding(&conflict);
    if (winding) co_return winding;
    std::optional<Passage> best;
    double least = std::numeric_limits<double>::infinity();
    for (const uint32_t v : conflict) {
      const auto p = passage(rim.edges, v);
      if (!p) continue;
      const uint32_t a = rim.edges[p->in].from, c = rim.edges[p->out].to;
      if (a == c) continue;
      const Triangle t{rim.at[a], rim.at[v], rim.at[c]};
      const double area = triangle_area(t), height = 2 * area / std::sqrt(longest_edge2(t));
      if (!(height <= highest) || !(area < least)) continue;
      if (are_joined(a, c) && !closing_edge(rim.edges, *p)) continue;
      best = p;
      least = area;
    }
    if (!best) co_return std::nullopt;
    cut_off.push_back({rim.edges[best->in].from, rim.edges[best->in].to, rim.edges[best->out].to});
    cut(rim.edges, *best);
  }
  co_return std::nullopt;
}

}  // namespace kerf
