#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Why the last stroke cannot be cut again, in one sentence; null where it can.
const char* why_no_recut(const EditorState& state);

// Takes the last stroke back and queues it again at the resolution that the laser is set to; its radius and
// the rest stay. It is cut over the next frames as any stroke is. Cutting again what was just cut again is
// one step of the history. Nothing where it cannot be done.
void recut_last_stroke(EditorState& state, Renderer& renderer);

}  // namespace kerf
