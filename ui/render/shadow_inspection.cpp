#include "ui/render/shadow_inspection.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "ui/gl/draw_state.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/bodies/piece_looks.h"
#include "ui/render/passes/surface_overlays.h"
#include "ui/render/shadow_pass.h"
#include "ui/render/view/colours.h"

namespace kerf {

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

using namespace overlay_colours;

namespace {

constexpr float kSheetReach = 0.9f;  // drawn length of sheets, in diagonals of the world

// The colours of edges with one, two and more sides.
std::array<glm::vec4, 3> silhouette_colours(float opacity) {
  return {srgb(kOneSide, 0.75f * opacity), srgb(kTwoSides, opacity), srgb(kMoreSides, opacity)};
}
std::array<glm::vec4, 3> all_of(const glm::vec4& colour) { return {colour, colour, colour}; }

constexpr float kCountOpacity = 0.78f;

// A row of colour fields, each with its number; `row` counts strips from below.
void draw_legend(std::span<const glm::vec4> colours, uint32_t first, int row, FaceNumbers& numbers,
                 int height) {
  const int zoom = 1 + height / 700, side = 22 * zoom, margin = 10 * zoom;
  const int y = margin + row * (side + margin);
  std::vector<FaceLabel> labels;
  gl::fill(margin - zoom, y - zoom, static_cast<int>(colours.size()) * side + 2 * zoom, side + 2 * zoom,
           srgb(0x0b0d10, 0));
  for (size_t i = 0; i < colours.size(); ++i) {
    const int x = margin + static_cast<int>(i) * side;
    gl::fill(x, y, side - zoom, side, glm::vec4(glm::vec3(colours[i]), 0));
    const glm::vec2 middle(x + side / 2 - 3 * zoom, y + side / 2 - 4 * zoom);
    labels.push_back({first + static_cast<uint32_t>(i), false, middle, {}});
  }
  numbers.draw_labels(labels, zoom);
}

}  // namespace

// The inspected light and its data.
struct ShadowOverlay::Inspected {
  const Subject& subject;
  ShadowPass& shadows;
  size_t light;
  ShadowMethod method;
  glm::vec4 in_frame;
  int height;  // of the frame, pixels

  template <typename Visit>
  void for_each_volume(const Visit& visit) const {
    for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
      const VolumeBuffer* volume = shadows.volume(subject, id, light, method);
      KERF_ASSERT(volume != nullptr);
      visit(*volume, body, picture);
    });
  }
};

ShadowOverlay::ShadowOverlay(Shaders& shaders)
    : line_(shaders.load({{"frame.glsl", "placed.glsl", "line.glsl", "shadow_light.glsl", "shadow_line.vert"},
                          {"box.frag"}})),
      sheet_(shaders.load({{"frame.glsl", "placed.glsl", "shadow_light.glsl", "shadow_side.vert"},
                           {"shadow_sheet.frag"},
                           {"SHEET"}})),
      facing_(shaders.load({{"frame.glsl", "placed.glsl", "facing.vert"}, {"facing.frag"}})),
      solid_(shaders.load({{"screen.vert"}, {"solid.frag"}})) {}

void ShadowOverlay::draw(const Subject& subject, ShadowPass& shadows, FaceNumbers& numbers,
                         const gl::Framebuffer& picture) const {
  const ViewOptions& options = subject.options;
  const ShowOptions& show = options.show;
  if (options.lights.empty()) return;
  const size_t light = std::min({options.shadow.inspected, options.lights.size() - 1, kMaxLights - 1});
  const glm::vec4 in_frame = light_in_frame(options.lights[light], subject.space);
  const Inspected seen{subject, shadows, light, options.shadow.method, in_frame, picture.shape().height};
  if (show.shadow_facing) draw_facing(seen);
  if (show.shadow_stencil) draw_counts(seen, numbers);
  if (show.shadow_volumes) draw_volumes(seen);
  if (show.silhouette) draw_silhouette(seen, numbers);
}

