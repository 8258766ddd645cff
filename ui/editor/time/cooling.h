#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/time/play_state.h"

namespace kerf {

// Lets what is hot in the open document cool down in real time while the user does not play: queues ticks in
// which bodies stand still. They belong to the step of the history before them, so that one undo takes both.
//
// Like the ticks of TimeFlow they are queued when all before them are done. While anything in the picture
// changes by them, they are queued in every frame; after that time passes once a second, and the picture is
// not drawn again. Time waits while heat is held, and while steps of the history are undone: a tick would
// make it impossible to redo them.
class Cooling {
 public:
  // Both must outlive it.
  Cooling(Workspace& on, const PlayState& play) : on_(on), play_(play) {}

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last frame.
  void advance(double seconds);
  // Whether a frame is due although nothing else moves.
  bool moving() const;
  // Whether only ticks wait that change nothing in the picture.
  bool passes_unseen() const { return unseen_ && !on_.work.document.execution().beam_waits(); }
  // Whether something hot cools down as time passes. How long that is seen, the renderer tells.
  bool flows() const;

 private:
  bool is_seen() const;

  Workspace& on_;
  const PlayState& play_;
  double due_ = 0;   // ticks
  double most_ = 1;  // ticks that are queued at once
  bool unseen_ = false;
  double passed_at_ = 0;  // s, when ticks were queued last
};

}  // namespace kerf
