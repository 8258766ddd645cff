#include "core/mesh/remesh/turn_shells.h"

#include <algorithm>

#include "core/mesh/orient.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

// The faces over welded positions; those with two corners at one position, which a cut may leave, are left
// out.
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
