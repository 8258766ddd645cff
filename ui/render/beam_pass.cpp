#include "ui/render/beam_pass.h"

#include <algorithm>

#include "ui/render/body_picture.h"

namespace kerf {

namespace {

constexpr double kFirstDepth = 0.03;   // of the focus: nearer parts of the beam are not drawn
constexpr double kLightReach = 14;     // radii that the spot's light reaches
constexpr double kLeastReach = 0.012;  // of the world's unit
constexpr double kSpotRadii = 16;      // half the width of the spot, in radii of the beam
constexpr double kLeastSpot = 34;      // pixels, where the picture is high enough for them
constexpr double kMostSpot = 0.20;     // of the picture's height

// The part of the beam that lies far enough before the eye; empty when none does.
std::optional<std::pair<Vec3, Vec3>> before_eye(const CameraView& view, Vec3 a, Vec3 b) {
  const double least = kFirstDepth * view.focus;
  const double da = glm::dot(a - view.eye, view.forward), db = glm::dot(b - view.eye, view.forward);
  if (da < least && db < least) return std::nullopt;
  if (da < least) a += (b - a) * ((least - da) / (db - da));
  if (db < least) b += (a - b) * ((least - db) / (da - db));
  return std::pair(a, b);
}

}  // namespace

double spot_half_width(double radius_pixels, int height) {
  return std::min(std::max(kSpotRadii * radius_pixels, kLeastSpot), kMostSpot * height);
}

Result<BeamPass> BeamPass::create(const std::filesystem::path& shaders) {
  auto ribbon = gl::Program::load(shaders, {{"frame.glsl", "beam.vert"}, {"beam.frag"}});
  if (!ribbon) return ribbon.error();
  auto spot = gl::Program::load(shaders, {{"frame.glsl", "spot.vert"}, {"spot.frag"}});
  if (!spot) return spot.error();
  return BeamPass(std::move(*ribbon), std::move(*spot));
}

BeamPass::BeamPass(gl::Program ribbon, gl::Program spot)
    : ribbon_(std::move(ribbon)), spot_(std::move(spot)) {
  ribbon_.bind_block("Frame", kFrameBlock);
  spot_.bind_block("Frame", kFrameBlock);
}

void BeamPass::fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam) {
  if (!beam.strike) return;
  const double reach = std::max(kLightReach * beam.radius, kLeastReach * space.unit);
  frame.spot = glm::vec4(space.from_world(*beam.strike), space.length(reach));
  frame.spot_colour = {5.0f, 2.7f, 1.15f, 0};
}

void BeamPass::draw(const CameraView& view, const FrameSpace& space, const BeamPicture& beam,
                    int height) const {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  glDepthMask(GL_FALSE);
  glBindVertexArray(no_vertices_.name());

  const Vec3 seen = beam.strike.value_or(beam.to);
  const double depth = std::max(glm::dot(seen - view.eye, view.forward), kFirstDepth * view.focus);
  const double pixels = beam.radius / (depth * view.tan_half_fov) * 0.5 * height;
  const auto core = static_cast<float>(std::clamp(0.9 * pixels, 1.2, 3.0) * height / 800);
  if (const auto part = before_eye(view, beam.from, beam.to)) {
    ribbon_.use();
    ribbon_.set("beam_from", glm::vec4(space.from_world(part->first), 1));
    ribbon_.set("beam_to", glm::vec4(space.from_world(part->second), 1));
    const double strike = std::max(glm::length(seen - beam.from), 1e-6 * space.unit);
    const Vec2 lengths =
        Vec2(glm::length(part->first - beam.from), glm::length(part->second - beam.from)) / strike;
    ribbon_.set("lengths", glm::vec4(glm::vec2(lengths), 0, 0));
    ribbon_.set("core", core);
    ribbon_.set("half_width", core * 16);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  if (beam.strike) {
    glDisable(GL_DEPTH_TEST);
    spot_.use();
    spot_.set("half_width", static_cast<float>(spot_half_width(pixels, height)));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_DEPTH_TEST);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace kerf
