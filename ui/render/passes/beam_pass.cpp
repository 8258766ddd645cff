#include "ui/render/passes/beam_pass.h"

#include <algorithm>

#include "ui/gl/state.h"
#include "ui/render/view/screen_segment.h"

namespace kerf {

namespace {

constexpr double kLightReach = 14;     // radii that the spot's light reaches
constexpr double kLeastReach = 0.012;  // of the world's unit
constexpr double kSpotRadii = 16;      // half the width of the spot, in radii of the beam
constexpr double kLeastSpot = 34;      // pixels, where the picture is high enough for them
constexpr double kMostSpot = 0.20;     // of the picture's height
constexpr double kCoreOfBeam = 0.9;    // the width of the core over the radius of the beam
constexpr double kLeastCore = 1.2;     // pixels of a picture that is at most 800 high
constexpr double kMostCore = 3.2;      // the same
constexpr double kHalo = 16;           // half the width of the ribbon over the largest width of the core
constexpr double kFade = 1.0;          // m before an end in mid-air
constexpr double kMostFade = 0.5;      // of the length of the beam

// Pixels that a length across the view takes at a distance of one metre.
double pixels_at_one_metre(const CameraView& view, double length, int height) {
  return length / view.tan_half_fov * 0.5 * height;
}

}  // namespace

double spot_half_width(double radius_pixels, int height) {
  return std::min(std::max(kSpotRadii * radius_pixels, kLeastSpot), kMostSpot * height);
}

BeamPicture ended_on_ground(BeamPicture beam, double ground, UpAxis up) {
  const double fall = height_of(beam.from - beam.to, up), above = height_of(beam.from, up) - ground;
  if (!(above > 0 && above <= fall)) return beam;
  beam.to = beam.from + (beam.to - beam.from) * (above / fall);
  beam.on_ground = true;
  return beam;
}

BeamPass::BeamPass(Shaders& shaders)
    : ribbon_(shaders.load({{"frame.glsl", "beam.vert"}, {"frame.glsl", "beam.frag"}})),
      spot_(shaders.load({{"frame.glsl", "spot.vert"}, {"spot.frag"}})) {}

void BeamPass::fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam) {
  if (!beam.strike && !beam.on_ground) return;
  const double reach = std::max(kLightReach * beam.radius, kLeastReach * space.unit);
  frame.spot = glm::vec4(space.from_world(beam.strike.value_or(beam.to)), space.length(reach));
  frame.beam = glm::vec4(space.from_world(beam.from), 0);
  const glm::vec4 colour = beam.strike ? glm::vec4(5.0f, 2.7f, 1.15f, 0) : glm::vec4(2.5f, 1.35f, 0.6f, 0);
  frame.spot_colour = static_cast<float>(beam.strength) * colour;
}

void BeamPass::draw(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, double near,
                    int width, int height) const {
  gl::ScopedState state({.writes_depth = false, .blend = gl::kScreen});
  draw_ribbon(view, beam, near, width, height);
  state.set({.depth = GL_NONE, .blend = gl::kScreen});
  if (beam.strike) draw_spot(view, beam, space, height);
}

void BeamPass::draw_ribbon(const CameraView& view, const BeamPicture& beam, double near, int width,
                           int height) const {
  const double zoom = std::max(1.0, height / 800.0), most = kMostCore * zoom;
  const auto seen = on_screen(view, beam.from, beam.to, width, height, kHalo * most);
  if (!seen) return;
  const double length = glm::length(beam.to - beam.from);
  const double strike = beam.strike ? glm::length(*beam.strike - beam.from) : length;
  const double fade = beam.on_ground ? 0 : std::min(kFade, kMostFade * length);
  ribbon_.use();
  ribbon_.set("ends", glm::vec4(glm::vec2(seen->from), glm::vec2(seen->to)));
  const auto depth_of = [&](double share) {
    const Vec3 at = beam.from + (beam.to - beam.from) * share;
    return window_depth(view, near, glm::dot(at - view.eye, view.forward));
  };
  ribbon_.set("depths", glm::vec4(glm::vec2(seen->inverse_depth * view.focus), depth_of(seen->share.x),
                                  depth_of(seen->share.y)));
  ribbon_.set("share", glm::vec4(glm::vec2(seen->share * length / std::max(strike, 1e-300)),
                                 static_cast<float>(length / std::max(strike, 1e-300)),
                                 static_cast<float>(fade / std::max(strike, 1e-300))));
  ribbon_.set("strength", static_cast<float>(beam.strength));
  ribbon_.set("core", glm::vec4(pixels_at_one_metre(view, kCoreOfBeam * beam.radius, height) / view.focus,
                                kLeastCore * zoom, most, kHalo));
  no_vertices_.draw(GL_TRIANGLE_STRIP, 8);
}

void BeamPass::draw_spot(const CameraView& view, const BeamPicture& beam, const FrameSpace& space,
                         int height) const {
  const double depth = glm::dot(*beam.strike - view.eye, view.forward);
  if (!(depth > 0)) return;
  const double pixels = pixels_at_one_metre(view, beam.radius, height) / (view.parallel ? view.focus : depth);
  spot_.use();
  spot_.set("centre", glm::vec4(space.from_world(*beam.strike), 1));
  spot_.set("strength", static_cast<float>(beam.strength));
  spot_.set("half_width", static_cast<float>(spot_half_width(pixels, height)));
  no_vertices_.draw(GL_TRIANGLE_STRIP, 4);
}

}  // namespace kerf
