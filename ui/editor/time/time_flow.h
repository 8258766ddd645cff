#pragma once

#include "core/world/spring.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/time/play_state.h"

namespace kerf {

// Lets time pass in the open document while the user plays: queues ticks in which bodies move.
//
// Ticks are queued when all before them are done, so that the world goes on in slow motion where ticks or
// cuts take longer than real time; how many are queued at once follows from how many the frames before could
// do. Playing ends when a step of the history is undone. Where it ends, and at each full minute, the
// journal gets a mark of where the bodies are, so that who opens it need not move them again.
class TimeFlow {
 public:
  // All must outlive it. `spring` is the one that the user pulls a piece by.
  TimeFlow(Workspace& on, PlayState& play, const std::optional<Spring>& spring)
      : on_(on), play_(play), spring_(spring) {}

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last frame.
  void advance(double seconds);

 private:
  bool may_go_on();
  bool begin();
  void end();
  void queue_spring();
  void queue_ticks(Ticks ticks);

  Workspace& on_;
  PlayState& play_;
  const std::optional<Spring>& spring_;
  bool begun_ = false;                   // Play is in the document
  size_t position_ = 0;                  // of the history, in the last frame
  std::optional<size_t> before_ground_;  // the position before the world got its ground, until Play follows
  double due_ = 0;                       // ticks
  double most_ = 1;                      // ticks that are queued at once
};

}  // namespace kerf
