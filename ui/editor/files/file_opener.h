#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
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

// Returns true if the file of the open document lacks commands, these lights, or feature entries in its head.
bool is_unsaved(const DocumentSession& session, const std::vector<Light>& lights);
// Returns true if the recovery file is needed, i.e. if anything but cooling happened since the last save.
// Includes undone changes, which is_unsaved() ignores, so that they can be redone after a crash.
bool needs_recovery_file(const DocumentSession& session, const std::vector<Light>& lights);

// Returns the displayed name of the open document: that of its file, or of the file from which it was opened.
std::string name_of_work(const DocumentSession& session);

// Returns the title of the window: "car.kerf* - Kerf", with the star if something is unsaved.
std::string window_title(const DocumentSession& session, const std::vector<Light>& lights);

// Suggests a name for a new file of the open document: "car.kerf".
std::string suggested_name(const DocumentSession& session);

// Returns the scene of the open document with the current view and lights.
SceneDescription scene_now(const DocumentSession& session, const ViewState& view);

// Saves the open document: as a journal, which becomes the file of Save, or, if the name ends in .json, as a
// scene without the cuts. A name with neither extension gets .kerf. The previous version is kept with a ~
// added to its name. The file becomes the first recent one. Reports the result in the status bar. Returns
// true if all changes are saved.
bool save_work(DocumentSession& session, const ViewState& view, std::filesystem::path file,
               Settings& settings, Message& message);

// Stores unsaved changes on disk while the editor runs, so that the next session can recover them; see
// Autosave.
class Recovery {
 public:
  Recovery() : autosave_(state_folder()) {}

  // Restarts for another document, or another file of the document, once there are unsaved changes.
  void begin(const DocumentSession& session, const ViewState& view);
  // When changes may be written: `seconds` of a clock, at least `interval` [s] after the last ones.
  struct Time {
    double seconds = 0, interval = 0;
  };
  // Called once per frame and while the editor waits: writes unsaved changes to the disk, and discards saved
  // ones. Writes changes by a drag of the mouse when it ends. Reports a failure in the status bar, once, and
  // retries every second. Returns true if the last attempt succeeded.
  bool follow(DocumentSession& session, const ViewState& view, bool mouse_moves, const Time& time,
              Message& message);
  // Seconds of the clock at which the changes that have reached the disk were written; nullopt if there are
  // none to recover.
  std::optional<double> flushed_at() const { return flushed_at_; }
  void drop() { autosave_.drop(); }

 private:
  Autosave autosave_;
  std::vector<Light> lights_;  // as stored
  std::string head_;           // SceneDescription::others as stored
  FileFrame frame_;            // likewise
  bool well_ = true;           // the last attempt succeeded
  double tried_at_ = 0;        // s of the clock, of the last attempt
  std::optional<double> written_at_, flushed_at_;
};

// Describes the age of an autosave [s]: "autosaved", "autosaved 20 s ago", "autosaved 3 min ago". Steps are
// of ten seconds and then of a minute, so that an idle editor redraws rarely.
std::string autosave_words(double age);

// Decisions of the user about unsaved changes before closing, and about recoverable documents of crashed
// editors.

struct Decisions {
  Question question;
  enum class About { kUnsaved, kRecovery, kMissingMesh };
  About about = About::kUnsaved;  // valid while the question is open
  std::function<void()> leaving;  // action that waits for the decision about unsaved changes
};

// Returns true if the open document can be closed at once; otherwise stores `then` in `leaving` and asks the
// user. A question that is not the answer to an action (`unprompted`) has no letter that discards changes.
// Precondition: no other question is open.
bool may_leave(Decisions& decisions, const DocumentSession& session, const std::vector<Light>& lights,
               const std::function<void()>& then, bool unprompted = false);

// Asks about the first recoverable document, if there is one.
void ask_about_recovery(Decisions& decisions, const std::vector<RecoverableDocument>& recoverable);

// Asks what to do about a mesh file of `name` that is missing. `refused`: the reason why the last selected
// file was not read instead, a sentence, or empty.
void ask_about_missing_mesh(Decisions& decisions, const std::string& name, const std::filesystem::path& mesh,
                            const std::string& refused);

enum class Decision {
  kNone,
  kLeave,      // run `leaving`
  kSaveFirst,  // save the document, then run `leaving`
  kRecover,    // open the first recoverable document
  kFindMesh,   // let the user select the missing mesh file
};

// Processes the answer to the question, once, as far as that is possible without the frame loop: discards
// recoverable documents, closes the question, and asks the next one.
Decision take_decision(Decisions& decisions, std::vector<RecoverableDocument>& recoverable);

