#include "ui/editor/light/light_handle.h"

#include <imgui.h>

#include <cmath>

#include "ui/editor/shared/picture/gizmo.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kReach = 12;     // screen coordinates around a handle that belong to it
constexpr double kSphere = 0.72;  // its radius, of half the height of the picture

// Around what is looked at, as large as always fits the picture.
struct Sphere {
  Vec3 middle;
  double radius;
};
Sphere sphere_of(const CameraView& view) {
  return {view.eye + view.forward * view.focus, kSphere * view.half_height()};
}

Vec3 place_of(const Light& light, const CameraView& view) {
  if (light.kind == Light::Kind::kPoint) return light.at;
  const Sphere sphere = sphere_of(view);
  return sphere.middle + glm::normalize(light.at) * sphere.radius;
}

}  // namespace

std::optional<Vec2> light_handle(const ViewState& view, size_t light) {
  if (light >= view.look.lights.size()) return std::nullopt;
  const FirstPicture picture(view);
  const auto at = picture.place_of(place_of(view.look.lights[light], picture.camera()));
  return at && view.layout.first.contains(*at) ? at : std::nullopt;
}

std::optional<size_t> light_under(const ViewState& view, Vec2 at) {
  for (size_t i = 0; i < view.look.lights.size(); ++i) {
    const std::optional<Vec2> handle = light_handle(view, i);
    if (handle && glm::length(*handle - at) < kReach) return i;
  }
  return std::nullopt;
}

void drag_light(ViewState& view, size_t light, Vec2 to) {
  if (light >= view.look.lights.size()) return;
  Light& dragged = view.look.lights[light];
  const FirstPicture picture(view);
  if (dragged.kind == Light::Kind::kPoint) {
    dragged.at = picture.at_depth_of(dragged.at, to);
  } else {
    const Sphere sphere = sphere_of(picture.camera());
    const Vec3 now = place_of(dragged, picture.camera());
    dragged.at =
        glm::normalize(dragged_around(picture, sphere.middle, sphere.radius, now, to) - sphere.middle);
  }
  view.look.shadow.inspected = light;
  view.picture_old = true;
}

void draw_light_handles(const ViewState& view, ImDrawList& list) {
  for (size_t i = 0; i < view.look.lights.size(); ++i) {
    const std::optional<Vec2> at = light_handle(view, i);
    if (!at) continue;
    const Light& light = view.look.lights[i];
    const bool chosen = view.look.shadow.inspected == i;
    const ImVec4 colour(static_cast<float>(std::sqrt(std::min(light.colour.x, 1.0))),
                        static_cast<float>(std::sqrt(std::min(light.colour.y, 1.0))),
                        static_cast<float>(std::sqrt(std::min(light.colour.z, 1.0))), 1);
    list.AddCircleFilled(to_im(*at), 7.5f, IM_COL32(10, 12, 16, 170));
    list.AddCircleFilled(to_im(*at), 5, ImGui::ColorConvertFloat4ToU32(colour));
    list.AddCircle(to_im(*at), 9, chosen ? colours::accent() : colours::kPictureSecondary, 0, 1.5f);
    // Rays tell the sun from a lamp.
    for (int ray = 0; light.kind == Light::Kind::kDirectional && ray < 8; ++ray) {
      const Vec2 out(std::cos(0.785398 * ray), std::sin(0.785398 * ray));
      list.AddLine(to_im(*at + out * 11.0), to_im(*at + out * 15.0),
                   chosen ? colours::accent() : colours::kPictureSecondary, 1.5f);
    }
  }
}

}  // namespace kerf
