#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/mesh/files/mesh_format.h"
#include "core/shadow/light.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/view_options.h"

struct ImDrawList;

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

// Adds a directional light and chooses it. Precondition: fewer than kMaxLights.
void add_light(ViewOptions& look, UpAxis up);
// Removes the chosen light and chooses the first one. Precondition: there is a light.
void remove_light(ViewOptions& look);

// A handle for every light in the first half of the picture: a lamp where it stands, a directional light on a
// sphere around what is looked at. Places are of the window, screen coordinates.

// Where the handle of a light is; nothing for a light that is not in the picture.
std::optional<Vec2> light_handle(const ViewState& view, size_t light);

// The light whose handle is at a position, if any.
std::optional<size_t> light_under(const ViewState& view, Vec2 at);

// Moves a light so that its handle is at a position: a lamp parallel to the picture at its depth, a
// directional light on its sphere.
void drag_light(ViewState& view, size_t light, Vec2 to);

void draw_light_handles(const ViewState& view, ImDrawList& list);

}  // namespace kerf
