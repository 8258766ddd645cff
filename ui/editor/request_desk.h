#pragma once

#include "ui/editor/changes/file_opener.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/editor/state.h"

namespace kerf {

// Fulfils the requests of menus, keys and panels since the last frame, and the decisions of dialogs.
class RequestDesk {
 public:
  // All must outlive it.
  RequestDesk(EditorState& state, WorldChanges& changes, FileOpener& opener, Recovery& recovery)
      : state_(state), changes_(changes), opener_(opener), recovery_(recovery) {}

  // To be called between two frames. A request for a screenshot of the window is left to the caller.
  void fulfil();
  // Whether the editor should end.
  bool quit() const { return quit_; }

 private:
  void decide();
  void save_to(const std::filesystem::path& file);
  void leave(const Requests& wanted);
  void load_paths(std::vector<std::filesystem::path>& files);
  void save_path_to(const std::filesystem::path& file);
  void change_world(const Requests& wanted);
  void run_path();
  void step_through_history(bool back);

  // The last run of the path, which undo and redo take as one step while nothing else was done since.
  struct Run {
    size_t from = 0, to = 0;  // positions of the history
    size_t commands = 0;      // in the journal, where nothing else was done
  };

  EditorState& state_;
  WorldChanges& changes_;
  FileOpener& opener_;
  Recovery& recovery_;
  bool quit_ = false;
  std::optional<Run> run_;
};

}  // namespace kerf
