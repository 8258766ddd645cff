#include "ui/editor/files/file_opener.h"

#include <imgui.h>
#include <ctime>

#include "core/base/assert.h"
#include "core/document/command_log.h"
#include "core/document/save.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

std::vector<Light> lights_shown(const SceneDescription& scene) {
  return scene.lights.empty() ? std::vector{Light{}} : scene.lights;
}

Status write_all(DocumentSession& session, const ViewState& view, const fs::path& file) {
  session.document.seal_journal();  // a mark does so only if nothing is queued
  mark_state(session.document, session.marks, true);
  if (Status hashed = record_hashes(session.scene); !hashed) return hashed;
  return save_journal(file, scene_now(session, view), session.document.journal(), session.marks);
}

// Returns true if a command only lets hot material cool, which need not be recovered.
bool only_cools(const Command& command) {
  const AdvanceTime* time = std::get_if<AdvanceTime>(&command);
  return time != nullptr && !time->bodies;
}

// Returns true if the commands in effect are the saved ones, apart from mere cooling: no others followed, or
// all of them were undone. Takes linear time in the journal only if the last command is undo or redo; any
// other last command is in effect.
bool lasts_as_saved(const std::vector<Command>& journal, size_t saved) {
  size_t end = journal.size();
  if (saved > end) return false;
  while (end > saved && only_cools(journal[end - 1])) --end;
  if (end == saved) return true;
  if (!std::holds_alternative<Undo>(journal[end - 1]) && !std::holds_alternative<Redo>(journal[end - 1]))
    return false;
  const std::vector<bool> now = lasting_commands(journal),
                          then = lasting_commands(std::span(journal).first(saved));
  for (size_t i = 0; i < journal.size(); ++i) {
    const bool lasted = i < saved && then[i];
    if (now[i] != lasted && !only_cools(journal[i])) return false;
  }
  return true;
}
constexpr double kBetweenTries = 1;  // s

std::string time_text(std::filesystem::file_time_type time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::floor<std::chrono::seconds>(std::chrono::file_clock::to_sys(time)));
  std::tm parts{};
  localtime_r(&seconds, &parts);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), " %B %Y, %H:%M", &parts);
  return std::to_string(parts.tm_mday) + text.data();
}

std::string name_of(const RecoverableDocument& left) {
  const Journal& journal = left.journal;
  if (!journal.work_of.empty()) return journal.work_of.filename().string();
  if (!journal.opened.empty()) return journal.opened.front().filename().string();
  return journal.scene.bodies.front().mesh.filename().string();
}

void ask_about_unsaved(Decisions& decisions, const DocumentSession& session, bool unprompted) {
  decisions.about = Decisions::About::kUnsaved;
  Question& q = decisions.question = Question();
  q.title = "Save changes?";
  q.text = name_of_work(session) + " has unsaved changes.";
  q.choices = {{"Save", "Save first (Enter, S).", 'S'},
               unprompted ? Question::Choice{"Discard", "Close without saving."}
                          : Question::Choice{"Discard", "Close without saving (D).", 'D'},
               {"Cancel", "Keep editing (Esc, C).", 'C'}};
}

Decision decide_on_unsaved(Decisions& decisions, size_t answer) {
  if (answer == 0) return Decision::kSaveFirst;
  if (answer == 1) return Decision::kLeave;
  decisions.leaving = nullptr;
  return Decision::kNone;
}

Decision decide_on_recovery(Decisions& decisions, std::vector<RecoverableDocument>& recoverable,
                            size_t answer) {
  KERF_ASSERT(!recoverable.empty());
  if (answer == 0) return Decision::kRecover;
  if (answer == 2) {
    recoverable.clear();
    return Decision::kNone;
  }
  recoverable.front().file.remove();
  recoverable.erase(recoverable.begin());
  ask_about_recovery(decisions, recoverable);
  return Decision::kNone;
}

void dress_as(ViewState& view, const SceneDescription& scene, const FileFrame& frame) {
  view.home = scene.view;
  // The lights of a scene are in world coordinates, and the default light comes from above.
  if (scene.lights.empty()) {
    view.camera.set_up_axis(UpAxis::kY);
    view.look.lights = {Light{}};
  } else {
    view.camera.set_up_axis(frame.up);
    view.look.lights = scene.lights;
  }
  show_in_frame(view, frame);
  if (const auto show = parse_show_list(scene.show); show && !scene.show.empty()) view.look.show = *show;
}

