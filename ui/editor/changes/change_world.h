#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Does a command, lets the picture follow, and says what went wrong where it failed; one that takes longer
// than a frame may wait becomes the state's long_change. So do the functions below, which none may call while
// one is there.
void change_world(EditorState& state, Renderer& renderer, const Command& command);

// Goes to a position of the history; what waits to be cut again is cut over the next frames.
void travel_to(EditorState& state, Renderer& renderer, size_t position);

// One step of the history back, or forth.
void step_through_history(EditorState& state, Renderer& renderer, bool back);

// Hides the pieces that are chosen, or takes them out of the world, each by a command; shows all again.
void hide_chosen(EditorState& state, Renderer& renderer);
void delete_chosen(EditorState& state, Renderer& renderer);
void show_hidden(EditorState& state, Renderer& renderer);

// Cuts the last stroke again, in place of an earlier recut of it. It can be cut again.
void cut_again(EditorState& state, Renderer& renderer, const CutSettings& settings);

// Lets the picture and the figures follow a step of a cut.
void follow_step(EditorState& state, Renderer& renderer, const StepResult& step);
// The same where a step failed.
void show_failed_step(EditorState& state, Renderer& renderer, const Error& error);
// Whether the next step ends a stroke among so many faces that it becomes the state's long_change.
bool close_rim_beside(EditorState& state, Renderer& renderer);

// Lets a renderer look anew at a world that cuts have come to. Smooth normals come from the faces as they
// were loaded, whatever strokes have done to them.
void show_world(const EditorState& state, const World& world, Renderer& renderer);

// Lets the picture, and all that the editor knows of the world, follow a change of it.
void show_change(EditorState& state, Renderer& renderer, const Delta& delta, PreparedBodies prepared = {});

}  // namespace kerf
