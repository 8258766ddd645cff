#pragma once

#include "ui/editor/changes/split_view.h"
#include "ui/editor/changes/stage_cut.h"
#include "ui/screen/live_picture.h"
#include "ui/window/window_clock.h"

namespace kerf {

// Cuts queued moves of the open document and of the right half of a split picture, for as long as each frame
// allows.
class LiveCut {
 public:
  struct Parts {
    OpenWork& work;
    ViewState& view;
    Hand& hand;
    SplitView& split;
    Figures& figures;
    Message& message;
    WorldChanges& changes;
    const StageCut& stages;  // what it holds back is left to it
    LivePicture& picture;
    const WindowClock& clock;
  };
  // The parts must outlive it.
  explicit LiveCut(const Parts& parts) : on_(parts) {}

  // Cuts for a part of the frame. Ends early if a step fails or has to run in the background.
  void advance();
  // The time that the last call took for cutting, in seconds; 0 if nothing was queued.
  double seconds() const { return seconds_; }
  // Whether moves are queued that it may cut.
  bool waits() const { return first_waits() || on_.split.twin.waiting() > 0; }

 private:
  bool first_waits() const { return on_.work.document.waiting() > 0 && !on_.stages.holds_back(); }
  // Both cut until a time (s) and return whether anything was queued.
  bool cut_first(double until);
  bool cut_twin(double until);

  Parts on_;
  double seconds_ = 0;
};

}  // namespace kerf
