#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What becomes of unsaved work when the user asks for something that would end it, and of the work that a
// dead editor has left. The frame loop does what is asked for; here is what has to be decided first.

// Takes requests that the open work goes with: where it is unsaved they wait in `leaving` and the user is
// asked. Whether they can be done now.
bool may_leave(EditorState& state, const Requests& wanted);

// Asks what to do with the first of the work that dead editors have left, if there is any.
void ask_about_left_work(EditorState& state);

// What the last question was answered with, once: what to do now.
enum class Decision {
  kNone,
  kLeave,      // do what is in `leaving`
  kSaveFirst,  // save the work, then do it
  kGoOn,       // open the first of left_work
};
// Does all that needs no frame loop: discards what was left, closes the question, asks the next one.
Decision take_decision(EditorState& state);

}  // namespace kerf
