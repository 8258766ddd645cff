#include "core/mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/mesh/face_batches.h"
#include "core/mesh/half_edges_internal.h"
#include "core/mesh/weld.h"

namespace kerf {

Result<Bounds> bounds_of(const Mesh& mesh, const Progress* progress) {
  constexpr size_t kVertices = 1 << 16;  // per range
  const HalfEdges& m = mesh.kernel().half_edges;
  std::vector<Bounds> parts(range_count(m.vertices(), kVertices), Bounds::none());
  const auto bound = [&](size_t first, size_t end) {
    Bounds& bounds = parts[first / kVertices];
    for (auto v = static_cast<uint32_t>(first); v < end; ++v) {
      // A vertex has an edge if and only if it has a face.
      if (m.outgoing(VertexId(v)).valid()) bounds.add(m.position(VertexId(v)));
    }
  };
  if (!for_each_range(m.vertices(), kVertices, progress, bound)) return cancelled();
  Bounds all = Bounds::none();
  for (const Bounds& part : parts) all.add(part);
  return all;
}

namespace {

double distance2_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 apart = p - nearest_on_segment(p, a, b);
  return glm::dot(apart, apart);
}

// Products of six lengths leave the range of doubles for triangles beyond 1e51 m or below 1e-51 m. Returns
// the exponent of the power of two by which such a triangle must be divided; 0 for others. `length2`: squared
// length of its normal.
int exponent_out_of_range(const Triangle& t, double length2) {
  constexpr double kMinPlain = 0x1p-600, kMaxPlain = 0x1p600;  // m^4
  constexpr int kPlainExponents = 128;                         // of faces without area, too
  if (length2 >= kMinPlain && length2 <= kMaxPlain) return 0;
  double longest = 0;
  for (const Vec3& side : {t[1] - t[0], t[2] - t[0]}) {
    for (int k = 0; k < 3; ++k) longest = std::max(longest, std::abs(side[k]));
  }
  if (!(longest > 0) || !std::isfinite(longest)) return 0;
  const int exponent = std::ilogb(longest);
  return std::abs(exponent) < kPlainExponents ? 0 : exponent;
}

Vec3 shifted(const Vec3& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}
Triangle shifted(const Triangle& t, int exponent) {
  return {shifted(t[0], exponent), shifted(t[1], exponent), shifted(t[2], exponent)};
}

constexpr uint32_t kMaxInLeaf = 4;  // triangles

// A tree of boxes over triangles; each node is split along its longest side into halves with equal numbers of
// triangles. The children of node n are n + 1 and Node::second.
class TriangleBoxes {
 public:
  explicit TriangleBoxes(std::span<const Triangle> triangles)
      : triangles_(triangles.begin(), triangles.end()) {
    KERF_ASSERT(!triangles.empty());
    nodes_.reserve(triangles.size());
    build(0, static_cast<uint32_t>(triangles_.size()));
  }

  // Returns the squared distance from a point, or any value up to `enough` if it is at most that.
  double squared_distance_above(const Vec3& p, double enough) {
    double nearest = std::numeric_limits<double>::infinity();
    waiting_.assign(1, {nodes_[0].squared_distance(p), 0});
    while (!waiting_.empty() && nearest > enough) {
      const auto [bound, at] = waiting_.back();
      waiting_.pop_back();
      if (bound >= nearest) continue;
      const Node& node = nodes_[at];
      for (uint32_t i = node.begin; i < node.end; ++i)
        nearest = std::min(nearest, squared_distance(p, triangles_[i]));
      if (node.second == 0) continue;
      std::array<Visit, 2> children{Visit{nodes_[at + 1].squared_distance(p), at + 1},
                                    Visit{nodes_[node.second].squared_distance(p), node.second}};
      if (children[0].bound < children[1].bound) std::swap(children[0], children[1]);
      waiting_.insert(waiting_.end(), children.begin(), children.end());
    }
    return nearest;
  }

 private:
  struct Node {
    Vec3 low, high;
    uint32_t begin = 0, end = 0;  // the triangles of a leaf
    uint32_t second = 0;          // 0: a leaf

    double squared_distance(const Vec3& p) const {
      const Vec3 way = glm::max(glm::max(low - p, p - high), Vec3(0));
      return glm::dot(way, way);
    }
  };
  struct Visit {
    double bound;  // lower bound of the squared distance to the triangles of the node
    uint32_t node;
  };