// Shows a partially replayed file on the empty stage. The first time, the camera frames it.
void show_partial_replay(Workspace& workspace, PartialReplay replay);
// Replaces the open document by loaded files, and frames it with the camera unless it was already shown.
void show_loaded(Workspace& workspace, LoadedFiles loaded);

// Opens files in place of the open document. All except the small default scene are read in the background.
class FileOpener {
 public:
  // The arguments must outlive it.
  FileOpener(Workspace& workspace, Recovery& recovery) : workspace_(workspace), recovery_(recovery) {}

  // Opens scenes and meshes, or none, at startup. While they are read, shows an empty stage with the partial
  // replay; if they cannot be read, shows the default scene. Fails if there are no files and the default
  // scene cannot be read.
  Status open_first(std::filesystem::path default_scene, const std::vector<std::filesystem::path>& files);
  // Open files, or the default scene. Precondition: the open document is saved or may be discarded.
  void open(std::vector<std::filesystem::path> files);
  void open_fresh();
  // Opens the first recoverable document. Precondition: there is one.
  void open_recovered();

  // Called between two frames: shows loaded files if they may replace the open document. If the stage is
  // empty and no file is being read, shows the default scene.
  void take_loaded(bool may_replace);
  // Returns true while the default scene replaces files that could not be opened, during
  // Feature::on_document_opened().
  bool opens_substitute() const { return opens_substitute_; }
  // Returns true before the first document is shown.
  bool is_stage_empty() const { return stage_is_empty_; }
  // A mesh file that a scene or journal names and that is missing, so that it was not opened. Until the
  // following are called, an empty stage stays empty.
  struct MissingMesh {
    LoadRequest order;
    std::filesystem::path mesh;
    std::string refused;  // the reason why the last file of open_with() was not read, or empty
  };
  const std::optional<MissingMesh>& missing() const { return missing_; }
  // Opens the files again with another mesh file, or gives up. Precondition: missing().
  void open_with(const std::filesystem::path& mesh);
  void give_up();

  // Called after take_loaded(): prepares shadow casters of a large scene in the background, after a frame.
  void make_shadows();
  // Returns true while the faces of newly opened files are being uploaded and nothing was changed yet, so
  // that cancel_upload() loses no work.
  bool can_cancel_upload() const;
  // Shows the document that was open before, with its history and unsaved changes, or the default scene if
  // there was none. Precondition: can_cancel_upload().
  void cancel_upload();
  // Returns true if the next frame is needed without input, because shadows are missing.
  bool moving() const { return shadows_due_ && workspace_.screen.window->draws(); }

 private:
  // The document that opened files replaced, with its view and shading.
  struct ReplacedDocument {
    DocumentSession session;
    LaserControls laser;
    Camera camera;
    FileFrame frame;
    std::optional<View> home;
    std::vector<Light> lights;
    ShowOptions show;
    PieceMap pieces;
    PieceNumbers numbers;
    double spread = 0;
    LoadedShadings shadings;
  };
  ReplacedDocument take_open_document();
  void bring_back(ReplacedDocument before);

  LoadRequest order_of(std::vector<std::filesystem::path> files) const;
  Status open_default_scene();
  void open_substitute() {
    opens_substitute_ = true;
    open_fresh();
    opens_substitute_ = false;
  }
  void show_empty_stage();
  // Empties the stage before other files are read, so that the camera frames these.
  void drop_partial_world() {
    if (std::exchange(workspace_.opening.partial_world, std::nullopt)) show_empty_stage();
  }
  void take(Result<LoadedFiles> loaded, LoadRequest order);
  bool is_wrong_mesh(const LoadRequest& order, const std::string& error) const;
  void show(LoadedFiles loaded);

  Workspace& workspace_;
  Recovery& recovery_;
  std::filesystem::path default_scene_;
  std::optional<MissingMesh> missing_;
  std::filesystem::path found_;  // mesh file of the last open_with(), and the missing one that it replaces
  std::filesystem::path replaced_mesh_;
  bool stage_is_empty_ = false;
  bool opens_substitute_ = false;
  bool uploads_ = false;                      // the faces of the opened files
  std::optional<ReplacedDocument> replaced_;  // kept during the upload; nullopt: none was open
  bool shadows_due_ = false;                  // the shadow casters of the opened scene are not prepared yet
};

// Asks for the unit and the up axis of an opened mesh file, at the right border of the viewport under the
// axes gizmo. Preselects the guess, and shows the size of the world (`size`, in file units) in that unit and
// in the one most often confused with it. Not modal: the question disappears when a stroke begins
// (`cut_once`), and is asked only once per kind of file.
void draw_frame_question(const Vec3& size, DocumentSession& session, ViewState& view, Settings& settings,
                         bool cut_once);

}  // namespace kerf
