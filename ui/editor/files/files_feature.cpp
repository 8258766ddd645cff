#include <GLFW/glfw3.h>
#include <imgui.h>
#include <set>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/autosave.h"
#include "core/document/save.h"
#include "core/mesh/mesh_file.h"
#include "ui/editor/files/file_opener.h"
#include "ui/editor/files/watched_files.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/thumbnails.h"
#include "ui/window/gui.h"
#include "ui/window/number_text.h"
#include "ui/window/widgets.h"
#include "ui/window/window.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

void row(const char* name, const std::string& value, const char* meaning) {
  property(name);
  ImGui::TextWrapped("%s", value.c_str());
  tooltip(meaning);
}

std::string counted(size_t count, const char* what) { return grouped(count) + " " + what; }

void draw_body(const Body& body, FileUnit unit) {
  const MeshReport& r = body.loaded;
  row("Format", r.format, "File format, detected from the content.");
  row("Faces",
      count_text(r.faces, "triangle") + (r.components > 1 ? " in " + counted(r.components, "parts") : ""),
      "Loaded triangles, and the parts connected by shared edges.");
  row("Vertices", grouped(r.vertices), "Number of distinct positions.");
  row("Boundary", counted(r.boundary_edges, r.boundary_edges == 1 ? "edge" : "edges"),
      "Edges with one face; a closed surface has none.");
  row("Area", area_label(r.area, unit), "Total area of all faces, counted on one side.");
  const std::vector<std::string> notes = load_notes(r);
  for (size_t i = 0; i < notes.size(); ++i) {
    row(i == 0 ? "Notes" : "", notes[i], "Problems found and repaired on import.");
  }
}

void draw_frame(DocumentSession& session, ViewState& view, Settings& settings) {
  FileFrame frame = view.frame;
  property("Up");
  bool changed = up_axis_combo(frame.up);
  property("Unit");
  changed = unit_combo(frame.unit) || changed;
  if (changed) set_frame(frame, session, view, settings);
}

// Draws the unit and the up axis in which the world is shown, which are remembered for mesh files of this
// format, the contents of the files of the bodies, and the repairs on import.
void draw_file_panel(DocumentSession& session, ViewState& view, Settings& settings) {
  const World& world = session.world();
  if (begin_properties("frame")) {
    draw_frame(session, view, settings);
    end_properties();
  }
  const std::vector<BodyId> ids = world.ids();
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    ImGui::PushID(static_cast<int>(id.slot));
    ImGui::TextUnformatted(body.own_name().c_str());
    if (begin_properties("body")) {
      draw_body(body, view.frame.unit);
      end_properties();
    }
    ImGui::PopID();
  }
}

constexpr double kCheckSeconds = 1;  // between two checks of the files for changes
constexpr double kOtherSize = 2;     // ratio of diagonals from which a reloaded world is framed again

class FilesFeature : public Feature {
 public:
  explicit FilesFeature(Workspace& workspace) : workspace_(workspace) {
    workspace.links.open = [this](std::vector<fs::path> files) { open(std::move(files)); };
    workspace.links.quit = [this] { quit(); };
  }

  std::vector<PanelPart> panel_parts() override {
    return {{"file", [this] { draw_file_panel(workspace_.session, workspace_.view, workspace_.settings); }}};
  }
  std::vector<UserAction> actions() override {
    return joined({open_actions(),
                   example_actions(),
                   save_actions(),
                   picture_actions(),
                   leave_actions(),
                   {UserAction{.id = "file.frame", .name = "Units and Up Axis", .items = [this] {
                                 return frame_actions();
                               }}}});
  }

  Status on_start(const EditorOptions& options) override {
    std::vector<std::string> faults;
    workspace_.opening.recoverable = find_recoverable_documents(state_folder(), faults);
    ask_about_recovery(decisions_, workspace_.opening.recoverable);
    std::vector<fs::path> files = options.files;
    companions_ = workspace_.links.extract_accepted(files);
    const Status opened = opener_.open_first(options.default_scene, files);
    if (opened && !faults.empty() && !workspace_.message.is_error)
      workspace_.message.error("Recovery file is damaged: " + faults.front());
    return opened;
  }
  void on_idle() override { autosave(workspace_.settings.autosave_seconds); }
  void on_exit(bool left_by_user) override {
    autosave(0);
    if (left_by_user) recovery_.drop();
  }

