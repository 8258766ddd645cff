#include "ui/render/shadow/shadow_overlay.h"

#include <algorithm>

#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/shadow/seen_light.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

using namespace overlay_colours;

namespace {

constexpr float kSheetReach = 0.9f;  // diagonals of the world that sheets are drawn long

// The colours of edges with one, two and more sides.
std::array<glm::vec4, 3> silhouette_colours(float opacity) {
  return {srgb(kOneSide, 0.75f * opacity), srgb(kTwoSides, opacity), srgb(kMoreSides, opacity)};
}
std::array<glm::vec4, 3> all_of(const glm::vec4& colour) { return {colour, colour, colour}; }

constexpr float kCountOpacity = 0.78f;

// Fields of colour in a row, each with its number; `row` counts strips from below.
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

// The light that is looked at and what is kept of it.
struct ShadowOverlay::Inspected {
  const Subject& subject;
  ShadowPass& shadows;
  size_t light;
  ShadowMethod method;
  glm::vec4 in_frame;
  int height;  // of the picture, pixels

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
  const size_t light = std::min({options.shadow.inspected, options.lights.size() - 1, kMostLights - 1});
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
    // The quad lies as far as the sky, which has no count.
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

// Faint where something stands before it, then over a dark line where it is seen.
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
