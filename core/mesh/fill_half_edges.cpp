#include "core/mesh/fill_half_edges.h"

#include <cassert>

#include "core/base/parallel.h"
#include "core/mesh/vertex_fans.h"

namespace kerf {

namespace {

constexpr size_t kTrianglesTogether = 1 << 14;  // a range

class HalfEdgeFilling {
 public:
  HalfEdgeFilling(HalfEdges& half_edges, std::span<const std::array<uint32_t, 3>> triangles,
                  std::span<const uint32_t> partner, std::span<const uint32_t> last_side)
      : m_(half_edges), triangles_(triangles), partner_(partner), last_side_(last_side) {}

  Result<std::vector<HalfEdgeId>> run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress naming = shares.next(0.3), linking = shares.next(0.7);
    const uint32_t edges = count_edges();
    m_.grow_to(static_cast<uint32_t>(last_side_.size()), edges, static_cast<uint32_t>(triangles_.size()));
    half_edge_.resize(partner_.size());
    const auto name = [&](size_t t, size_t end) { name_edges(t, end); };
    if (!for_each_range(triangles_.size(), kTrianglesTogether, &naming, name)) return cancelled();
    const auto link = [&](size_t t, size_t end) {
      for (; t < end; ++t) link_triangle(static_cast<uint32_t>(t));
    };
    if (!for_each_range(triangles_.size(), kTrianglesTogether, &linking, link)) return cancelled();
    for_each_range(last_side_.size(), kTrianglesTogether, [&](size_t v, size_t end) {
      for (; v < end; ++v) m_.set_outgoing(VertexId(static_cast<uint32_t>(v)), half_edge_[last_side_[v]]);
    });
    close_boundaries();
    return std::move(half_edge_);
  }

 private:
  // Whether the side names its edge, i.e. is the lower of its two.
  bool names_edge(size_t side) const { return partner_[side] == kNoSide || partner_[side] > side; }

  uint32_t count_edges() {
    edges_before_.assign(range_count(triangles_.size(), kTrianglesTogether) + 1, 0);
    for_each_range(triangles_.size(), kTrianglesTogether, [&](size_t t, size_t end) {
      uint32_t edges = 0;
      for (size_t s = 3 * t; s < 3 * end; ++s) edges += names_edge(s);
      edges_before_[t / kTrianglesTogether + 1] = edges;
    });
    for (size_t r = 1; r < edges_before_.size(); ++r) edges_before_[r] += edges_before_[r - 1];
    return edges_before_.back();
  }

  void name_edges(size_t triangle, size_t end) {
    uint32_t edge = edges_before_[triangle / kTrianglesTogether];
    for (size_t s = 3 * triangle; s < 3 * end; ++s) {
      if (!names_edge(s)) continue;
      half_edge_[s] = half_edge(EdgeId(edge++), 0);
      if (partner_[s] != kNoSide) half_edge_[partner_[s]] = opposite(half_edge_[s]);
    }
  }

  void link_triangle(uint32_t t) {
    const size_t s = 3 * size_t{t};
    const std::array<VertexId, 3> corners = {VertexId(triangles_[t][0]), VertexId(triangles_[t][1]),
                                             VertexId(triangles_[t][2])};
    m_.set_face_sides(FaceId(t), {half_edge_[s], half_edge_[s + 1], half_edge_[s + 2]}, corners);
    for (size_t i = 0; i < 3; ++i) {
      if (partner_[s + i] == kNoSide) m_.set_open(opposite(half_edge_[s + i]), corners[i]);
    }
  }

  // A vertex has one fan, so that at most one boundary half-edge starts there; it continues the boundary.
  void close_boundaries() {
    std::vector<HalfEdgeId> outer;
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (partner_[s] == kNoSide) outer.push_back(opposite(half_edge_[s]));
    }
    if (outer.empty()) return;
    std::vector<HalfEdgeId> starts(last_side_.size());
    for (const HalfEdgeId h : outer) starts[m_.from(h).index] = h;
    for (const HalfEdgeId h : outer) {
      assert(starts[m_.to(h).index].valid());
      m_.link(h, starts[m_.to(h).index]);
    }
  }

  HalfEdges& m_;
  std::span<const std::array<uint32_t, 3>> triangles_;
  std::span<const uint32_t> partner_, last_side_;
  std::vector<uint32_t> edges_before_;  // by range of triangles
  std::vector<HalfEdgeId> half_edge_;   // by side
};

}  // namespace

Result<std::vector<HalfEdgeId>> fill_half_edges(HalfEdges& half_edges,
                                                std::span<const std::array<uint32_t, 3>> triangles,
                                                std::span<const uint32_t> partner,
                                                std::span<const uint32_t> last_side,
                                                const Progress* progress) {
  assert(half_edges.faces() == 0 && partner.size() == 3 * triangles.size());
  return HalfEdgeFilling(half_edges, triangles, partner, last_side).run(progress);
}

}  // namespace kerf
