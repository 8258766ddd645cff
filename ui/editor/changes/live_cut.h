#pragma once

#include <chrono>

#include "ui/editor/changes/split_view.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/screen/live_picture.h"

namespace kerf {

// Cuts the moves that wait, in the open document and in the right half of a split picture, for as long in
// each frame as the frame may take.
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
    LivePicture& picture;
  };
  // The parts must outlive it.
  explicit LiveCut(const Parts& parts) : on_(parts) {}

  // Cuts for a part of a frame. Ends early where a step fails, or has to be done beside the frames.
  void advance();
  // What cutting took in the last call, seconds; 0 where nothing waited.
  double seconds() const { return seconds_; }
  // Whether moves wait.
  bool waits() const { return on_.work.document.waiting() > 0 || on_.split.twin.waiting() > 0; }

 private:
  using Clock = std::chrono::steady_clock;

  // Both return whether there was anything to cut.
  bool cut_first(Clock::time_point until);
  bool cut_twin(Clock::time_point until);

  Parts on_;
  double seconds_ = 0;
};

}  // namespace kerf
