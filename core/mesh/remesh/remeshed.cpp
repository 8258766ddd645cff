#include "core/mesh/remesh/remeshed.h"

#include <algorithm>
#include <array>

#include "core/mesh/measures.h"
#include "core/mesh/orientation.h"
#include "core/mesh/weld.h"

namespace kerf {

std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh) {
  std::vector<uint16_t> materials;
  materials.reserve(remeshed.origins.size());
  for (const FaceId f : remeshed.origins) materials.push_back(mesh.data(f).material);
  return materials;
}

namespace {

// Returns the barycentric weights of a point of a triangle; 1 for the first corner if it has no area.
std::array<double, 3> corner_weights(const Vec3& p, const Triangle& t) {
  const double a = triangle_area({p, t[1], t[2]}), b = triangle_area({p, t[2], t[0]}),
               c = triangle_area({p, t[0], t[1]});
  const double sum = a + b + c;
  if (!(sum > 0)) return {1, 0, 0};
  return {a / sum, b / sum, c / sum};
}

VertexColour colour_at(const Vec3& p, const Mesh& mesh, FaceId f) {
  const Triangle t = mesh.triangle(f);
  const std::array<VertexId, 3> v = mesh.corners(f);
  const VertexColours& of = mesh.colours();
  return mix({of.get(v[0]), of.get(v[1]), of.get(v[2])}, corner_weights(nearest_point(p, t), t));
}

}  // namespace

std::vector<VertexColour> colours_of(const Remeshed& remeshed, const Mesh& mesh) {
  std::vector<VertexColour> colours;
  if (mesh.colours().blank()) return colours;
  colours.resize(remeshed.positions.size());
  std::vector<bool> known(colours.size(), false);
  for (size_t t = 0; t < remeshed.triangles.size(); ++t) {
    for (const uint32_t p : remeshed.triangles[t]) {
      if (known[p]) continue;
      known[p] = true;
      colours[p] = colour_at(remeshed.positions[p], mesh, remeshed.origins[t]);
    }
  }
  return colours;
}

Result<BuiltMesh> build_remeshed(const Remeshed& remeshed, const Mesh& mesh, const Progress* progress) {
  Soup soup;
  soup.positions = remeshed.positions;
  soup.colours = colours_of(remeshed, mesh);
  soup.triangles = remeshed.triangles;
  soup.materials = materials_of(remeshed, mesh);
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return build_mesh(soup, progress);
}

namespace {

// Copies the faces over welded positions; drops degenerate ones, which a cut may leave.
Remeshed copy_faces(const Mesh& mesh) {
  std::vector<Vec3> positions(mesh.vertex_slots(), Vec3(0));
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const VertexId v : mesh.corners(FaceId(f))) positions[v.index] = mesh.position(v);
  }
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> number(positions.size(), FaceId::kNone);
  Remeshed copy;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    std::array<uint32_t, 3> at{};
    for (size_t i = 0; i < 3; ++i) at[i] = first[mesh.corners(FaceId(f))[i].index];
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
    for (uint32_t& corner : at) {
      if (number[corner] == FaceId::kNone) {
        number[corner] = static_cast<uint32_t>(copy.positions.size());
        copy.positions.push_back(positions[corner]);
      }
      corner = number[corner];
    }
    copy.triangles.push_back(at);
    copy.origins.push_back(FaceId(f));
  }
  return copy;
}

}  // namespace

Result<Remeshed> turn_shells(const Mesh& mesh, const Progress* progress) {
  Remeshed turned = copy_faces(mesh);
  const SoupEdges edges = group_sides(turned.triangles, turned.positions.size());
  const auto patches = find_patches(turned.triangles, edges, progress);
  if (!patches) return patches.error();
  for (const uint32_t p : overlapping_patches(turned.positions, turned.triangles, *patches)) {
    for (const uint32_t t : patches->triangles_of(p))
      std::swap(turned.triangles[t][0], turned.triangles[t][1]);
  }
  return turned;
}

}  // namespace kerf
