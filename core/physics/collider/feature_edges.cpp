#include "core/physics/collider/feature_edges.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace kerf {

namespace {

constexpr double kCreaseCosine = 0.766;  // of 40 degrees

// The ends of edges, sorted by vertex.
struct End {
  VertexId at;
  uint32_t edge;
};

class Ends {
 public:
  explicit Ends(const std::vector<FeatureEdge>& edges) {
    ends_.reserve(2 * edges.size());
    for (uint32_t e = 0; e < edges.size(); ++e) {
      ends_.push_back({edges[e].from, e});
      ends_.push_back({edges[e].to, e});
    }
    std::sort(ends_.begin(), ends_.end(),
              [](const End& a, const End& b) { return std::tie(a.at, a.edge) < std::tie(b.at, b.edge); });
  }
  std::span<const End> at(VertexId v) const {
    const auto [low, high] = std::equal_range(ends_.begin(), ends_.end(), End{v, 0},
                                              [](const End& a, const End& b) { return a.at < b.at; });
    return {low, high};
  }

 private:
  std::vector<End> ends_;
};

// Follows edges from one end until the line branches, ends or closes.
FeatureLine follow(const std::vector<FeatureEdge>& edges, const Ends& ends, uint32_t edge, VertexId start,
                   std::vector<bool>& used) {
  FeatureLine line{start};
  while (true) {
    used[edge] = true;
    const VertexId next = edges[edge].from == line.back() ? edges[edge].to : edges[edge].from;
    line.push_back(next);
    const std::span<const End> there = ends.at(next);
    if (there.size() != 2) return line;
    edge = there[0].edge == edge ? there[1].edge : there[0].edge;
    if (used[edge]) return line;
  }
}

}  // namespace

std::vector<FeatureEdge> feature_edges(const Mesh& mesh, const std::vector<Vec3>& normals) {
  std::vector<FeatureEdge> edges;
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
        edges.push_back({from, to, f, true});
        continue;
      }
      const bool first =
          std::all_of(sides.begin(), sides.end(), [&](const Mesh::Side& s) { return f < s.face; });
      const bool bends = std::any_of(sides.begin(), sides.end(), [&](const Mesh::Side& s) {
        return glm::dot(normals[slot], normals[s.face.index]) < kCreaseCosine;
      });
      if (first && bends) edges.push_back({from, to, f, false});
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
