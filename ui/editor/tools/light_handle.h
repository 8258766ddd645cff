#pragma once

#include <optional>

#include "ui/editor/editor_state.h"

struct ImDrawList;

namespace kerf {

// A handle for every light in the picture, while the Light panel is unfolded: a lamp where it stands, a
// directional light on a sphere around what is looked at. Places are of the window, screen coordinates.

// Nothing for a light behind the eye, or while handles are not shown.
std::optional<Vec2> light_handle(const EditorState& state, size_t light);

// The light whose handle is under a place.
std::optional<size_t> light_under(const EditorState& state, Vec2 at);

// Moves a light so that its handle is there: a lamp across the view at its depth, a directional light over
// its sphere.
void drag_light(EditorState& state, size_t light, Vec2 to);

void draw_light_handles(const EditorState& state, ImDrawList& list);

}  // namespace kerf