// The first reason is in the status bar, the others are in the log.
void report_refused(Message& message, const LoadedFiles& loaded) {
  const size_t count = loaded.refused.size();
  for (size_t i = 1; i < count; ++i) message.note(loaded.refused[i], true);
  const std::string others =
      count == 1 ? "" : " (and " + std::to_string(count - 1) + " more, see Help > Messages)";
  message.error(loaded.order.name() + " opened, without: " + loaded.refused.front() + others);
}

std::string words_on_skip(Ticks skipped) {
  return "Skipped " + grouped(skipped / kTicksPerSecond) +
         " s of simulation; bodies are at their saved positions.";
}

// An error that was shown since the opening began stays. The name alone is only logged, because the status
// bar shows it as that of the open file.
void report_opened(Message& message, const LoadedFiles& loaded) {
  const std::string opened = loaded.order.left
                                 ? words_on_recovery(loaded)
                                 : loaded.order.name() + (loaded.notes.empty() ? "" : ": " + loaded.notes);
  const bool tells_more = loaded.order.left || !loaded.notes.empty();
  if (!message.is_error && !tells_more) message.clear();
  message.is_error || !tells_more ? message.note(opened, false) : message.info(opened);
  // Without hashes the work can be cut but not saved.
  if (loaded.cannot_be_kept) message.error(loaded.cannot_be_kept->message);
  if (loaded.skipped > 0) message.info(words_on_skip(loaded.skipped));
  if (!loaded.fault.empty()) message.error(loaded.fault);
  if (!loaded.refused.empty()) report_refused(message, loaded);
}

// Records which part of the open document is saved, and where.
void record_saved_state(DocumentSession& session, const LoadedFiles& loaded,
                        const std::vector<Light>& lights) {
  const LoadRequest& order = loaded.order;
  KERF_ASSERT(order.left || !order.files.empty());
  session.files = order.files;
  session.file = file_to_save(loaded);
  if (order.left && session.file != order.left->work_of) {
    session.files = {order.left->work_of};
  } else if (order.left) {
    session.files = order.left->opened;
    for (const SceneBody& body : loaded.scene.bodies) {
      if (order.left->opened.empty()) session.files.push_back(body.mesh);
    }
  }
  const bool saved = !order.left && !loaded.damaged && order.moved.empty();
  session.saved_commands = saved ? session.document.journal().size() : DocumentSession::kNothing;
  session.saved_lights = lights;
  session.saved_head = loaded.scene.others;
}
constexpr double kShowWindowAfter = 0.2;  // s, after the start, until the window shows something

constexpr double kUnderAxes = 9.6;  // sizes of the text
constexpr ImGuiWindowFlags kBar = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                  ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// Returns the unit most often confused with a unit.
FileUnit other_unit(FileUnit unit) {
  switch (unit) {
    case FileUnit::kMillimetre:
      return FileUnit::kInch;
    case FileUnit::kCentimetre:
      return FileUnit::kMetre;
    case FileUnit::kMetre:
    case FileUnit::kInch:
      break;
  }
  return FileUnit::kMillimetre;
}

const char* plural(FileUnit unit) {
  switch (unit) {
    case FileUnit::kMillimetre:
      return "millimetres";
    case FileUnit::kCentimetre:
      return "centimetres";
    case FileUnit::kMetre:
      return "metres";
    case FileUnit::kInch:
      break;
  }
  return "inches";
}

void draw_sizes(const Vec3& size, FileUnit unit) {
  ImGui::TextUnformatted(extents_label(size, unit).c_str());
  mark_last_item("frame size");
  const FileUnit other = other_unit(unit);
  ImGui::TextDisabled("In %s it would be %s", plural(other), extents_label(size, other).c_str());
}