  uint32_t build(uint32_t begin, uint32_t end) {
    const auto made = static_cast<uint32_t>(nodes_.size());
    Node node{Vec3(std::numeric_limits<double>::infinity()), Vec3(-std::numeric_limits<double>::infinity())};
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& corner : triangles_[i]) {
        node.low = glm::min(node.low, corner);
        node.high = glm::max(node.high, corner);
      }
    }
    nodes_.push_back(node);
    if (end - begin <= kMaxInLeaf) {
      nodes_[made].begin = begin;
      nodes_[made].end = end;
      return made;
    }
    const Vec3 size = node.high - node.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const uint32_t middle = begin + (end - begin) / 2;
    const auto place = [axis](const Triangle& t) { return t[0][axis] + t[1][axis] + t[2][axis]; };
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                     [&](const Triangle& a, const Triangle& b) { return place(a) < place(b); });
    build(begin, middle);
    const uint32_t second = build(middle, end);
    nodes_[made].second = second;
    return made;
  }

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::vector<Visit> waiting_;
};

std::array<Vec3, 7> samples_of(const Triangle& t) {
  return {t[0],
          t[1],
          t[2],
          0.5 * (t[0] + t[1]),
          0.5 * (t[1] + t[2]),
          0.5 * (t[2] + t[0]),
          (t[0] + t[1] + t[2]) / 3.0};
}

// Raises `most` to the squared distance of the sample of `from` farthest from `to`. Returns false if stopped.
bool raise(std::span<const Triangle> from, TriangleBoxes& to, const Progress& progress, double& most) {
  const size_t sampled = std::min(from.size(), kMaxSampled);
  Pace pace(&progress, sampled);
  for (size_t i = 0; i < sampled; ++i) {
    for (const Vec3& p : samples_of(from[i * from.size() / sampled]))
      most = std::max(most, to.squared_distance_above(p, most));
    if (!pace.step()) return false;
  }
  return true;
}

using Corners = std::array<uint32_t, 3>;

// Faces with distinct positions numbered. Omits faces with two corners at one position: their other two sides
// are the same edge in both directions, and they enclose no volume.
struct WeldedFaces {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  std::vector<uint32_t> labels;  // by triangle: FaceData::piece
};

std::vector<FaceId> live_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  faces.reserve(mesh.live_faces());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) faces.push_back(FaceId(f));
  }
  return faces;
}

WeldedFaces weld_faces(const Mesh& mesh, std::span<const FaceId> faces) {
  constexpr uint32_t kNone = 0xffffffffu;
  WeldedFaces welded;
  std::vector<uint32_t> number(mesh.vertex_slots(), kNone);
  const auto number_of = [&](VertexId v) {
    if (number[v.index] == kNone) {
      number[v.index] = static_cast<uint32_t>(welded.positions.size());
      welded.positions.push_back(mesh.position(v));
    }
    return number[v.index];
  };
  for_each_corners(mesh, faces, [&](FaceId f, const std::array<VertexId, 3>& c) {
    welded.triangles.push_back({number_of(c[0]), number_of(c[1]), number_of(c[2])});
    welded.labels.push_back(mesh.data(f).piece);
  });
  const std::vector<uint32_t> first = weld_positions(welded.positions);
  size_t kept = 0;
  for (size_t t = 0; t < welded.triangles.size(); ++t) {
    const Corners c = welded.triangles[t], at = {first[c[0]], first[c[1]], first[c[2]]};
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
    welded.triangles[kept] = at;
    welded.labels[kept++] = welded.labels[t];
  }
  welded.triangles.resize(kept);
  welded.labels.resize(kept);
  return welded;
}

// Returns 1 if the side runs from the lower to the higher number, otherwise -1.
int direction(std::span<const Corners> triangles, uint32_t side) {
  const Corners& corners = triangles[side / 3];
  const uint32_t i = side % 3;
  return corners[i] < corners[i == 2 ? 0 : i + 1] ? 1 : -1;
}

bool is_closed(std::span<const Corners> triangles, const SoupEdges& edges) {
  for (uint32_t e = 0; e < edges.count(); ++e) {
    int sum = 0;
    for (const uint32_t side : edges.sides_of(e)) sum += direction(triangles, side);
    if (sum != 0) return false;
  }
  return !triangles.empty();
}

double signed_volume(std::span<const Vec3> positions, std::span<const Corners> triangles,
                     const Vec3& origin) {
  double sum = 0;
  for (const Corners& c : triangles) {
    const Vec3 p = positions[c[0]] - origin, q = positions[c[1]] - origin, r = positions[c[2]] - origin;
    sum += glm::dot(p, glm::cross(q, r));
  }
  return sum / 6;
}

// A side of an edge: the label of its triangle, and its direction.
using LabelledSide = std::pair<uint32_t, int>;

// Marks labels as open whose sides of one edge do not balance. Sorts the sides.
void record_open(std::vector<LabelledSide>& sides, std::vector<bool>& closed) {
  std::sort(sides.begin(), sides.end());
  for (size_t i = 0; i < sides.size();) {
    const uint32_t label = sides[i].first;
    int sum = 0;
    for (; i < sides.size() && sides[i].first == label; ++i) sum += sides[i].second;
    if (sum != 0) closed[label] = false;
  }
}

}  // namespace

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return a + t * along;
}

