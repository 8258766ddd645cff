#include "core/physics/collider/feature_edges.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kCreaseCosine = 0.766;  // of 40 degrees

// The edges by the vertices at their ends.
class Ends {
 public:
  explicit Ends(const std::vector<FeatureEdge>& edges) {
    uint32_t vertices = 0;
    for (const FeatureEdge& e : edges) vertices = std::max({vertices, e.from.index + 1, e.to.index + 1});
    first_.resize(size_t{vertices} + 1, 0);
    for (const FeatureEdge& e : edges) {
      ++first_[e.from.index];
      ++first_[e.to.index];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    edges_.resize(2 * edges.size());
    for (auto e = static_cast<uint32_t>(edges.size()); e-- > 0;) {
      edges_[--first_[edges[e].to.index]] = e;
      edges_[--first_[edges[e].from.index]] = e;
    }
  }
  // Ascending. Precondition: an edge ends there.
  std::span<const uint32_t> at(VertexId v) const {
    return std::span(edges_).subspan(first_[v.index], first_[v.index + 1] - first_[v.index]);
  }

 private:
  std::vector<uint32_t> edges_;
  std::vector<uint32_t> first_;  // by vertex, of edges_
};

// Follows edges from one end until the line branches, ends or closes.
FeatureLine follow(const std::vector<FeatureEdge>& edges, const Ends& ends, uint32_t edge, VertexId start,
                   std::vector<bool>& used) {
  KERF_ASSERT(!used[edge] && (edges[edge].from == start || edges[edge].to == start));
  FeatureLine line{start};
  while (true) {
    used[edge] = true;
    const VertexId next = edges[edge].from == line.back() ? edges[edge].to : edges[edge].from;
    line.push_back(next);
    const std::span<const uint32_t> there = ends.at(next);
    if (there.size() != 2) return line;
    edge = there[0] == edge ? there[1] : there[0];
    if (used[edge]) return line;
  }
}

}  // namespace

FeatureEdges feature_edges(const Mesh& mesh, const std::vector<Vec3>& normals) {
  KERF_ASSERT(normals.size() == mesh.face_slots());
  FeatureEdges edges;
  std::vector<Mesh::Side> sides;
  for (uint32_t slot = 0; slot < mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!mesh.is_live(f)) continue;
    const std::array<VertexId, 3> corners = mesh.corners(f);
    for (size_t i = 0; i < 3; ++i) {
      const VertexId from = corners[i], to = corners[(i + 1) % 3];
      sides.clear();
      mesh.append_edge_sides(f, from, to, sides);
      if (sides.empty()) {
        edges.lines.push_back({from, to, f, true});
        continue;
      }
      const bool first =
          std::all_of(sides.begin(), sides.end(), [&](const Mesh::Side& s) { return f < s.face; });
      if (!first) continue;
      const bool bends = std::any_of(sides.begin(), sides.end(), [&](const Mesh::Side& s) {
        return glm::dot(normals[slot], normals[s.face.index]) < kCreaseCosine;
      });
      if (bends || sides.size() > 1) (bends ? edges.lines : edges.seams).push_back({from, to, f, false});
    }
  }
  return edges;
}

std::vector<FeatureLine> joined(const std::vector<FeatureEdge>& edges) {
  const Ends ends(edges);
  std::vector<bool> used(edges.size(), false);
  std::vector<FeatureLine> lines;
  const auto begin_at = [&](uint32_t e, VertexId v) {
    if (!used[e]) lines.push_back(follow(edges, ends, e, v, used));
  };
  for (uint32_t e = 0; e < edges.size(); ++e) {
    if (ends.at(edges[e].from).size() != 2) begin_at(e, edges[e].from);
    if (ends.at(edges[e].to).size() != 2) begin_at(e, edges[e].to);
  }
  for (uint32_t e = 0; e < edges.size(); ++e) begin_at(e, edges[e].from);
  return lines;
}

}  // namespace kerf
