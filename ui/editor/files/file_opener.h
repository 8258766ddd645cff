#pragma once

#include "ui/editor/files/unsaved_work.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// Shows a partially replayed file on the empty stage. The first time, the camera frames it.
void show_partial_replay(Workspace& workspace, PartialReplay replay);
// Replaces the open work by files that were read, and frames it with the camera unless it was shown before.
void show_loaded(Workspace& workspace, LoadedFiles loaded);

// Opens files in place of the open work. All but the small default scene are read in the background.
class FileOpener {
 public:
  // Both must outlive it.
  FileOpener(Workspace& workspace, Recovery& recovery) : workspace_(workspace), recovery_(recovery) {}

  // Opens scenes and meshes, or none, at startup. While they are read, an empty stage is shown, and on it the
  // partial replay; the default scene if they cannot be read. Fails if there are none and the default scene
  // cannot be read.
  Status open_first(std::filesystem::path default_scene, const std::vector<std::filesystem::path>& files);
  // Opens files, or the default scene. Precondition: the open work is saved or may be discarded.
  void open(std::vector<std::filesystem::path> files);
  void open_fresh();
  // Opens the first recovered work. Precondition: there is one.
  void open_recovered();

  // Called between two frames: shows files that were read. The default scene replaces an empty stage when no
  // file is being read for it.
  void take_loaded();
  // Called after take_loaded(): prepares shadow casters of a large scene in the background, after a frame.
  void make_shadows();
  // Returns true if the next frame is needed without input, because shadows are missing.
  bool moving() const { return shadows_due_ && workspace_.screen.window->draws(); }

 private:
  LoadOrder order_of(std::vector<std::filesystem::path> files) const;
  Status open_default_scene();
  void show_empty_stage();
  void take(Result<LoadedFiles> loaded, bool left);
  void show(LoadedFiles loaded);

  Workspace& workspace_;
  Recovery& recovery_;
  std::filesystem::path default_scene_;
  bool stage_is_empty_ = false;
  bool shadows_due_ = false;  // the shadow casters of the opened scene are not prepared yet
};

// Asks at the right border of the viewport, under the axes gizmo, for the unit and the up axis of an opened
// mesh file, with the guess preselected, and shows how large the world (of this `size`, in file units) is in
// that unit and in the one most often confused with it. Not modal: the question disappears when a stroke
// begins (`cut_once`), and once answered is not asked again for this kind of file.
void draw_frame_question(const Vec3& size, ViewState& view, Settings& settings, bool cut_once);

}  // namespace kerf