void draw_rows(const Vec3& size, DocumentSession& session, ViewState& view, Settings& settings) {
  const std::string kind = view.frame_asked_for;
  const float em = ImGui::GetFontSize();
  FileFrame frame = view.frame;
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextUnformatted("Units and up axis (detected from the file)");
  ImGui::PopStyleColor();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Up");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(4 * em);
  bool changed = up_axis_combo(frame.up);
  ImGui::SameLine();
  ImGui::TextUnformatted("Unit");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(4.5f * em);
  changed = unit_combo(frame.unit) || changed;
  if (changed) change_frame(frame, session, view);
  draw_sizes(size, view.frame.unit);
  if (ImGui::Button(("Use for all ." + kind + " files").c_str())) {
    settings.frames[kind] = view.frame;
    view.frame_asked_for.clear();
  }
  mark_last_item("frame for all");
  tooltip("Uses this unit and axis for all files of this kind. Change them in the File panel.");
  ImGui::SameLine();
  if (ImGui::Button("Use for this file only")) {
    settings.frames[kind].reset();
    view.frame_asked_for.clear();
  }
  mark_last_item("frame for this");
  tooltip("Units of other files of this kind are detected from their size. Change this in the File panel.");
}

// Moves the current window to the right border of the viewport: under the axes, or higher if it needs the
// room. In a narrow viewport, where it would cover the middle, it lies at the upper border, left of the axes.
void place_next_to_axes(const Area& viewport) {
  const double em = ImGui::GetFontSize();
  const ImVec2 size = ImGui::GetWindowSize();
  const Vec2 lowest = viewport.at + viewport.size - Vec2(size.x, size.y);
  const bool is_narrow = size.x > 0.5 * viewport.size.x;
  const Vec2 wanted =
      is_narrow ? viewport.at + Vec2(0.4 * em) : Vec2(lowest.x - 0.8 * em, viewport.at.y + kUnderAxes * em);
  ImGui::SetWindowPos(to_im(glm::max(glm::min(wanted, lowest), viewport.at)));
}

}  // namespace

bool needs_recovery_file(const DocumentSession& session, const std::vector<Light>& lights) {
  const std::vector<Command>& journal = session.document.journal();
  if (session.saved_commands > journal.size() || lights != session.saved_lights) return true;
  if (session.scene.others != session.saved_head) return true;
  return !std::all_of(journal.begin() + static_cast<std::ptrdiff_t>(session.saved_commands), journal.end(),
                      only_cools);
}

bool is_unsaved(const DocumentSession& session, const std::vector<Light>& lights) {
  if (!needs_recovery_file(session, lights)) return false;
  const bool dressed_as_saved = lights == session.saved_lights && session.scene.others == session.saved_head;
  return !dressed_as_saved || !lasts_as_saved(session.document.journal(), session.saved_commands);
}

std::string name_of_work(const DocumentSession& session) {
  if (!session.file.empty()) return session.file.filename().string();
  if (session.files.empty()) return "Untitled";
  std::string name = session.files.front().filename().string();
  if (session.files.size() > 1) name += " and " + std::to_string(session.files.size() - 1) + " more";
  return name;
}

std::string window_title(const DocumentSession& session, const std::vector<Light>& lights) {
  return name_of_work(session) + (is_unsaved(session, lights) ? "*" : "") + " - Kerf";
}

std::string suggested_name(const DocumentSession& session) {
  if (!session.file.empty()) return session.file.filename().string();
  return (session.files.empty() ? "untitled" : session.files.front().stem().string()) + ".kerf";
}

SceneDescription scene_now(const DocumentSession& session, const ViewState& view) {
  SceneDescription scene = session.scene;
  scene.view = View{view.seen().near().eye, view.camera.pivot()};
  record_frame(scene, view.frame);
  if (view.look.lights != lights_shown(scene)) scene.lights = view.look.lights;
  return scene;
}

bool save_work(DocumentSession& session, const ViewState& view, fs::path file, Settings& settings,
               Message& message) {
  const bool scene_alone = file.extension() == ".json";
  if (!scene_alone && file.extension() != ".kerf") file += ".kerf";
  const Status saved =
      scene_alone ? save_scene(file, scene_now(session, view)) : write_all(session, view, file);
  if (!saved) {
    message.error(saved.error().message);
    return false;
  }
  if (!scene_alone) {
    session.file = file;
    session.saved_commands = session.document.journal().size();
  }
  const bool has_journal =
      !session.file.empty() || (!session.files.empty() && is_journal(session.files.front()));
  if (!scene_alone || !has_journal) {
    session.saved_lights = view.look.lights;
    session.saved_head = session.scene.others;
  }
  remember_recent(settings, file);
  const bool cut = !lasts_as_saved(session.document.journal(), session.saved_commands);
  message.info("Saved: " + file.string() + (cut ? ", without the cuts: save as .kerf to keep them" : ""));
  return !is_unsaved(session, view.look.lights);
}