double squared_distance(const Vec3& p, const Triangle& t) {
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length2 = glm::dot(normal, normal);
  if (const int exponent = exponent_out_of_range(t, length2); exponent != 0)
    return std::ldexp(squared_distance(shifted(p, -exponent), shifted(t, -exponent)), 2 * exponent);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) nearest = std::min(nearest, distance2_to_segment(p, t[i], t[(i + 1) % 3]));
  if (!(length2 > 0)) return nearest;
  for (int i = 0; i < 3; ++i) {
    if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return nearest;
  }
  const double height = glm::dot(p - t[0], normal);
  return std::min(nearest, height * height / length2);
}

Vec3 nearest_point(const Vec3& p, const Triangle& t) {
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length2 = glm::dot(normal, normal);
  if (const int exponent = exponent_out_of_range(t, length2); exponent != 0)
    return shifted(nearest_point(shifted(p, -exponent), shifted(t, -exponent)), exponent);
  Vec3 nearest = t[0];
  double least = std::numeric_limits<double>::infinity();
  const auto try_point = [&](const Vec3& q) {
    const double distance2 = glm::dot(p - q, p - q);
    if (distance2 >= least) return;
    least = distance2;
    nearest = q;
  };
  for (int i = 0; i < 3; ++i) try_point(nearest_on_segment(p, t[i], t[(i + 1) % 3]));
  if (!(length2 > 0)) return nearest;
  for (int i = 0; i < 3; ++i) {
    if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return nearest;
  }
  try_point(p - (glm::dot(p - t[0], normal) / length2) * normal);
  return nearest;
}

Result<double> surface_distance(std::span<const Triangle> one, std::span<const Triangle> other,
                                const Progress* progress) {
  KERF_ASSERT(!one.empty() && !other.empty());
  ProgressShares shares(progress);
  double most = 0;
  for (const bool back : {false, true}) {
    const Progress half = shares.next(0.5);
    TriangleBoxes boxes(back ? one : other);
    if (!raise(back ? other : one, boxes, half, most)) return cancelled();
  }
  return std::sqrt(most);
}

SurfaceMeasures measure_surface(std::span<const Vec3> positions, std::span<const Corners> triangles) {
  KERF_ASSERT(!positions.empty());
  constexpr double kMinPlain = 0x1p-600;  // m^2; moments of smaller areas lose digits
  const Vec3 origin = positions.front();  // sums far from zero would lose digits
  const auto for_each_area = [&](const auto& use) {
    for (const auto& [a, b, c] : triangles) {
      const Triangle t = {positions[a], positions[b], positions[c]};
      use(triangle_area(t), (t[0] - origin) + (t[1] - origin) + (t[2] - origin));
    }
  };
  double area = 0;
  Vec3 moment(0), mean(0);
  for_each_area([&](double own, const Vec3& corners) {
    area += own;
    moment += own / 3 * corners;
  });
  const bool fits = std::isfinite(moment.x) && std::isfinite(moment.y) && std::isfinite(moment.z);
  if (fits && area >= kMinPlain) {
    mean = moment / area;
  } else if (area > 0) {
    for_each_area([&](double own, const Vec3& corners) { mean += own / area / 3 * corners; });
  }
  return {area, origin + mean};
}

EnclosedVolume enclosed_volume(std::span<const Vec3> positions, std::span<const Corners> triangles,
                               const SoupEdges& edges, const Vec3& origin) {
  KERF_ASSERT(edges.triangles() == triangles.size());
  return {is_closed(triangles, edges), signed_volume(positions, triangles, origin)};
}

EnclosedVolume enclosed_volume(const Mesh& mesh, std::span<const FaceId> faces, const Vec3& origin) {
  const WeldedFaces welded = weld_faces(mesh, faces);
  const SoupEdges edges = group_sides(welded.triangles, welded.positions.size());
  return enclosed_volume(welded.positions, welded.triangles, edges, origin);
}

EnclosedVolume enclosed_volume(const Mesh& mesh, const Vec3& origin) {
  return enclosed_volume(mesh, live_faces(mesh), origin);
}

std::vector<bool> closed_pieces(const Mesh& mesh, uint32_t labels) {
  return closed_pieces(mesh, live_faces(mesh), labels);
}

std::vector<bool> closed_pieces(const Mesh& mesh, std::span<const FaceId> faces, uint32_t labels) {
  const WeldedFaces welded = weld_faces(mesh, faces);
  std::vector<bool> closed(labels, false);
  for (const uint32_t label : welded.labels) {
    KERF_ASSERT(label < labels);
    closed[label] = true;
  }
  const SoupEdges edges = group_sides(welded.triangles, welded.positions.size());
  std::vector<LabelledSide> sides;
  for (uint32_t e = 0; e < edges.count(); ++e) {
    sides.clear();
    for (const uint32_t side : edges.sides_of(e))
      sides.emplace_back(welded.labels[side / 3], direction(welded.triangles, side));
    record_open(sides, closed);
  }
  return closed;
}

}  // namespace kerf
