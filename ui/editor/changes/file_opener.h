#pragma once

#include "ui/editor/changes/split_view.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/single_step/stage_log.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/work/opening.h"
#include "ui/editor/work/recovery.h"
#include "ui/editor/work/requests.h"
#include "ui/render/renderer.h"

namespace kerf {

// The parts that opening a file replaces or resets.
struct OpenerParts {
  OpenWork& work;
  ViewState& view;
  Hand& hand;
  SplitView& split;
  StageLog& stages;
  Figures& figures;
  Opening& opening;
  Settings& settings;
  Message& message;
  Recovery& recovery;
  Renderer& renderer;  // of the open document
};

// Replaces the open work by files that were read, and frames it with the camera.
void show_loaded(const OpenerParts& on, LoadedFiles loaded);

// Opens files in place of the open work. All files but the default scene, which is small, are read in the
// background.
class FileOpener {
 public:
  // The parts must outlive it.
  explicit FileOpener(const OpenerParts& parts) : on_(parts) {}

  // Opens scenes and meshes, or none, at startup. The default scene is shown while they are read and if they
  // cannot be read; fails if the default scene cannot be read.
  Status open_first(std::filesystem::path default_scene, const std::vector<std::filesystem::path>& files);
  // Opens what was requested. Preconditions: files or the default scene were, and the open work is saved or
  // may be discarded.
  void open(const Requests& wanted);
  // Opens the first recovered work. Precondition: there is one.
  void open_left_work();

  // To be called between two frames: shows files that have been read.
  void take_loaded();

 private:
  LoadOrder order_of(std::vector<std::filesystem::path> files) const;
  Status open_default_scene();
  void show(LoadedFiles loaded);

  OpenerParts on_;
  std::filesystem::path default_scene_;
};

}  // namespace kerf