  bool handle_event(const InputEvent& event, bool) override {
    if (event.kind != InputEvent::Kind::kKey || !decisions_.question.open()) return false;
    constexpr int kCommand = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    if (!event.again && (event.mods & kCommand) == 0) question_key(decisions_.question, event.button);
    return true;
  }
  bool cancel() override {
    const bool opens = workspace_.opening.loader.busy(), uploads = !opens && opener_.can_cancel_upload();
    if (opens) cancel_opening(workspace_.opening, workspace_.message);
    if (uploads) cancel_upload();
    return opens || uploads;
  }

  void update(double) override {
    decide();
    const bool asks =
        decisions_.question.open() || workspace_.services.browser.open || workspace_.changes.has_requests();
    if (!asks) decisions_.leaving = nullptr;                        // the user cancelled the file dialog
    if (!workspace_.opening.loader.busy() && !opener_.missing()) {  // was cancelled or failed
      companions_.clear();
      kept_view_.reset();
    }
    opener_.take_loaded(may_replace_document());
    ask_about_mesh();
    opener_.make_shadows();
    restore_view();
    check_files();
    is_autosaved_ = autosave(workspace_.settings.autosave_seconds);
    workspace_.screen.title = window_title(workspace_.session, workspace_.view.look.lights);
    ShownStatistics& shown = workspace_.services.statistics.shown;
    shown.file = name_of_work(workspace_.session);
    shown.unsaved = is_unsaved(workspace_.session, workspace_.view.look.lights);
    shown.autosave = state_of_autosave();
  }
  bool needs_redraw() const override {
    return workspace_.opening.loader.busy() || opener_.moving() || watched_.awaits_check() ||
           workspace_.services.statistics.shown.autosave != state_of_autosave();
  }
  void on_document_opened() override {
    watch_again();
    reloaded_view_ = std::exchange(kept_view_, std::nullopt);
    replaced_altered_ = std::exchange(altered_, {});
    const std::vector<fs::path> companions = std::exchange(companions_, {});
    if (!opener_.opens_substitute()) workspace_.links.take(companions);
  }

  void draw_windows() override {
    const World::Bounds bounds = workspace_.world().loaded_bounds();
    draw_frame_question(bounds.max - bounds.min, workspace_.session, workspace_.view, workspace_.settings,
                        workspace_.links.cut_once);
    offer_reload();
    const FileLoader& loader = workspace_.opening.loader;
    Area picture = workspace_.view.layout.viewport;
    if (workspace_.shown_world().live_faces() == 0) picture.size.y *= 0.5;  // in the middle of an empty stage
    if (loader.busy() && draw_progress(picture, "Opening " + loader.order().name() + ": " + loader.doing(),
                                       loader.fraction(), true))
      cancel_opening(workspace_.opening, workspace_.message);
    const Renderer& renderer = workspace_.screen.picture->first();
    if (!loader.busy() && renderer.is_sending() &&
        draw_progress(picture, "Uploading to GPU", renderer.sent_share(), opener_.can_cancel_upload()))
      cancel_upload();
    draw_question(decisions_.question);
  }
  void on_captured(Captured what) override {
    if (screenshot_ != what) return;
    screenshot_.reset();
    take_picture(what);
  }
  void add_landmarks(Landmarks& landmarks) const override {
    const Area somewhere{workspace_.input.pointer, Vec2(1)};
    if (decisions_.question.open()) landmarks.mark("question", somewhere);
    if (!state_of_autosave().empty()) landmarks.mark("autosaved", somewhere);
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    nlohmann::ordered_json& names = report["files"] = nlohmann::ordered_json::array();
    for (const fs::path& file : workspace_.session.files) names.push_back(file.filename().string());
  }

