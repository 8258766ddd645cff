#pragma once

#include <chrono>

#include "core/base/user_folders.h"
#include "core/document/journal/autosave.h"
#include "ui/editor/shared/files/open_work.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/window/message.h"

namespace kerf {

// Keeps what is not saved of the open work on the disk while the editor runs, so that the next editor can go
// on with it; see Autosave.
class Recovery {
 public:
  Recovery() : autosave_(state_folder()) {}

  // The open work is another one, or lies in another file: it is kept anew once there is something to keep.
  void begin(const OpenWork& work, const ViewState& view);
  // To be called once a frame: what is not saved is on its way to the disk when this returns, and what is
  // saved is kept no longer. What is being moved by the mouse is kept when it has arrived. Says in the status
  // bar when it fails, once, and tries again every second. Returns whether the last try went well.
  bool follow(OpenWork& work, const ViewState& view, bool mouse_moves, Message& message);
  // Writes what is on its way to the disk; to be called while the editor waits.
  void flush() { autosave_.flush(); }
  // Discards what is kept.
  void drop() { autosave_.drop(); }

 private:
  using Clock = std::chrono::steady_clock;

  Autosave autosave_;
  std::vector<Light> lights_;  // that are kept
  std::string head_;           // SceneDescription::others that is kept
  bool well_ = true;           // the last try
  Clock::time_point failed_at_;
};

}  // namespace kerf
