#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/mesh/files/mesh_format.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/view_options.h"

struct ImDrawList;

namespace kerf {

struct LightPreset {
  const char* name;
  const char* meaning;
  std::vector<Light> (*lights)(const World::Bounds& bounds);
};
std::span<const LightPreset> light_presets();

const char* method_name(ShadowMethod method);

// Returns the lights of a preset for a world with this up axis.
std::vector<Light> lights_of(const LightPreset& preset, const World::Bounds& bounds, UpAxis up);

// Adds a directional light and selects it. Precondition: fewer than kMaxLights lights.
void add_light(ViewOptions& look, UpAxis up);
// Removes the selected light and selects the first one. Precondition: there is a light.
void remove_light(ViewOptions& look);

// Handles of the lights in the first half of the viewport: that of a lamp is at its position, that of a
// directional light on a sphere around the pivot of the camera. Places are in the window, in screen
// coordinates.

// Returns the place of the handle of a light; nullopt if it is outside the viewport.
std::optional<Vec2> light_handle(const ViewState& view, size_t light);

// Returns the light whose handle is at a place, if any.
std::optional<size_t> light_under(const ViewState& view, Vec2 at);

// Moves a light so that its handle is at a place: a lamp parallel to the screen at its depth, a directional
// light on its sphere.
void drag_light(ViewState& view, size_t light, Vec2 to);

void draw_light_handles(const ViewState& view, ImDrawList& list);

}  // namespace kerf
