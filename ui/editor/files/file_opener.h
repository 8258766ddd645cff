#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/platform.h"
#include "core/document/autosave.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/status_message.h"
#include "ui/window/widgets.h"

namespace kerf {

// Returns true if the file of the open work lacks commands, these lights, or feature entries in its head.
bool is_unsaved(const DocumentSession& session, const std::vector<Light>& lights);
// Returns true if anything but cooling happened since the last save: undone changes are not unsaved, but can
// be redone after a crash.
bool is_to_be_kept(const DocumentSession& session, const std::vector<Light>& lights);

// Returns the displayed name of the open work: that of its file, or of the file that it was opened from.
std::string name_of_work(const DocumentSession& session);

// Returns the title of the window: "car.kerf* - Kerf", with the star if something is unsaved.
std::string window_title(const DocumentSession& session, const std::vector<Light>& lights);

// Suggests a name for a new file of the open work: "car.kerf".
std::string suggested_name(const DocumentSession& session);

// Returns the scene of the open work with the current view and lights.
SceneDescription scene_now(const DocumentSession& session, const ViewState& view);

// Saves the open work: as a journal, which Save writes from then on, or, if the name ends in .json, as a
// scene without the cuts. A name with neither ending gets .kerf. The previous version is kept with a ~ added
// to its name. The file becomes the first recent one. Reports the result in the status bar. Returns true if
// all of the work is saved.
bool save_work(DocumentSession& session, const ViewState& view, std::filesystem::path file,
               Settings& settings, Message& message);

// Keeps unsaved work on disk while the editor runs, so that the next session can recover it; see Autosave.
class Recovery {
 public:
  Recovery() : autosave_(state_folder()) {}

  // Starts again for another open work, or another file of it, once there is something to keep.
  void begin(const DocumentSession& session, const ViewState& view);
  // Called once a frame: passes unsaved changes on to the disk, and discards saved ones. Changes by a drag
  // of the mouse are kept when it ends. Reports a failure in the status bar, once, and retries every second.
  // Returns true if the last try succeeded.
  bool follow(DocumentSession& session, const ViewState& view, bool mouse_moves, Message& message);
  // Finishes writing to the disk; called while the editor waits.
  void flush() { autosave_.flush(); }
  void drop() { autosave_.drop(); }

 private:
  using Clock = std::chrono::steady_clock;

  Autosave autosave_;
  std::vector<Light> lights_;  // that are kept
  std::string head_;           // SceneDescription::others that is kept
  bool well_ = true;           // the last try succeeded
  Clock::time_point failed_at_;
};

// Decisions about unsaved work before closing, and about work left by crashed editors.

struct Decisions {
  Question question;
  enum class About { kUnsaved, kRecovery };
  About about = About::kUnsaved;  // valid while the question is open
  std::function<void()> leaving;  // waits for the decision about unsaved work
};

// Returns true if the open work can be closed at once; otherwise stores `then` in `leaving` and asks the
// user. Precondition: no other question is open.
bool may_leave(Decisions& decisions, const DocumentSession& session, const std::vector<Light>& lights,
               const std::function<void()>& then);

// Asks about the first of the recoverable work, if there is any.
void ask_about_recovery(Decisions& decisions, const std::vector<RecoverableDocument>& recoverable);

enum class Decision {
  kNone,
  kLeave,      // run `leaving`
  kSaveFirst,  // save the work, then run it
  kGoOn,       // open the first of the recoverable work
};

// Takes the answer to the question, once, and does everything that needs no frame loop: discards recoverable
// work, closes the question, asks the next one.
Decision take_decision(Decisions& decisions, std::vector<RecoverableDocument>& recoverable);

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
