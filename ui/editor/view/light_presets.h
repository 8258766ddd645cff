#pragma once

#include <span>
#include <vector>

#include "core/shadow/light.h"
#include "core/world/world.h"

namespace kerf {

// A predefined set of lights.
struct LightPreset {
  const char* name;
  const char* meaning;
  std::vector<Light> (*lights)(const World::Bounds& bounds);
};
std::span<const LightPreset> light_presets();

}  // namespace kerf