void Recovery::begin(const DocumentSession& session, const ViewState& view) {
  lights_ = view.look.lights;
  head_ = session.scene.others;
  frame_ = view.frame;
  autosave_.begin(scene_now(session, view), session.file, session.files);
  written_at_ = flushed_at_ = std::nullopt;
}

bool Recovery::follow(DocumentSession& session, const ViewState& view, bool mouse_moves, const Time& time,
                      Message& message) {
  if (!needs_recovery_file(session, view.look.lights)) {
    if (autosave_.keeps()) autosave_.drop();
    written_at_.reset();
    flushed_at_.reset();
    return true;
  }
  mark_state(session.document, session.marks);
  const double from = well_ ? written_at_.value_or(time.seconds) + (written_at_ ? time.interval : 0)
                            : tried_at_ + kBetweenTries;
  if (!autosave_.flush()) flushed_at_ = written_at_;
  if (time.seconds < from) return well_;
  const bool changed = view.look.lights != lights_ || session.scene.others != head_ || view.frame != frame_;
  if (!mouse_moves && changed) begin(session, view);
  const bool writes = autosave_.is_behind(session.document, session.marks);
  const Status kept = autosave_.follow(session.document, session.marks);
  if (!kept && well_) message.error("Autosave failed: " + kept.error().message);
  well_ = kept.ok();
  tried_at_ = time.seconds;
  if (kept && writes) written_at_ = time.seconds;
  return well_;
}

std::string autosave_words(double age) {
  const auto seconds = static_cast<int>(std::max(age, 0.0));
  if (seconds < 10) return "autosaved";
  if (seconds < 60) return "autosaved " + std::to_string(seconds / 10 * 10) + " s ago";
  return "autosaved " + std::to_string(seconds / 60) + " min ago";
}

bool may_leave(Decisions& decisions, const DocumentSession& session, const std::vector<Light>& lights,
               const std::function<void()>& then, bool unprompted) {
  if (!is_unsaved(session, lights)) return true;
  KERF_ASSERT(!decisions.question.open());
  decisions.leaving = then;
  ask_about_unsaved(decisions, session, unprompted);
  return false;
}

void ask_about_recovery(Decisions& decisions, const std::vector<RecoverableDocument>& recoverable) {
  if (recoverable.empty()) return;
  const RecoverableDocument& left = recoverable.front();
  decisions.about = Decisions::About::kRecovery;
  Question& q = decisions.question = Question();
  q.title = "Recover unsaved work?";
  q.text = "Kerf quit unexpectedly without saving " + name_of(left) + ", with " +
           count_text(left.cuts, "cut") + ", last changed on " + time_text(left.last_change) + ".";
  if (recoverable.size() > 1)
    q.text += " " + count_text(recoverable.size() - 1, "more document") + " can be recovered.";
  q.choices = {{"Recover", "Open it in its last state (Enter, R).", 'R'},
               {"Discard", "Delete it permanently."},
               {"Later", "Ask again at the next start (Esc, L).", 'L'}};
}

void ask_about_missing_mesh(Decisions& decisions, const std::string& name, const fs::path& mesh,
                            const std::string& refused) {
  decisions.about = Decisions::About::kMissingMesh;
  Question& q = decisions.question = Question();
  q.title = refused.empty() ? "Mesh file not found" : "Wrong mesh file";
  q.text = (refused.empty() ? "" : refused + " ") + name + " needs " + mesh.filename().string() +
           ", which is not in " + mesh.parent_path().string() + ".";
  q.choices = {{"Find...", "Select the file where it is now (Enter, F).", 'F'},
               {"Cancel", "Do not open " + name + " (Esc, C).", 'C'}};
}

