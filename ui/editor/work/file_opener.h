#pragma once

#include "ui/editor/editor_state.h"
#include "ui/editor/work/work_keeper.h"

namespace kerf {

// Opens files in place of what is open. All are read beside the frames, but for the default scene, which is
// small.
class FileOpener {
 public:
  // Those that it is made of must outlive it.
  FileOpener(EditorState& state, Renderer& renderer, WorkKeeper& keeper)
      : state_(state), renderer_(renderer), keeper_(keeper) {}

  // Scenes and meshes, or none. Where they are bad, or take long, the default scene is shown at first; fails
  // where that cannot be.
  Status open_first(std::filesystem::path default_scene, const std::vector<std::filesystem::path>& files);
  // What a request asks for; the open work is saved, or not wanted any more.
  void open(const Requests& wanted);
  void open_left_work();

  // Between two frames: shows what has been read by now.
  void take_loaded();

 private:
  LoadOrder order_of(std::vector<std::filesystem::path> files) const;
  Status open_default_scene();
  void show(LoadedFiles loaded);

  EditorState& state_;
  Renderer& renderer_;
  WorkKeeper& keeper_;
  std::filesystem::path default_scene_;
};

}  // namespace kerf