void ShadowOverlay::draw_facing(const Inspected& seen) const {
  const gl::ScopedState state({.depth = GL_EQUAL});
  const SectionClip clip(seen.subject.options);
  facing_.use();
  facing_.set("facing_colour", srgb(kFacing));
  facing_.set("averted_colour", srgb(kAverted));
  facing_.set("neither_colour", srgb(kEdgeOn));
  seen.for_each_volume([&](const VolumeBuffer& volume, const Body& body, const BodyPicture& picture) {
    picture.bind(facing_, seen.subject.space, body.placement);
    picture.faces().draw_chunks([&](size_t chunk) { volume.bind_signs(facing_, chunk); });
  });
}

void ShadowOverlay::draw_counts(const Inspected& seen, FaceNumbers& numbers) const {
  seen.shadows.count(seen.subject, seen.light, seen.method);
  gl::ScopedState state({});
  solid_.use();
  const auto fill = [&](GLenum test, size_t count, const glm::vec4& colour) {
    // The quad is as far as the sky, which has no count.
    state.set({.depth = GL_GREATER,
               .writes_depth = false,
               .blend = gl::kOver,
               .stencil = gl::Stencil{.test = test, .reference = static_cast<GLint>(count)}});
    solid_.set("colour", colour);
    no_vertices_.draw_screen();
  };
  fill(GL_EQUAL, 0, srgb(kLit, 0.55f));
  for (size_t n = 1; n < kCounts.size(); ++n) fill(GL_EQUAL, n, srgb(kCounts[n - 1], kCountOpacity));
  fill(GL_LEQUAL, kCounts.size(), srgb(kCounts.back(), kCountOpacity));
  std::vector<glm::vec4> colours{srgb(kLit)};
  for (const uint32_t c : kCounts) colours.push_back(srgb(c));
  if (seen.subject.options.legends) draw_legend(colours, 0, 0, numbers, seen.height);
}

void ShadowOverlay::draw_lines(const Inspected& seen, float half_width, float reach,
                               std::span<const glm::vec4> colours) const {
  line_.use();
  line_.set("light", seen.in_frame);
  line_.set("half_width",
            half_width * static_cast<float>(seen.subject.options.mark_scale * (1 + seen.height / 1400)));
  line_.set("reach", reach);
  line_.set("single_colour", colours[0]);
  line_.set("double_colour", colours[1]);
  line_.set("many_colour", colours[2]);
  seen.for_each_volume([&](const VolumeBuffer& volume, const Body& body, const BodyPicture& picture) {
    picture.bind(line_, seen.subject.space, body.placement);
    volume.draw_edges(kVerticesOfLine);
  });
}

void ShadowOverlay::draw_volumes(const Inspected& seen) const {
  const double diagonal = seen.subject.world.bounds().diagonal();
  const float reach = seen.subject.space.length(kSheetReach * diagonal);
  const gl::ScopedState state({.writes_depth = false, .clamps_depth = true, .blend = gl::kOver});
  sheet_.use();
  sheet_.set("light", seen.in_frame);
  sheet_.set("reach", reach);
  sheet_.set("front", srgb(kVolumeFront, 0.15f));
  sheet_.set("back", srgb(kVolumeBack, 0.12f));
  seen.for_each_volume([&](const VolumeBuffer& volume, const Body& body, const BodyPicture& picture) {
    picture.bind(sheet_, seen.subject.space, body.placement);
    volume.draw_sides(sheet_, 6);
  });
  draw_lines(seen, 0.45f, 0.6f * reach, all_of(srgb(0x8fc6ff, 0.22f)));
  draw_lines(seen, 0.6f, 0, all_of(srgb(0xd6ebff, 0.75f)));
}

// Faint if occluded; the visible part over a dark outline.
void ShadowOverlay::draw_silhouette(const Inspected& seen, FaceNumbers& numbers) const {
  gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  draw_lines(seen, 0.6f, 0, silhouette_colours(0.22f));
  state.set({.writes_depth = false, .blend = gl::kOver});
  draw_lines(seen, 2.2f, 0, all_of(srgb(0x05070a, 0.6f)));
  draw_lines(seen, 1.3f, 0, silhouette_colours(1));
  if (!seen.subject.options.legends) return;
  draw_legend(silhouette_colours(1), 1, seen.subject.options.show.shadow_stencil ? 1 : 0, numbers,
              seen.height);
}

}  // namespace kerf
