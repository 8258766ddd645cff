#pragma once

#include <chrono>

#include "ui/editor/editor_state.h"

namespace kerf {

// Keeps what is not saved of the open work on the disk while the editor runs, see Autosave.
class WorkKeeper {
 public:
  WorkKeeper() : autosave_(state_folder()) {}

  // The open work is another one, or lies in another file: it is kept anew once there is something to keep.
  void begin(const EditorState& state);
  // Once a frame: what is not saved is on its way to the disk when this comes back, and nothing is kept of
  // what is saved. Says in the status bar when it fails, once, and tries again every second. Whether it went
  // well.
  bool follow(EditorState& state);
  // While the editor waits.
  void flush() { autosave_.flush(); }
  // What is not saved is not wanted any more.
  void drop() { autosave_.drop(); }

 private:
  using Clock = std::chrono::steady_clock;

  Autosave autosave_;
  std::vector<Light> lights_;  // that are kept
  bool well_ = true;           // the last try
  Clock::time_point failed_at_;
};

}  // namespace kerf
