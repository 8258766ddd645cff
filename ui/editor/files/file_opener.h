#pragma once

#include "ui/editor/files/unsaved_work.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// Shows on the empty stage how far a file is cut again. The first time the camera frames it.
void show_so_far(Workspace& workspace, CutSoFar so_far);
// Replaces the open work by files that were read, and frames it with the camera, unless it was shown before.
void show_loaded(Workspace& workspace, LoadedFiles loaded);

// Opens files in place of the open work. All files but the default scene, which is small, are read in the
// background.
class FileOpener {
 public:
  // Both must outlive it.
  FileOpener(Workspace& workspace, Recovery& recovery) : workspace_(workspace), recovery_(recovery) {}

  // Opens scenes and meshes, or none, at startup. While they are read, an empty stage is shown, and on it
  // what is cut again; the default scene if they cannot be read. Fails if there are none and the default
  // scene cannot be read.
  Status open_first(std::filesystem::path default_scene, const std::vector<std::filesystem::path>& files);
  // Opens files, or the default scene. Precondition: the open work is saved or may be discarded.
  void open(std::vector<std::filesystem::path> files);
  void open_fresh();
  // Opens the first recovered work. Precondition: there is one.
  void open_left_work();

  // To be called between two frames: shows files that have been read. The default scene takes the place of an
  // empty stage that nothing is read for any more.
  void take_loaded();
  // To be called after that: makes the shadow casters of a large scene beside the frames, once its first
  // picture is seen.
  void make_shadows();
  // Whether the next frame has to come without input, because the picture still lacks its shadows.
  bool moving() const { return shadows_due_ && workspace_.window->draws(); }

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
  bool shadows_due_ = false;  // the shadow casters of what was opened are to be made
};

// Asks at the right border of the picture, under the axes, for the unit and the upward axis of a mesh file
// that was opened, with what was guessed chosen already, and says how large the world (of this `size`, in the
// numbers of the file) is then, and in the unit that is mistaken most often for it. Nothing waits for an
// answer: the question goes when a stroke begins (`cut_once`), and is asked once for each kind of file if it
// is answered. Draws nothing where nothing is to be asked.
void draw_frame_question(const Vec3& size, ViewState& view, Settings& settings, bool cut_once);

}  // namespace kerf