Decision take_decision(Decisions& decisions, std::vector<RecoverableDocument>& recoverable) {
  if (!decisions.question.answer) return Decision::kNone;
  KERF_ASSERT(*decisions.question.answer < decisions.question.choices.size());
  const size_t answer = *std::exchange(decisions.question, {}).answer;
  switch (decisions.about) {
    case Decisions::About::kUnsaved:
      return decide_on_unsaved(decisions, answer);
    case Decisions::About::kRecovery:
      return decide_on_recovery(decisions, recoverable, answer);
    case Decisions::About::kMissingMesh:
      break;
  }
  return answer == 0 ? Decision::kFindMesh : Decision::kNone;
}

void show_partial_replay(Workspace& workspace, PartialReplay replay) {
  Renderer& renderer = workspace.screen.picture->first();
  const bool is_new = !workspace.opening.partial_world;
  workspace.opening.partial_world = std::move(replay.world);
  if (is_new) {
    const World::Bounds bounds = workspace.opening.partial_world->loaded_bounds();
    renderer.show(*workspace.opening.partial_world, replay.scene.paints, std::move(replay.prepared));
    dress_as(workspace.view, replay.scene,
             select_frame(replay.scene, false, bounds, workspace.settings).frame);
    workspace.session.saved_lights = workspace.view.look.lights;
    go_home(workspace.view, bounds);
    workspace.view.camera.finish();
  } else {
    renderer.resend(*workspace.opening.partial_world, std::move(replay.prepared));
  }
  workspace.view.picture_old = true;
}

void show_loaded(Workspace& workspace, LoadedFiles loaded) {
  DocumentSession& session = workspace.session;
  const bool was_shown = std::exchange(workspace.opening.partial_world, std::nullopt).has_value();
  session.document = std::move(loaded.document);
  session.as_loaded = std::move(loaded.as_loaded);
  session.paints = loaded.scene.paints;
  session.scene = loaded.scene;
  session.marks = std::move(loaded.marks);
  workspace.changes.forget();
  workspace.links.replaced();
  if (session.document.history().last_cut()) workspace.laser.show(session.document.history().last_settings());
  workspace.screen.picture->first().show(session.world(), session.paints, std::move(loaded.prepared));
  follow_world(session.world(), Delta{}, workspace.view.look.pieces);
  workspace.view.numbers.follow(session.world(), true, false, workspace.view.look.pieces);
  const World::Bounds bounds = session.world().loaded_bounds();
  const bool is_mesh_file = !loaded.order.left && !loaded.order.files.empty() &&
                            mesh_format(loaded.order.files.front().extension().string()).has_value();
  const FrameChoice choice = select_frame(loaded.scene, is_mesh_file, bounds, workspace.settings);
  workspace.view.frame_asked_for = choice.ask ? mesh_kind(loaded.scene) : "";
  dress_as(workspace.view, loaded.scene, choice.frame);
  if (!was_shown) {  // otherwise the user may have moved the camera
    go_home(workspace.view, bounds);
    workspace.view.camera.finish();
  }
  report_opened(workspace.message, loaded);
  record_saved_state(session, loaded, workspace.view.look.lights);
  workspace.view.picture_old = workspace.services.statistics.world_changed = true;
}

// Files that are read quickly are shown at once.
Status FileOpener::open_first(fs::path default_scene, const std::vector<fs::path>& files) {
  default_scene_ = std::move(default_scene);
  if (files.empty()) return open_default_scene();
  show_empty_stage();
  workspace_.opening.loader.start(order_of(files), stage_is_empty_);
  if (workspace_.opening.loader.is_over(kShowWindowAfter)) take_loaded(true);
  return Done{};
}

// Shows the ground alone, from three-quarter in front.
void FileOpener::show_empty_stage() {
  stage_is_empty_ = true;
  workspace_.screen.picture->first().show(workspace_.world(), {}, {});
  workspace_.session.saved_lights = workspace_.view.look.lights;
  go_home(workspace_.view, {Vec3(-1), Vec3(1)});
  workspace_.view.camera.finish();
}

LoadRequest FileOpener::order_of(std::vector<std::filesystem::path> files) const {
  return {std::move(files), {}, workspace_.settings.history_bytes()};
}

Status FileOpener::open_default_scene() {
  Result<LoadedFiles> loaded = load_files(order_of({default_scene_}), nullptr);
  if (!loaded) return loaded.error();
  show(std::move(*loaded));
  return Done{};
}

