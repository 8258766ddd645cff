#include "ui/render/shadow/shadow_reference.h"

#include <algorithm>

#include "core/base/assert.h"
#include "ui/render/bodies/body_looks.h"

namespace kerf {

ShadowRays rays_through(const Subject& subject) {
  ShadowRays rays;
  for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
    const BodyLooks looks(id, subject.options);
    const auto offset_of = [&](uint32_t group) -> std::optional<Vec3> {
      return looks.of(group).hidden ? std::nullopt : std::optional(looks.of(group).offset);
    };
    rays.add(body, picture.faces().frame(), offset_of, labels_of(looks.groups()));
  });
  return rays;
}

ShadowReference::ShadowReference(ShadowRays rays, const CameraView& view, double near,
                                 const std::optional<SectionPlane>& section, const Light& light,
                                 std::optional<double> ground, int width, int height)
    : rays_(std::move(rays)),
      view_(view),
      near_(near),
      section_(section),
      light_(light),
      ground_(ground),
      width_(width),
      height_(height) {
  KERF_ASSERT(width > 0 && height > 0);
  const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  faces_.resize(pixels, 0);
  occluders_.resize(pixels, 0);
}

void ShadowReference::trace(size_t pixels) {
  for (size_t traced = 0; row_ < height_ && traced < pixels; ++row_, traced += static_cast<size_t>(width_)) {
    for (int x = 0; x < width_; ++x) trace_pixel(x, row_);
  }
}

std::optional<ShadowRays::Seen> ShadowReference::look(const Pose& ray) const {
  const double nearest = std::max(near_, 0.0) / glm::dot(ray.direction, view_.forward);
  if (!section_) return rays_.look(ray, nearest);
  const Interval kept = section_->kept_along(ray);
  const auto seen = rays_.look(ray, std::max(nearest, kept.low));
  return seen && seen->length <= kept.high ? seen : std::nullopt;
}

void ShadowReference::trace_pixel(int x, int y) {
  const size_t at = static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  const Pose ray = view_.ray((x + 0.5) / width_ * 2 - 1, (y + 0.5) / height_ * 2 - 1);
  const auto seen = look(ray);
  const UpAxis up = view_.up_axis;
  const double fall = -height_of(ray.direction, up);
  if (ground_ && height_of(view_.eye, up) > *ground_ && fall > 0) {
    const double length = (height_of(ray.origin, up) - *ground_) / fall;
    if (!seen || length < seen->length) {
      faces_[at] = ShadowCounts::kGround;
      occluders_[at] = rays_.occluders(ray.origin + ray.direction * length, light_);
      return;
    }
  }
  if (!seen) return;
  faces_[at] = ShadowCounts::mark(seen->body, seen->face);
  occluders_[at] = rays_.occluders(ray, *seen, light_);
}

size_t differing_pixels(const ShadowCounts& drawn, const ShadowReference& traced) {
  KERF_ASSERT(drawn.width == traced.width() && drawn.height == traced.height());
  size_t off = 0;
  for (size_t i = 0; i < drawn.faces.size(); ++i) {
    off += drawn.faces[i] != 0 && drawn.faces[i] == traced.faces()[i] &&
           (drawn.stencil[i] != 0) != (traced.occluders()[i] > 0);
  }
  return off;
}

}  // namespace kerf
