#include "ui/render/frame_space.h"

namespace kerf {

namespace {

constexpr double kNear = 0.004;  // of the distance to what is looked at

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

FrameUniforms uniforms_of(const CameraView& view, const FrameSpace& space, int width, int height) {
  FrameUniforms u;
  u.clip_from_frame =
      projection(view.tan_half_fov, view.aspect, kNear * view.focus / space.unit) * rotation(view);
  u.camera_right = glm::vec4(glm::vec3(view.right), static_cast<float>(view.tan_half_fov * view.aspect));
  u.camera_up = glm::vec4(glm::vec3(view.up), static_cast<float>(view.tan_half_fov));
  u.camera_forward = glm::vec4(glm::vec3(view.forward), 0);
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  u.viewport = {w, h, 1 / w, 1 / h};
  return u;
}

}  // namespace kerf