 private:
  std::vector<UserAction> open_actions() {
    return {
        make_action("file.new", "New", "Ctrl+N", "Closes the document and opens the default scene.",
                    [this] { leave_for([this] { opener_.open_fresh(); }); }),
        make_action("file.open", "Open...", "Ctrl+O",
                    "Opens a scene (.json), a journal (.kerf) or a mesh (" + list_mesh_endings(".", ", ") +
                        "); you can also drop files on the window.",
                    [this] { select_file_to_open(); }),
    };
  }
  std::vector<UserAction> example_actions() {
    const auto examples = [this] {
      std::vector<UserAction> actions;
      for (const fs::path& scene : example_scenes()) {
        actions.push_back({.name = title_of_scene(scene), .tip = scene.string()});
        actions.back().run = [this, scene] { workspace_.links.open({scene}); };
      }
      return actions;
    };
    return {UserAction{.id = "file.examples", .name = "Examples", .items = examples}};
  }
  std::vector<UserAction> save_actions() {
    return {
        make_action("file.save", "Save", "Ctrl+S",
                    "Saves the document with its history as a journal (.kerf). The previous version is kept "
                    "as .kerf~.",
                    [this] { save(); }),
        make_action("file.save_as", "Save As...", "Ctrl+Shift+S",
                    "Saves as another journal (.kerf), or as a scene (.json) without the cuts.",
                    [this] { select_file_to_save(); }),
    };
  }
  std::vector<UserAction> picture_actions() {
    return {
        make_action("file.save_viewport_image", "Save Viewport Image", "F12",
                    "Saves the viewport without panels as a PNG in the current folder, named by date.",
                    [this] { screenshot_ = Captured::kPicture; }),
        make_action("file.save_screenshot", "Save Screenshot", "Shift+F12",
                    "Saves the window with its panels as a PNG in the current folder, named by date.",
                    [this] { screenshot_ = Captured::kWindow; }),
    };
  }
  std::vector<UserAction> leave_actions() {
    return {
        make_action("file.play_game", "Play Game", "F5",
                    "Starts the car combat game; the document stays open.", [this] { leave_for_game(); }),
        make_action("file.quit", "Quit", "Ctrl+Q", "Closes the editor and saves the settings.",
                    [this] { quit(); }),
    };
  }
  // The actions use the frame at the time of listing.
  std::vector<UserAction> frame_actions() {
    std::vector<UserAction> actions;
    const FileFrame& frame = workspace_.view.frame;
    for (const FileUnit unit :
         {FileUnit::kMillimetre, FileUnit::kCentimetre, FileUnit::kMetre, FileUnit::kInch}) {
      actions.push_back(frame_action("Unit " + std::string(unit_symbol(unit)), {unit, frame.up},
                                     "Length of one file unit."));
    }
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      actions.push_back(frame_action(up == UpAxis::kY ? "Y Up" : "Z Up", {frame.unit, up},
                                     "Axis of the file that points up."));
    }
    return actions;
  }
  UserAction frame_action(const std::string& name, const FileFrame& frame, const char* tip) {
    return {.name = name, .tip = tip, .run = [this, frame] {
              set_frame(frame, workspace_.session, workspace_.view, workspace_.settings);
            }};
  }

  void open(std::vector<fs::path> files) {
    if (decisions_.question.open())
      return workspace_.message.error("Answer the question first, then drop the files again.");
    const std::vector<fs::path> companions = workspace_.links.extract_accepted(files);
    if (files.empty()) return workspace_.links.take(companions);
    leave_for([this, files, companions] {
      companions_ = companions;
      opener_.open(files);
    });
  }
  void quit() {
    leave_for([this] {
      workspace_.links.leaves = Leaves::kForGood;
      workspace_.session.saved_commands = workspace_.session.document.journal().size();
      workspace_.session.saved_lights = workspace_.view.look.lights;
      workspace_.session.saved_head = workspace_.session.scene.others;
    });
  }
  // Ends the stroke and switches the emitter off, so that no beam stays on during the game.
  void leave_for_game() {
    cancel_stroke(workspace_);
    workspace_.links.stops_emitter = true;
    workspace_.input.held.reset();
    workspace_.links.leaves = Leaves::kForTheGame;
  }
  // Calls `then`, which closes the open document, once the document is saved or may be discarded. First
  // cancels an open file dialog, because only one of it and the question is shown.
  void leave_for(std::function<void()> then) {
    workspace_.changes.enqueue({.name = "Leave",
                                .run =
                                    [this, then = std::move(then)] {
                                      if (decisions_.question.open()) return true;
                                      if (cancel_dialog()) return false;
                                      leave(then, false);
                                      return true;
                                    },
                                .always = true});
  }
  // Returns true if a file dialog is open; it closes when it is drawn.
  bool cancel_dialog() {
    if (!workspace_.services.browser.open) return false;
    browser_key(workspace_.services.browser, GLFW_KEY_ESCAPE);
    return true;
  }
  void leave(const std::function<void()>& then, bool unprompted) {
    cancel_stroke(workspace_);
    if (may_leave(decisions_, workspace_.session, workspace_.view.look.lights, then, unprompted)) go(then);
  }
  void go(const std::function<void()>& then) {
    workspace_.opening.loader.cancel();
    workspace_.changes.forget();
    companions_.clear();
    kept_view_.reset();
    pending_ = {then, workspace_.session.scene.others, workspace_.view.look.lights};
    then();
  }
  // Called once per frame. Returns true if files that were read may replace the open document. If it was
  // edited meanwhile, asks again, after which the files are read once more.
  bool may_replace_document() {
    const bool waits = is_editing();
    FileLoader& loader = workspace_.opening.loader;
    if (!loader.busy() || !loader.is_over(0)) return false;
    if (!pending_.begin || opener_.is_stage_empty()) return true;
    if (waits || workspace_.changes.is_pending()) return false;
    const bool is_same =
        workspace_.session.scene.others == pending_.head && workspace_.view.look.lights == pending_.lights;
    if (is_same) return true;
    if (decisions_.question.open() || workspace_.services.browser.open || is_text_field_active())
      return false;
    loader.cancel();
    companions_.clear();
    leave(std::exchange(pending_.begin, nullptr), true);
    return false;
  }
  // Called once per frame. Returns true during a drag or a press on a widget, and in the next frame, because
  // features store an edit only then. A text field counts only in the frame after it was left.
  bool is_editing() {
    const bool is_active = workspace_.input.held != nullptr || ImGui::IsAnyItemActive();
    const bool was_active = std::exchange(was_active_, is_active);
    if (workspace_.input.held != nullptr) return true;
    return (is_active || was_active) && !is_text_field_active();
  }
  void cancel_upload() {
    workspace_.changes.enqueue({.name = "Cancel Upload",
                                .run =
                                    [this] {
                                      if (opener_.can_cancel_upload()) return_to_replaced();
                                      return true;
                                    },
                                .always = true});
  }
  void return_to_replaced() {
    std::set<fs::path> altered = std::move(replaced_altered_);
    opener_.cancel_upload();
    altered_ = std::move(altered);
  }
  bool autosave(int interval) {
    const Recovery::Time time{workspace_.screen.clock->seconds(), static_cast<double>(interval)};
    return recovery_.follow(workspace_.session, workspace_.view, workspace_.input.held != nullptr, time,
                            workspace_.message);
  }
  // Empty if everything is saved, or if the autosave failed.
  std::string state_of_autosave() const {
    const std::optional<double> at = recovery_.flushed_at();
    return at && is_autosaved_ ? autosave_words(workspace_.screen.clock->seconds() - *at) : "";
  }
  // Makes the next check record the present state of the files.
  void watch_again() {
    watched_.watch({});
    documents_files_.clear();
    changed_.clear();
    check_at_ = 0;
  }
  void check_files() {
    if (workspace_.opening.loader.busy() || workspace_.screen.clock->seconds() < check_at_) return;
    check_at_ = workspace_.screen.clock->seconds() + kCheckSeconds;
    const std::vector<fs::path> files = files_of(workspace_.session);
    if (files != documents_files_) {
      documents_files_ = files;
      std::vector<fs::path> watched = files;
      for (const fs::path& file : files) {
        for (const fs::path& side : side_files_of(file)) {
          if (std::ranges::find(watched, side) == watched.end()) watched.push_back(side);
        }
      }
      watched_.watch(watched);
      changed_.clear();
    } else if (std::vector<fs::path> changed = watched_.changed(); !changed.empty()) {
      altered_.insert(changed.begin(), changed.end());
      changed_ = std::move(changed);
    }
  }
  void offer_reload() {
    const ViewState& view = workspace_.view;
    if (changed_.empty() || workspace_.opening.loader.busy() || !view.frame_asked_for.empty()) return;
    const ReloadChoice choice = draw_reload_card(changed_, view.layout.first);
    if (choice == ReloadChoice::kNone) return;
    watch_again();
    if (choice == ReloadChoice::kReload) leave_for([this] { reload(); });
  }
  // Opens the document again, seen from the same place unless its size is another one.
  void reload() {
    const ViewState& view = workspace_.view;
    kept_view_ = View{view.seen_first().near().eye, view.camera.pivot()};
    kept_diagonal_ = workspace_.world().loaded_bounds().diagonal();
    opener_.open(files_to_reload(workspace_.session));
  }
  void restore_view() {
    if (!reloaded_view_) return;
    const View view = *std::exchange(reloaded_view_, std::nullopt);
    const double diagonal = workspace_.world().loaded_bounds().diagonal();
    if (diagonal > kOtherSize * kept_diagonal_ || kept_diagonal_ > kOtherSize * diagonal) return;
    workspace_.view.camera.look(view.eye, view.target);
    workspace_.view.camera.finish();
    workspace_.view.picture_old = true;
  }
  void decide() {
    switch (take_decision(decisions_, workspace_.opening.recoverable)) {
      case Decision::kNone:
        break;
      case Decision::kLeave:
        KERF_ASSERT(decisions_.leaving);
        go(std::exchange(decisions_.leaving, nullptr));
        break;
      case Decision::kSaveFirst:
        if (workspace_.session.file.empty()) {
          select_file_to_save();
        } else {
          save_to(workspace_.session.file);
        }
        break;
      case Decision::kRecover:
        go([this] { opener_.open_recovered(); });
        break;
      case Decision::kFindMesh:
        select_missing_mesh();
        break;
    }
  }
  // Gives up once the user has cancelled the question or the file dialog.
  void ask_about_mesh() {
    if (!opener_.missing()) has_asked_about_mesh_ = false;
    if (!opener_.missing() || decisions_.question.open() || workspace_.services.browser.open) return;
    if (has_asked_about_mesh_) return opener_.give_up();
    has_asked_about_mesh_ = true;
    const FileOpener::MissingMesh& missing = *opener_.missing();
    ask_about_missing_mesh(decisions_, missing.order.name(), missing.mesh, missing.refused);
  }
  // Begins in the folder of the scene or journal.
  void select_missing_mesh() {
    if (!opener_.missing()) return;
    const LoadRequest& order = opener_.missing()->order;
    browse(workspace_.services.browser,
           {.title = "Find Mesh File",
            .verb = "Open",
            .hint = "Filter, or paste a full path",
            .only = FileKind::kMeshes,
            .take =
                [this](const fs::path& file) {
                  has_asked_about_mesh_ = false;
                  if (opener_.missing()) opener_.open_with(file);
                  return "";
                },
            .previewed_as = &workspace_.settings,
            .thumbnails = &workspace_.services.thumbnails},
           order.left ? workspace_.settings.folder : order.files.front().parent_path(), "");
  }
  void save() {
    if (workspace_.session.file.empty()) return select_file_to_save();
    workspace_.changes.enqueue(
        {.name = "Save", .run = [this] { return save_to(workspace_.session.file), true; }, .always = true});
  }
  // Returns true if the file was written, perhaps without the cuts.
  bool save_to(const fs::path& file) {
    cancel_stroke(workspace_);
    record_changes();
    const bool saved =
        save_work(workspace_.session, workspace_.view, file, workspace_.settings, workspace_.message);
    if (workspace_.message.is_error) return false;
    recovery_.begin(workspace_.session, workspace_.view);
    const bool replaced_other = altered_.erase(file) > 0;
    const bool warned = file.extension() != ".json" && warn_about_meshes();
    watch_again();
    if (replaced_other && !warned) report_replaced(file);
    if (saved && !warned && decisions_.leaving) go(std::exchange(decisions_.leaving, nullptr));
    return true;
  }
  void record_changes() {
    (void)watched_.changed();  // the second call also returns files changed just now
    const std::vector<fs::path> changed = watched_.changed();
    altered_.insert(changed.begin(), changed.end());
  }
  void report_replaced(const fs::path& file) {
    workspace_.message.info(workspace_.message.text + "; the version of another program is now " +
                            previous_version(whole_path(file)).filename().string());
  }
  // Returns true if the saved journal refers to a mesh, or its buffer, that another program has changed.
  bool warn_about_meshes() {
    const auto mesh = mismatched_mesh(workspace_.session, altered_);
    if (mesh) {
      workspace_.message.error(
          "Saved, but " + mesh->filename().string() +
          " was changed by another program: the saved file opens only with its old content.");
      return true;
    }
    const auto buffer = changed_buffer(workspace_.session, altered_);
    if (buffer) {
      workspace_.message.error("Saved, but " + buffer->filename().string() +
                               " was changed by another program: the saved file opens with its new content.");
    }
    return buffer.has_value();
  }
  // Saves to a file of the dialog. If that fails, the dialog opens again in its folder with the error, and
  // `folder` is the remembered one.
  void save_as(const fs::path& file, const fs::path& folder) {
    if (save_to(file)) return;
    workspace_.settings.folder = folder;
    std::error_code error;
    const bool has_folder = fs::is_directory(file.parent_path(), error);
    select_file_to_save((has_folder ? file.filename() : file).string(),
                        has_folder ? file.parent_path() : folder);
    workspace_.services.browser.fault = workspace_.message.text;
  }
  void select_file_to_open() {
    browse(workspace_.services.browser,
           {.title = "Open",
            .verb = "Open",
            .hint = "Filter, or paste a full path",
            .take =
                [this](const fs::path& file) {
                  workspace_.links.open({file});
                  return "";
                },
            .previewed_as = &workspace_.settings,
            .thumbnails = &workspace_.services.thumbnails},
           workspace_.settings.folder, "");
  }
  void select_file_to_save() {
    select_file_to_save(suggested_name(workspace_.session), workspace_.settings.folder);
  }
  void select_file_to_save(const std::string& name, const fs::path& begins_in) {
    browse(workspace_.services.browser,
           {.title = "Save",
            .verb = "Save",
            .hint = "File name: .kerf keeps everything, .json the scene without the cuts",
            .endings = {".kerf", ".json"},
            .take =
                [this, folder = workspace_.settings.folder](const fs::path& file) {
                  workspace_.changes.enqueue(
                      {.name = "Save",
                       .run = [this, file, folder] { return save_as(file, folder), true; },
                       .always = true});
                  return "";
                }},
           begins_in, name);
  }
  void take_picture(Captured what) {
    const Window& window = *workspace_.screen.window;
    const Vec2 pixels = window.pixel_size();
    const Area part = what == Captured::kWindow ? Area{Vec2(0), pixels}
                                                : pixels_of(workspace_.view.layout.viewport, window);
    const auto file = take_screenshot(pixels, part);
    workspace_.message.show(file ? "Saved: " + file->string() : file.error().message, !file.ok());
  }

  // The last action that closed the open document, and the parts of the document that could be edited since.
  struct PendingOpening {
    std::function<void()> begin;
    std::string head;  // SceneDescription::others
    std::vector<Light> lights;
  };

  Workspace& workspace_;
  Decisions decisions_;
  Recovery recovery_;
  FileOpener opener_{workspace_, recovery_};
  PendingOpening pending_;
  bool was_active_ = false;            // a drag, widget or text field, in the last frame
  std::vector<fs::path> companions_;   // such as paths, which are loaded once the files are open
  bool has_asked_about_mesh_ = false;  // about FileOpener::missing()
  bool is_autosaved_ = false;          // the last attempt succeeded
  WatchedFiles watched_;
  std::vector<fs::path> documents_files_;  // which are watched, with their side files
  std::vector<fs::path> changed_;          // by other programs, offered for reloading
  std::set<fs::path> altered_;             // likewise, since the document was opened
  std::set<fs::path> replaced_altered_;    // likewise, of the document that was open before
  double check_at_ = 0;                    // s of the clock, of the next check
  std::optional<View> kept_view_;          // during a reload
  std::optional<View> reloaded_view_;      // after it, until the camera has it
  double kept_diagonal_ = 0;               // m, of the world at its begin
  std::optional<Captured> screenshot_;     // waits until this is drawn
};

// Actions
// --------------------------------------------------------------------------------------------------------

// Opening
// --------------------------------------------------------------------------------------------------------

// Closing
// --------------------------------------------------------------------------------------------------------

// Saving
// --------------------------------------------------------------------------------------------------------

// Windows
// --------------------------------------------------------------------------------------------------------

}  // namespace

std::unique_ptr<Feature> files_feature(Workspace& workspace) {
  return std::make_unique<FilesFeature>(workspace);
}

}  // namespace kerf
