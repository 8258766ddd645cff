#include "core/document/extract.h"

#include <algorithm>
#include <cassert>

#include "core/graph/separation.h"
#include "core/mesh/soup_edges.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

// The vertices of the faces, ascending and without repeats.
std::vector<VertexId> vertices_of(const Mesh& mesh, std::span<const FaceId> faces) {
  std::vector<VertexId> vertices;
  vertices.reserve(3 * faces.size());
  for (const FaceId f : faces) {
    const auto c = mesh.corners(f);
    vertices.insert(vertices.end(), c.begin(), c.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void measure(Extract& out) {
  double weight = 0;
  Vec3 sum{0};
  for (const auto& t : out.triangles) {
    const Triangle corners = {out.positions[t[0]], out.positions[t[1]], out.positions[t[2]]};
    const double area = triangle_area(corners);
    out.area += area;
    // Relative to the first vertex, so that a mesh far from the origin loses no precision.
    sum +=
        area / 3 *
        ((corners[0] - out.positions[0]) + (corners[1] - out.positions[0]) + (corners[2] - out.positions[0]));
    weight += area;
  }
  out.centroid = out.positions[0] + (weight > 0 ? sum / weight : Vec3(0));
  const SoupEdges edges = group_sides(out.triangles, out.positions.size());
  for (uint32_t e = 0; e < edges.count(); ++e) out.boundary_edges += edges.sides_of(e).size() == 1;
}

}  // namespace

Extract extract_faces(const Body& body, std::span<const FaceId> faces) {
  Extract out;
  if (faces.empty()) return out;
  assert(std::is_sorted(faces.begin(), faces.end()));
  const std::vector<VertexId> vertices = vertices_of(body.mesh, faces);
  std::vector<Vec3> positions;
  positions.reserve(vertices.size());
  for (const VertexId v : vertices) positions.push_back(body.placement.to_world(body.mesh.position(v)));
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> number(positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (first[i] != i) continue;
    number[i] = static_cast<uint32_t>(out.positions.size());
    out.positions.push_back(positions[i]);
  }
  const auto number_of = [&](VertexId v) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin();
    assert(vertices[static_cast<size_t>(at)] == v);
    return number[first[static_cast<size_t>(at)]];
  };
  for (const FaceId f : faces) {
    const auto c = body.mesh.corners(f);
    out.triangles.push_back({number_of(c[0]), number_of(c[1]), number_of(c[2])});
    if (!body.material_names.empty()) out.materials.push_back(body.mesh.data(f).material);
  }
  measure(out);
  return out;
}

std::vector<std::vector<FaceId>> faces_by_piece(const Body& body, bool every_component) {
  std::vector<std::vector<FaceId>> groups;
  std::vector<uint32_t> component;
  if (every_component) {
    groups.resize(label_components(body.mesh, component));
  } else {
    groups.resize(body.pieces.size());
  }
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    groups[every_component ? component[f] : body.mesh.data(FaceId(f)).piece].push_back(FaceId(f));
  }
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

}  // namespace kerf
