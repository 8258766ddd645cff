#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Why the last stroke cannot be cut again, in one sentence; null where it can.
const char* why_no_recut(const EditorState& state);

// Lets a renderer look anew at a world that cuts have come to. Smooth normals come from the faces as they
// were loaded, whatever strokes have done to them.
void show_world(const EditorState& state, const World& world, Renderer& renderer);

// Takes the last stroke back and queues it again at the resolution that the laser is set to; its radius and
// the rest stay. It is cut over the next frames as any stroke is. What was chosen or hidden of the pieces is
// forgotten, for the pieces are others then. Nothing where it cannot be done.
void recut_last_stroke(EditorState& state, Renderer& renderer);

}  // namespace kerf
