#pragma once

#include <optional>

#include "ui/editor/shared/picture/view_state.h"

struct ImDrawList;

namespace kerf {

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
