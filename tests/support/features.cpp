#include "tests/support/features.h"

#include <vector>

namespace kerf::test {

Place place(const Vec3& p) { return {p.x, p.y, p.z}; }

std::set<std::pair<Place, Place>> feature_edges(const Mesh& mesh) {
  std::set<std::pair<Place, Place>> all;
  std::vector<Mesh::Side> sides;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const auto c = mesh.corners(FaceId(f));
    for (size_t i = 0; i < 3; ++i) {
      const VertexId from = c[i], to = c[(i + 1) % 3];
      sides.clear();
      mesh.append_edge_sides(FaceId(f), from, to, sides);
      const bool inner = sides.size() == 1 && sides[0].from == to && sides[0].to == from &&
                         mesh.data(sides[0].face).material == mesh.data(FaceId(f)).material;
      if (inner) continue;
      std::pair edge(place(mesh.position(from)), place(mesh.position(to)));
      if (edge.second < edge.first) std::swap(edge.first, edge.second);
      all.insert(edge);
    }
  }
  return all;
}

Soup in_two_materials(Soup soup) {
  for (const auto& t : soup.triangles) soup.materials.push_back(soup.positions[t[0]].x > 0.05);
  soup.material_names = {"red", "blue"};
  return soup;
}

}  // namespace kerf::test
