#include "core/mesh/remesh/remeshed.h"

namespace kerf {

std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh) {
  std::vector<uint16_t> materials;
  materials.reserve(remeshed.origins.size());
  for (const FaceId f : remeshed.origins) materials.push_back(mesh.data(f).material);
  return materials;
}

Result<BuiltMesh> build_remeshed(const Remeshed& remeshed, const Mesh& mesh, const Progress* progress) {
  Soup soup;
  soup.positions = remeshed.positions;
  soup.triangles = remeshed.triangles;
  soup.materials = materials_of(remeshed, mesh);
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return build_mesh(soup, progress);
}

}  // namespace kerf
