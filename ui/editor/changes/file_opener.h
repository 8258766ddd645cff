#pragma once

#include "ui/editor/changes/split_view.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/work/opening.h"
#include "ui/editor/work/recovery.h"
#include "ui/editor/work/requests.h"
#include "ui/render/renderer.h"

namespace kerf {

// What opening a file replaces or forgets.
struct OpenerParts {
  OpenWork& work;
  ViewState& view;
  Hand& hand;
  SplitView& split;
  Figures& figures;
  Opening& opening;
  Settings& settings;
  Message& message;
  Recovery& recovery;
  Renderer& renderer;  // of the open document
};

// Shows what was read in place of what is open, and stands the camera before it.
void show_loaded(const OpenerParts& on, LoadedFiles loaded);

// Opens files in place of what is open. All are read beside the frames, but for the default scene, which is
// small.
class FileOpener {
 public:
  // The parts must outlive it.
  explicit FileOpener(const OpenerParts& parts) : on_(parts) {}

  // Scenes and meshes, or none. Where they are bad, or take long, the default scene is shown at first; fails
  // where that cannot be.
  Status open_first(std::filesystem::path default_scene, const std::vector<std::filesystem::path>& files);
  // What a request asks for. Precondition: the open work is saved, or is to be discarded.
  void open(const Requests& wanted);
  // The first of the left work. Precondition: there is one.
  void open_left_work();

  // To be called between two frames: shows what has been read by then.
  void take_loaded();

 private:
  LoadOrder order_of(std::vector<std::filesystem::path> files) const;
  Status open_default_scene();
  void show(LoadedFiles loaded);

  OpenerParts on_;
  std::filesystem::path default_scene_;
};

}  // namespace kerf
