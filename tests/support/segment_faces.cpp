#include "tests/support/segment_faces.h"

namespace kerf::test {

bool crosses(const Body& body, const Vec3& from, const Vec3& to) {
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    if (!body.mesh.is_live(FaceId(slot))) continue;
    Triangle t = body.mesh.triangle(FaceId(slot));
    for (Vec3& p : t) p = body.placement.to_world(p);
    const Vec3 way = to - from, normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double across = glm::dot(normal, way);
    if (across == 0) continue;
    const double share = glm::dot(normal, t[0] - from) / across;
    if (share < 0 || share > 1) continue;
    const Vec3 p = from + share * way;
    bool inside = true;
    for (size_t i = 0; i < 3; ++i)
      inside = inside && glm::dot(normal, glm::cross(t[(i + 1) % 3] - t[i], p - t[i])) >= 0;
    if (inside) return true;
  }
  return false;
}

}  // namespace kerf::test
