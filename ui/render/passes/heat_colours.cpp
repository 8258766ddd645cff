#include "ui/render/passes/heat_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/heat/black_body.h"
#include "ui/render/view/colours.h"
#include "ui/render/view/view_options.h"

namespace kerf {

namespace {

constexpr int kRampsUnit = 7;
constexpr int kSteps = 512;                      // of the table
constexpr double kHottest = 4096;                // K, end of the temperature rows
constexpr double kBrightest = 12;                // of shown_glow
constexpr double kMeltingLogLuminance = 11.757;  // of molten iron, 1811 K; cd/m^2
constexpr double kMeltingGlow = 6.0;             // of molten material, in the units of the scene's light

template <typename T>
struct Stop {
  double at;
  T value;
};

template <typename T>
T between(std::span<const Stop<T>> stops, double at) {
  const auto above = std::find_if(stops.begin(), stops.end(), [&](const auto& s) { return s.at > at; });
  if (above == stops.begin()) return above->value;
  if (above == stops.end()) return stops.back().value;
  const auto below = above - 1;
  return glm::mix(below->value, above->value, static_cast<float>((at - below->at) / (above->at - below->at)));
}

const std::array<Stop<glm::vec4>, 8> kTints{{{440, {0.50f, 0.36f, 0.13f, 0.0f}},
                                             {510, {0.48f, 0.33f, 0.11f, 0.26f}},
                                             {550, {0.24f, 0.115f, 0.05f, 0.42f}},
                                             {590, {0.12f, 0.075f, 0.10f, 0.50f}},
                                             {640, {0.075f, 0.09f, 0.13f, 0.55f}},
                                             {760, {0.075f, 0.08f, 0.09f, 0.62f}},
                                             {1000, {0.035f, 0.033f, 0.032f, 0.90f}},
                                             {1800, {0.045f, 0.040f, 0.038f, 0.90f}}}};

// The path of the temperature view through OKLab: lightness rises while the hue turns.
glm::dvec3 oklab_on_path(double s) {
  return oklab_of(0.20 + 0.75 * s, 0.05 + 0.15 * std::sin(kPi * std::pow(s, 0.9)), 285 + 185 * s);
}

glm::dvec3 linear_heat_colour(double t) { return linear_along(oklab_on_path, t); }

// The inverse of the tone mapping of light.glsl (`filmic`): returns the linear light mapped to y.
float before_filmic(double y) {
  const double a = 2.51 - 2.43 * y, b = 0.03 - 0.59 * y;
  return static_cast<float>((-b + std::sqrt(b * b + 4 * 0.14 * y * a)) / (2 * a));
}

constexpr double kLabelEvery = 250;    // K
constexpr double kLabelSpacing = 120;  // K, between a label and that of an end

// Returns the labelled temperatures [K]: both ends of the scale, and round numbers between them.
std::vector<double> labelled(double end) {
  std::vector<double> at{kAmbient, end};
  for (double t = kLabelEvery; t < end - kLabelSpacing; t += kLabelEvery) {
    if (t > kAmbient + kLabelSpacing) at.push_back(t);
  }
  return at;
}

}  // namespace

glm::vec3 shown_glow(double temperature) {
  if (temperature <= kGlowFrom) return glm::vec3(0);
  const Glow glow = glow_at(temperature);
  const double ratio = std::exp(0.25 * (glow.log_luminance - kMeltingLogLuminance));
  const double gain = std::min(kBrightest, kMeltingGlow * ratio);
  const auto white = static_cast<float>(std::clamp((gain - 1) / 9, 0.0, 1.0));
  const auto fade = static_cast<float>(std::min(1.0, (temperature - kGlowFrom) / 60));
  const glm::vec3 colour(glow.colour);
  return glm::mix(colour, glm::vec3(1, 0.85f, 0.6f), white) * static_cast<float>(gain) * fade;
}

glm::vec4 tint_of(double hottest) { return between<glm::vec4>(kTints, hottest); }

glm::vec3 heat_colour(double t) { return glm::vec3(screen_from_linear(linear_heat_colour(t))); }

HeatRamps::HeatRamps() {
  std::vector<glm::vec4> rows;
  for (int i = 0; i < kSteps; ++i) rows.emplace_back(shown_glow((i + 0.5) * kHottest / kSteps), 0);
  for (int i = 0; i < kSteps; ++i) rows.push_back(tint_of((i + 0.5) * kHottest / kSteps));
  using Scale = std::function<glm::dvec3(double)>;
  const auto scalars = [](ColourScale scale) {
    return Scale([scale](double t) { return linear_scalar_colour(scale, t); });
  };
  for (const Scale& colour :
       {Scale(linear_heat_colour), scalars(ColourScale::kSequential), scalars(ColourScale::kDiverging)}) {
    for (int i = 0; i < kSteps; ++i) {
      const glm::dvec3 c = colour(static_cast<double>(i) / (kSteps - 1));
      rows.emplace_back(before_filmic(c.r), before_filmic(c.g), before_filmic(c.b), 0);
    }
  }
  glBindTexture(GL_TEXTURE_2D, table_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, kSteps, 5, 0, GL_RGBA, GL_FLOAT, rows.data());
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, axis, GL_CLAMP_TO_EDGE);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
}

void HeatRamps::bind(const gl::Program& program) const {
  program.set_texture("heat_ramps", kRampsUnit, table_.name());
}

double end_of_heat_scale(const World& world) {
  double end = 0;
  for (const BodyId id : world.ids()) end = std::max(end, world.body(id).sheet.substance.transition);
  return end > kAmbient ? end : Substance().transition;
}

void draw_heat_bar(double end, FaceNumbers& numbers, int height) {
  KERF_ASSERT(end > kAmbient);
  const int zoom = 1 + height / 700, wide = 14 * zoom, tall = std::min(200 * zoom, height / 2);
  const int x = 12 * zoom, y = 12 * zoom;
  gl::fill(x - zoom, y - zoom, wide + 2 * zoom, tall + 2 * zoom, {0.043f, 0.051f, 0.063f, 0});
  for (int row = 0; row < tall; ++row)
    gl::fill(x, y + row, wide, 1, glm::vec4(heat_colour((row + 0.5) / tall), 0));
  std::vector<FaceLabel> labels;
  for (const double t : labelled(end)) {
    const double share = (t - kAmbient) / (end - kAmbient);
    const int at = y + static_cast<int>(std::lround(share * (tall - 1)));
    gl::fill(x + wide + zoom, at, 3 * zoom, zoom, {0.6f, 0.65f, 0.71f, 0});
    labels.push_back({static_cast<uint32_t>(std::lround(t)),
                      false,
                      glm::vec2(x + wide + 7 * zoom, std::max(y, at - 3 * zoom)),
                      {}});
  }
  numbers.draw_labels(labels, zoom);
}

}  // namespace kerf
