#include "ui/editor/light/light_presets.h"

#include <array>

#include "core/base/assert.h"

namespace kerf {

namespace {

const Vec3 kWarm(1.0, 0.72, 0.42), kCool(0.72, 0.86, 1.0), kPale(1.0, 0.93, 0.82);

Light sun(const Vec3& direction, const Vec3& colour, double intensity) {
  return {Light::Kind::kDirectional, direction, colour, intensity};
}

// A lamp at a place between -1 and 1 of the world's box and as bright as a sun at `intensity` at its middle.
Light lamp(const World::Bounds& bounds, const Vec3& place, const Vec3& colour, double intensity) {
  const Vec3 middle = (bounds.min + bounds.max) * 0.5, half = (bounds.max - bounds.min) * 0.5;
  const double diagonal = std::max(bounds.diagonal(), 1e-9);
  const Vec3 at = middle + place * half;
  const double share = std::max(glm::length(at - middle) / diagonal, 0.1);
  return {Light::Kind::kPoint, at, colour, intensity * share * share};
}

const std::array<LightPreset, 6> kPresets{{
    {"Workshop", "One key light from the upper left.",
     [](const World::Bounds&) { return std::vector{Light{}}; }},
    {"Noon", "The sun straight above.",
     [](const World::Bounds&) {
       return std::vector{sun({0.12, 1, 0.08}, kPale, 2.2)};
     }},
    {"Low sun", "Warm and grazing, with long shadows.",
     [](const World::Bounds&) {
       return std::vector{sun({-1, 0.32, 0.45}, kWarm, 2.6)};
     }},
    {"Lamp overhead", "A lamp close above.",
     [](const World::Bounds& b) {
       return std::vector{lamp(b, {0.5, 3.2, 0.4}, kPale, 2.2)};
     }},
    {"Lamp inside", "A lamp in the middle: light falls out through the holes.",
     [](const World::Bounds& b) {
       return std::vector{lamp(b, {0.02, 0.05, 0.02}, kWarm, 3.5)};
     }},
    {"Floodlights", "Four lamps around, as in a stadium.",
     [](const World::Bounds& b) {
       return std::vector{lamp(b, {-3, 4, 2}, kPale, 0.8), lamp(b, {3, 4, 2}, kCool, 0.7),
                          lamp(b, {3, 4, -2}, kPale, 0.6), lamp(b, {-3, 4, -2}, kCool, 0.6)};
     }},
}};

}  // namespace

std::span<const LightPreset> light_presets() { return kPresets; }

std::vector<Light> lights_of(const LightPreset& preset, const World::Bounds& bounds, UpAxis up) {
  const Vec3 a = to_y_up(bounds.min, up), b = to_y_up(bounds.max, up);
  std::vector<Light> lights = preset.lights({glm::min(a, b), glm::max(a, b)});
  for (Light& light : lights) light.at = from_y_up(light.at, up);
  return lights;
}

void add_light(ViewOptions& look, UpAxis up) {
  KERF_ASSERT(look.lights.size() < kMostLights);
  Light another;
  another.at = from_y_up({0.7, 0.8, -0.4}, up);
  another.intensity = 1;
  look.shadow.inspected = look.lights.size();
  look.lights.push_back(another);
}

void remove_light(ViewOptions& look) {
  KERF_ASSERT(!look.lights.empty());
  const size_t chosen = std::min(look.shadow.inspected, look.lights.size() - 1);
  look.lights.erase(look.lights.begin() + static_cast<std::ptrdiff_t>(chosen));
  look.shadow.inspected = 0;
}

}  // namespace kerf
