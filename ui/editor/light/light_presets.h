#pragma once

#include <span>
#include <vector>

#include "core/mesh/files/file_frame.h"
#include "core/shadow/light.h"
#include "core/world/world.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// A predefined set of lights.
struct LightPreset {
  const char* name;
  const char* meaning;
  std::vector<Light> (*lights)(const World::Bounds& bounds);
};
std::span<const LightPreset> light_presets();

// The lights of a preset for a world whose upward axis is `up`.
std::vector<Light> lights_of(const LightPreset& preset, const World::Bounds& bounds, UpAxis up);

// Adds a directional light and chooses it. Precondition: fewer than kMostLights.
void add_light(ViewOptions& look, UpAxis up);
// Removes the chosen light and chooses the first one. Precondition: there is a light.
void remove_light(ViewOptions& look);

}  // namespace kerf
