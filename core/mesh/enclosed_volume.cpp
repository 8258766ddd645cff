#include "core/mesh/enclosed_volume.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/assert.h"
#include "core/mesh/triangle_batch.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

using Corners = std::array<uint32_t, 3>;

// Faces by the numbers of the distinct positions of their corners. Faces with two corners at one position are
// left out: their other two sides are the same edge in both directions, and they enclose nothing.
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

// 1 where the side runs from the lesser to the greater number, otherwise -1.
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

// Notes as open the labels whose sides of one edge do not balance. Sorts the sides.
void note_open(std::vector<LabelledSide>& sides, std::vector<bool>& closed) {
  std::sort(sides.begin(), sides.end());
  for (size_t i = 0; i < sides.size();) {
    const uint32_t label = sides[i].first;
    int sum = 0;
    for (; i < sides.size() && sides[i].first == label; ++i) sum += sides[i].second;
    if (sum != 0) closed[label] = false;
  }
}

}  // namespace

EnclosedVolume enclosed_volume(std::span<const Vec3> positions, std::span<const Corners> triangles,
                               const SoupEdges& edges, const Vec3& origin) {
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
  const WeldedFaces welded = weld_faces(mesh, live_faces(mesh));
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
    note_open(sides, closed);
  }
  return closed;
}

}  // namespace kerf
