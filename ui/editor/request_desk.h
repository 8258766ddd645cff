#pragma once

#include "ui/editor/changes/file_opener.h"
#include "ui/editor/changes/step_groups.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/editor/state.h"

namespace kerf {

// Fulfils the requests of menus, keys and panels since the last frame, and the decisions of dialogs.
class RequestDesk {
 public:
  // All must outlive it.
  RequestDesk(EditorState& state, WorldChanges& changes, StepGroups& groups, FileOpener& opener,
              Recovery& recovery)
      : state_(state), changes_(changes), groups_(groups), opener_(opener), recovery_(recovery) {}

  // To be called between two frames. A request for a screenshot of the window is left to the caller.
  void fulfil();
  // To be called when a change that was pending is complete.
  void end_group();
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

  void take_loaded();
  void change_pieces(const Requests& wanted);
  void begin_group(const char* name);

  // A change of several steps of the history that undo and redo take as one.
  struct OpenGroup {
    size_t from = 0;  // position of the history
    const char* name = "";
  };

  EditorState& state_;
  WorldChanges& changes_;
  StepGroups& groups_;
  FileOpener& opener_;
  Recovery& recovery_;
  bool quit_ = false;
  std::optional<OpenGroup> open_group_;
};

}  // namespace kerf
