#include "ui/render/frame_space.h"

#include <limits>

namespace kerf {

namespace {

constexpr double kNear = 0.004;  // of the distance to what is looked at
constexpr double kRoom = 0.7;    // of the least depth that is seen

glm::mat4 projection(double tan_half_fov, double aspect, double near) {
  glm::dmat4 p(0);
  p[0][0] = 1 / (tan_half_fov * aspect);
  p[1][1] = 1 / tan_half_fov;
  p[2][2] = -1;
  p[2][3] = -1;
  p[3][2] = -2 * near;
  return glm::mat4(p);
}

glm::mat4 rotation(const CameraView& view) {
  const glm::dmat3 rows(view.right, view.up, -view.forward);
  return glm::mat4(glm::mat3(glm::transpose(rows)));
}

}  // namespace

double near_plane(const CameraView& view, const World::Bounds& drawn, double ground) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? drawn.max.x : drawn.min.x, i & 2 ? drawn.max.y : drawn.min.y,
                      i & 4 ? drawn.max.z : drawn.min.z);
    least = std::min(least, glm::dot(corner - view.eye, view.forward));
  }
  for (const double y : {-1.0, 1.0}) {
    const double rise =
        view.forward.y + view.tan_half_fov * (y * view.up.y - view.aspect * std::abs(view.right.y));
    if (rise < 0 && view.eye.y > ground) least = std::min(least, (ground - view.eye.y) / rise);
  }
  return std::max(kNear * view.focus, kRoom * least);
}

FrameUniforms uniforms_of(const CameraView& view, double near, const FrameSpace& space, int width,
                          int height) {
  FrameUniforms u;
  u.clip_from_frame = projection(view.tan_half_fov, view.aspect, near / space.unit) * rotation(view);
  u.camera_right = glm::vec4(glm::vec3(view.right), static_cast<float>(view.tan_half_fov * view.aspect));
  u.camera_up = glm::vec4(glm::vec3(view.up), static_cast<float>(view.tan_half_fov));
  u.camera_forward = glm::vec4(glm::vec3(view.forward), 0);
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  u.viewport = {w, h, 1 / w, 1 / h};
  return u;
}

}  // namespace kerf
