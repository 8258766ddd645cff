#pragma once

#include "ui/editor/changes/split_view.h"
#include "ui/editor/changes/step_groups.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/editor/play/play_state.h"
#include "ui/editor/single_step/stage_wishes.h"
#include "ui/editor/work/opening.h"

namespace kerf {

// The sentence why time cannot pass at the moment, or null.
const char* why_time_stands_still(const World& world, const SplitView& split, const StageWishes& stages,
                                  const Opening& opening);

// Lets time pass in the open document while the user plays: queues ticks in which bodies move.
//
// Ticks are queued when all before them are done, so that the world goes on in slow motion where ticks or
// cuts take longer than real time; how many are queued at once follows from how many the frames before could
// do. Playing ends when a step of the history is undone. Where it ends, and at each full minute, the
// journal gets a mark of where the bodies are, so that who opens it need not move them again.
class TimeFlow {
 public:
  struct Parts {
    OpenWork& work;
    ViewState& view;
    Hand& hand;
    const SplitView& split;
    const StageWishes& stages;
    const Opening& opening;
    PlayState& play;
    Message& message;
    WorldChanges& changes;
    StepGroups& groups;
  };
  // The parts must outlive it.
  explicit TimeFlow(const Parts& parts) : on_(parts) {}

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last frame.
  void advance(double seconds);

 private:
  bool may_go_on();
  bool begin();
  void end();
  void queue_spring();
  void queue_ticks(Ticks ticks);

  Parts on_;
  bool begun_ = false;                   // Play is in the document
  size_t position_ = 0;                  // of the history, in the last frame
  std::optional<size_t> before_ground_;  // the position before the world got its ground, until Play follows
  double due_ = 0;                       // ticks
  double most_ = 1;                      // ticks that are queued at once
};

}  // namespace kerf
