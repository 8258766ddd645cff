#include "core/game/arena/fixed_faces.h"

#include <cmath>

namespace kerf {

std::vector<Triangle> fixed_faces(const Arena& arena) {
  std::vector<Triangle> faces;
  for (const ModelBody& model : arena.bodies) {
    if (!model.body.pinned) continue;
    const Mesh& mesh = model.body.mesh;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      Triangle t = mesh.triangle(FaceId(f));
      for (int corner = 0; corner < 3; ++corner) t[corner] = model.body.placement.to_world(t[corner]);
      faces.push_back(t);
    }
  }
  return faces;
}

bool is_drivable(const Triangle& t) {
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  return std::abs(normal.y) > kDrivable * glm::length(normal);
}

}  // namespace kerf