FileOpener::ReplacedDocument FileOpener::take_open_document() {
  const ViewState& view = workspace_.view;
  return {std::exchange(workspace_.session, DocumentSession()),
          workspace_.laser,
          view.camera,
          view.frame,
          view.home,
          view.look.lights,
          view.look.show,
          view.look.pieces,
          view.numbers,
          view.spread,
          workspace_.screen.picture->first().loaded_shadings()};
}

void FileOpener::bring_back(ReplacedDocument before) {
  DocumentSession& session = workspace_.session = std::move(before.session);
  workspace_.changes.forget();
  workspace_.links.replaced();
  workspace_.laser = before.laser;
  ViewState& view = workspace_.view;
  view.camera = before.camera;
  view.frame = before.frame;
  view.frame_asked_for.clear();
  view.home = before.home;
  view.look.lights = before.lights;
  view.look.show = before.show;
  view.look.pieces = std::move(before.pieces);
  view.numbers = std::move(before.numbers);
  view.spread = before.spread;
  PreparedBodies prepared;
  for (auto& [id, shading] : before.shadings)
    prepared.emplace(id, PreparedBody{shading.frame, std::move(shading.bases), nullptr});
  workspace_.screen.picture->first().show(session.world(), session.paints, std::move(prepared));
  shadows_due_ = true;
  workspace_.screen.picture->draft(true);
  view.picture_old = workspace_.services.statistics.world_changed = true;
}

bool FileOpener::can_cancel_upload() const {
  return uploads_ && workspace_.screen.picture->first().is_sending() &&
         !needs_recovery_file(workspace_.session, workspace_.view.look.lights);
}

void FileOpener::cancel_upload() {
  KERF_ASSERT(can_cancel_upload());
  uploads_ = false;
  const std::string cancelled = "Cancelled opening " + name_of_work(workspace_.session);
  if (!replaced_) {
    open_fresh();
    replaced_.reset();
    return workspace_.message.info(cancelled + ".");
  }
  bring_back(std::move(*std::exchange(replaced_, std::nullopt)));
  recovery_.drop();
  recovery_.begin(workspace_.session, workspace_.view);
  workspace_.message.info(cancelled + "; " + name_of_work(workspace_.session) + " is open again.");
}

// Drops the recovery data of the previous work.
void FileOpener::show(LoadedFiles loaded) {
  replaced_.reset();
  if (!stage_is_empty_) replaced_ = take_open_document();
  stage_is_empty_ = false;
  shadows_due_ = loaded.shadows_later;
  workspace_.screen.picture->draft(shadows_due_);
  show_loaded(workspace_, std::move(loaded));
  recovery_.drop();
  recovery_.begin(workspace_.session, workspace_.view);
}

void FileOpener::make_shadows() {
  Renderer& renderer = workspace_.screen.picture->first();
  if (!shadows_due_ || renderer.is_sending() || !workspace_.screen.picture->shows_draft()) return;
  if (workspace_.changes.is_pending() || workspace_.cutting()) return;
  shadows_due_ = false;
  const auto casters = std::make_shared<PreparedBodies>();
  LongChange change;
  change.title = "Shadows";
  change.run = [casters, loaded = renderer.loaded_shadings()](Document& document, const Progress& progress) {
    for (const BodyId id : document.world().ids()) {
      const auto found = loaded.find(document.world().body(id).loaded_as);
      if (found != loaded.end()) (*casters)[id].frame = found->second.frame;
    }
    Outcome outcome;
    if (const Status made = prepare_shadows(document.world(), *casters, &progress); !made)
      outcome.fail(made.error());
    return outcome;
  };
  change.then = [this, casters](const Outcome&) {
    workspace_.screen.picture->first().take_casters(std::move(*casters));
    workspace_.screen.picture->draft(false);
    workspace_.view.picture_old = true;
  };
  workspace_.changes.begin(std::move(change));
}

void FileOpener::open(std::vector<std::filesystem::path> files) {
  KERF_ASSERT(!files.empty());
  workspace_.message.clear();
  drop_partial_world();
  workspace_.opening.loader.start(order_of(std::move(files)), stage_is_empty_);
}

void FileOpener::open_fresh() {
  if (const Status opened = open_default_scene(); !opened) workspace_.message.error(opened.error().message);
}

