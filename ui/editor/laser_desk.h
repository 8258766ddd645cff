#pragma once

#include "ui/editor/state.h"

namespace kerf {

// Loads a path file in place of the path, which comes back by undo, and takes the path in hand. Returns the
// reason if that is impossible, else an empty text.
std::string load_path(EditorState& state, const std::filesystem::path& file);

// The reason why the path cannot be run at the moment, or null.
const char* why_no_run(const EditorState& state);

// Places the emitter where the view looks, and moves it there if it stands elsewhere.
void place_emitter(EditorState& state);

// Begins, continues or ends the stroke of the emitter, as it is switched, or fires the shot that is due.
// `now` is the time (s) on the clock of the events.
void follow_emitter(EditorState& state, double now);

}  // namespace kerf
