#include "core/physics/contact/collider_features.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kCreaseCosine = 0.766;  // cos(40 degrees)

// Edges by the vertices at their ends.
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
  // Returns indices of edges, ascending. Precondition: an edge ends there.
  std::span<const uint32_t> at(VertexId v) const {
    return std::span(edges_).subspan(first_[v.index], first_[v.index + 1] - first_[v.index]);
  }

 private:
  std::vector<uint32_t> edges_;
  std::vector<uint32_t> first_;  // by vertex: index in edges_
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

namespace {

double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a, to = p - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(to, along) / length2, 0.0, 1.0) : 0;
  const Vec3 off = to - t * along;
  return glm::dot(off, off);
}

}  // namespace

std::vector<double> left_out_from(const std::vector<Vec3>& line, double least_error) {
  KERF_ASSERT(least_error >= 0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (line.size() < 3) return std::vector<double>(line.size(), kInfinity);
  std::vector<double> from(line.size(), 0);
  from.front() = from.back() = kInfinity;
  struct Part {
    size_t first, last;
    double most;  // the part is not divided for larger squared errors
  };
  std::vector<Part> parts{{0, line.size() - 1, kInfinity}};
  bool must_divide = line.front() == line.back();
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    size_t farthest = part.first;
    double most = must_divide ? 0 : least_error * least_error;
    for (size_t i = part.first + 1; i < part.last; ++i) {
      const double d = squared_distance_to_segment(line[i], line[part.first], line[part.last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    if (farthest != part.first) {
      from[farthest] = must_divide ? kInfinity : std::min(part.most, most);
      parts.push_back({part.first, farthest, from[farthest]});
      parts.push_back({farthest, part.last, from[farthest]});
    }
    must_divide = false;
  }
  return from;
}

std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error) {
  const std::vector<double> from = left_out_from(line, error);
  std::vector<Vec3> few;
  for (size_t i = 0; i < line.size(); ++i) {
    if (from[i] > error * error) few.push_back(line[i]);
  }
  return few;
}

void select_spread_points(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& selected) {
  if (points.empty()) return;
  std::vector<double> apart(points.size(), std::numeric_limits<double>::infinity());
  const auto measure_from = [&](uint32_t c) {
    KERF_ASSERT(c < points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3 d = points[i] - points[c];
      apart[i] = std::min(apart[i], glm::dot(d, d));
    }
  };
  for (uint32_t c : selected) measure_from(c);
  while (selected.size() < most) {
    const auto farthest = std::max_element(apart.begin(), apart.end());
    if (!(*farthest > 0)) return;
    selected.push_back(static_cast<uint32_t>(farthest - apart.begin()));
    measure_from(selected.back());
  }
}

void select_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& selected) {
  if (points.empty()) return;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (std::abs(x) + std::abs(y) + std::abs(z) == 2 || (x == 0 && y == 0 && z == 0)) continue;
        const Vec3 way(x, y, z);
        uint32_t best = 0;
        for (uint32_t i = 1; i < points.size(); ++i) {
          if (glm::dot(points[i], way) > glm::dot(points[best], way)) best = i;
        }
        if (std::find(selected.begin(), selected.end(), best) == selected.end()) selected.push_back(best);
      }
    }
  }
}

}  // namespace kerf