void FileOpener::open_recovered() {
  KERF_ASSERT(!workspace_.opening.recoverable.empty());
  LoadRequest order = order_of({});
  order.left = workspace_.opening.recoverable.front().journal;
  order.left_at = workspace_.opening.recoverable.front().last_change;
  drop_partial_world();
  workspace_.opening.loader.start(std::move(order));
}

void FileOpener::take_loaded(bool may_replace) {
  if (!can_cancel_upload()) replaced_.reset(), uploads_ = false;
  FileLoader& loader = workspace_.opening.loader;
  if (loader.busy()) {
    if (auto replay = stage_is_empty_ ? loader.take_partial_replay() : std::nullopt)
      show_partial_replay(workspace_, std::move(*replay));
    KERF_ASSERT(!loader.order().left || !workspace_.opening.recoverable.empty());
    if (may_replace && loader.is_over(0)) {
      LoadRequest order = loader.order();
      take(*loader.take(), std::move(order));
    }
  }
  if (!stage_is_empty_ || loader.busy() || missing_) return;
  stage_is_empty_ = false;
  workspace_.opening.partial_world.reset();
  const Message why = workspace_.message;  // the file could not be opened
  open_substitute();
  if (!why.text.empty()) workspace_.message.show(why.text, why.is_error);
}

void FileOpener::open_with(const std::filesystem::path& mesh) {
  KERF_ASSERT(missing_);
  auto [order, replaced, refused] = *std::exchange(missing_, std::nullopt);
  replaced_mesh_ = replaced;
  found_ = mesh;
  order.moved[replaced_mesh_] = found_;
  workspace_.message.clear();
  drop_partial_world();
  workspace_.opening.loader.start(std::move(order), stage_is_empty_);
}

void FileOpener::give_up() {
  KERF_ASSERT(missing_);
  const auto [order, mesh, refused] = *std::exchange(missing_, std::nullopt);
  workspace_.message.error(order.name() + " was not opened: its mesh file " + mesh.string() + " is missing");
  if (order.left) workspace_.opening.recoverable.clear();  // the files are kept for the next start
}

// Returns true if an error of reading concerns the file of the last open_with().
bool FileOpener::is_wrong_mesh(const LoadRequest& order, const std::string& error) const {
  const auto moved = order.moved.find(replaced_mesh_);
  return moved != order.moved.end() && moved->second == found_ && error.starts_with(found_.string());
}

void FileOpener::take(Result<LoadedFiles> loaded, LoadRequest order) {
  const bool opened = loaded.ok(), left = order.left.has_value();
  if (opened) {
    cancel_stroke(workspace_);
    show(std::move(*loaded));
    uploads_ = true;
  } else if (const auto mesh = missing_mesh(order)) {
    missing_ = {std::move(order), *mesh, ""};
    return;
  } else if (is_wrong_mesh(order, loaded.error().message)) {
    const bool has_hash = left || is_journal(order.files.front());
    const std::string why = has_hash ? found_.filename().string() + " is not the mesh of " + order.name()
                                     : loaded.error().message;
    order.moved.erase(replaced_mesh_);
    missing_ = {std::move(order), replaced_mesh_, why + "."};
    return;
  } else {
    workspace_.message.error((left ? "Recovery failed; the recovery file was kept: " : "") +
                             loaded.error().message);
  }
  if (left) {
    const Recovery::Time now{workspace_.screen.clock->seconds()};
    const bool whole = opened && (order.left->damage.empty() || order.left->torn);
    if (whole && recovery_.follow(workspace_.session, workspace_.view, false, now, workspace_.message))
      workspace_.opening.recoverable.front().file.remove();
    workspace_.opening.recoverable.clear();  // the rest is offered at the next start
  } else if (opened) {
    for (const fs::path& file : workspace_.session.files) remember_recent(workspace_.settings, file);
  }
}

void draw_frame_question(const Vec3& size, DocumentSession& session, ViewState& view, Settings& settings,
                         bool cut_once) {
  if (cut_once) view.frame_asked_for.clear();
  if (view.frame_asked_for.empty() || view.layout.split()) return;
  const Area& area = view.layout.viewport;
  ImGui::SetNextWindowSizeConstraints({0, 0}, to_im(area.size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  if (ImGui::Begin("##frame", nullptr, kBar)) {
    draw_rows(size, session, view, settings);
    place_next_to_axes(area);
  }
  mark_window("frame question");
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace kerf
