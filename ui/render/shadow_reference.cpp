#include "ui/render/shadow_reference.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "ui/gl/program.h"
#include "ui/render/view/colours.h"

namespace kerf {

namespace {

using Pixel = std::array<uint8_t, 4>;
constexpr Pixel pixel_of(uint32_t hex, uint8_t opacity) {
  return {static_cast<uint8_t>(hex >> 16 & 0xffu), static_cast<uint8_t>(hex >> 8 & 0xffu),
          static_cast<uint8_t>(hex & 0xffu), opacity};
}
constexpr Pixel kClear{0, 0, 0, 0}, kLitPixel = pixel_of(overlay_colours::kTracedLit, 80),
                                    kShadow = pixel_of(overlay_colours::kTracedShadow, 190),
                                    kWrong = pixel_of(overlay_colours::kWrong, 255);

Pixel colour(const ShadowReference& traced, const ShadowCounts& drawn, size_t i) {
  if (traced.faces()[i] == 0) return kClear;
  const bool shadow = traced.occluders()[i] > 0;
  const bool wrong = traced.faces()[i] == drawn.faces[i] && shadow != (drawn.stencil[i] != 0);
  return wrong ? kWrong : shadow ? kShadow : kLitPixel;
}

}  // namespace

ShadowProbe::ShadowProbe(Shaders& shaders)
    : faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})),
      ground_(shaders.load({{"frame.glsl", "ground.vert"}, {"solid.frag"}})) {}

void ShadowProbe::draw_marks(const Subject& subject, const GroundPass* ground) const {
  draw_marked_faces(subject, faces_);
  if (ground == nullptr) return;
  ground_.use();
  ground_.set("colour", glm::vec4(0, 0, 0, 1));
  ground->draw_disc(subject.space);
}

ShadowCounts ShadowProbe::look(const Subject& subject, ShadowPass& shadows, size_t light, ShadowMethod method,
                               const GroundPass* ground, int width, int height) {
  KERF_ASSERT(is_frame_bound());
  KERF_ASSERT(width > 0 && height > 0);
  const gl::Framebuffer::Shape shape{width, height, 1, true};
  if (!picture_ || !(picture_->shape() == shape)) picture_.emplace(shape);
  picture_->bind();
  draw_marks(subject, ground);
  shadows.count(subject, light, method, ground ? ground->hidden_below(subject.space) : std::nullopt);
  const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  ShadowCounts counts{width, height, std::vector<uint32_t>(pixels), std::vector<uint8_t>(pixels)};
  std::vector<uint8_t> marks(4 * pixels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, marks.data());
  glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, counts.stencil.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (size_t i = 0; i < pixels; ++i) {
    counts.faces[i] = marks[4 * i] | uint32_t{marks[4 * i + 1]} << 8 | uint32_t{marks[4 * i + 2]} << 16 |
                      uint32_t{marks[4 * i + 3]} << 24;
  }
  return counts;
}

size_t differing_pixels(const ShadowCounts& a, const ShadowCounts& b) {
  KERF_ASSERT(a.width == b.width && a.height == b.height);
  size_t off = 0;
  for (size_t i = 0; i < a.stencil.size(); ++i) {
    off += a.faces[i] != 0 && (a.stencil[i] == 0) != (b.stencil[i] == 0);
  }
  return off;
}

ShadowRays rays_through(const Subject& subject) {
  ShadowRays rays;
  for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
    const BodyLooks looks(id, body, subject.options);
    const auto transform_of = [&](uint32_t group) -> std::optional<Placement> {
      const PieceLook& look = looks.of(group);
      return look.hidden ? std::nullopt : std::optional(Placement{look.offset, look.turn});
    };
    rays.add(body, picture.faces().frame(), transform_of, labels_of(looks.groups()));
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

ReferencePass::ReferencePass(Shaders& shaders)
    : overlay_(shaders.load({{"screen.vert"}, {"overlay.frag"}})) {}

void ReferencePass::draw(const ShadowReference& traced, const ShadowCounts& drawn) const {
  KERF_ASSERT(drawn.width == traced.width() && drawn.height == traced.height());
  std::vector<Pixel> pixels(traced.faces().size());
  for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = colour(traced, drawn, i);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, traced.width(), traced.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
               pixels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  overlay_.use();
  overlay_.set("picture", 0);
  no_vertices_.draw_screen();
}

}  // namespace kerf
