#include "ui/editor/files/unsaved_work.h"

#include <chrono>
#include <ctime>

#include "core/base/assert.h"
#include "core/document/command_log.h"
#include "core/document/save.h"
#include "ui/editor/shared/file_frames.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::vector<Light> lights_shown(const SceneDescription& scene) {
  return scene.lights.empty() ? std::vector{Light{}} : scene.lights;
}

Status write_all(DocumentSession& session, const ViewState& view, const fs::path& file) {
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

}  // namespace

bool is_to_be_kept(const DocumentSession& session, const std::vector<Light>& lights) {
  const std::vector<Command>& journal = session.document.journal();
  if (session.saved_commands > journal.size() || lights != session.saved_lights) return true;
  if (session.scene.others != session.saved_head) return true;
  return !std::all_of(journal.begin() + static_cast<std::ptrdiff_t>(session.saved_commands), journal.end(),
                      only_cools);
}

bool is_unsaved(const DocumentSession& session, const std::vector<Light>& lights) {
  if (!is_to_be_kept(session, lights)) return false;
  const bool dressed_as_saved = lights == session.saved_lights && session.scene.others == session.saved_head;
  const std::vector<Command>& journal = session.document.journal();
  return !dressed_as_saved || session.saved_commands > journal.size() ||
         !lasts_as_saved(journal, session.saved_commands);
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
  session.saved_lights = view.look.lights;
  session.saved_head = session.scene.others;
  remember_recent(settings, file);
  const bool cut = is_unsaved(session, view.look.lights);
  message.info("Saved: " + file.string() + (cut ? ", without the cuts: save as .kerf to keep them" : ""));
  return !cut;
}

namespace {
constexpr std::chrono::seconds kBetweenTries{1};
}  // namespace

void Recovery::begin(const DocumentSession& session, const ViewState& view) {
  lights_ = view.look.lights;
  head_ = session.scene.others;
  autosave_.begin(scene_now(session, view), session.file, session.files);
}

bool Recovery::follow(DocumentSession& session, const ViewState& view, bool mouse_moves, Message& message) {
  if (!is_to_be_kept(session, view.look.lights)) {
    if (autosave_.keeps()) autosave_.drop();
    return true;
  }
  if (!well_ && Clock::now() < failed_at_ + kBetweenTries) return false;
  mark_state(session.document, session.marks);
  const bool changed = view.look.lights != lights_ || session.scene.others != head_;
  if (!mouse_moves && changed) begin(session, view);
  const Status kept = autosave_.follow(session.document, session.marks);
  if (!kept && well_) message.error("Autosave failed: " + kept.error().message);
  if (!kept) failed_at_ = Clock::now();
  well_ = kept.ok();
  return well_;
}

namespace {

std::string time_text(std::filesystem::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(system));
  std::tm parts{};
  localtime_r(&seconds, &parts);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), "%e %B %Y, %H:%M", &parts);
  return text.data();
}

std::string name_of(const RecoverableDocument& left) {
  const Journal& journal = left.journal;
  if (!journal.work_of.empty()) return journal.work_of.filename().string();
  if (!journal.opened.empty()) return journal.opened.front().filename().string();
  return journal.scene.bodies.front().mesh.filename().string();
}

void ask_about_unsaved(Decisions& decisions, const DocumentSession& session) {
  decisions.about = Decisions::About::kUnsaved;
  Question& q = decisions.question = Question();
  q.title = "Save changes?";
  q.text = name_of_work(session) + " has unsaved changes.";
  q.choices = {{"Save", "Save first (Enter, S).", 'S'},
               {"Discard", "Close without saving (D).", 'D'},
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
  if (answer == 0) return Decision::kGoOn;
  if (answer == 2) {
    recoverable.clear();
    return Decision::kNone;
  }
  recoverable.front().file.remove();
  recoverable.erase(recoverable.begin());
  ask_about_recovery(decisions, recoverable);
  return Decision::kNone;
}

}  // namespace

bool may_leave(Decisions& decisions, const DocumentSession& session, const std::vector<Light>& lights,
               const std::function<void()>& then) {
  if (!is_unsaved(session, lights)) return true;
  KERF_ASSERT(!decisions.question.open());
  decisions.leaving = then;
  ask_about_unsaved(decisions, session);
  return false;
}

void ask_about_recovery(Decisions& decisions, const std::vector<RecoverableDocument>& recoverable) {
  if (recoverable.empty()) return;
  const RecoverableDocument& left = recoverable.front();
  decisions.about = Decisions::About::kRecovery;
  Question& q = decisions.question = Question();
  q.title = "Recover unsaved work?";
  q.text = "Kerf quit unexpectedly without saving " + name_of(left) + ", with " +
           count_text(left.strokes, "stroke") + ", last changed on " + time_text(left.last_change) + ".";
  if (recoverable.size() > 1)
    q.text += " " + count_text(recoverable.size() - 1, "more document") + " can be recovered.";
  q.choices = {{"Recover", "Open it in its last state (Enter, R).", 'R'},
               {"Discard", "Delete it permanently."},
               {"Later", "Ask again at the next start (Esc, L).", 'L'}};
}

Decision take_decision(Decisions& decisions, std::vector<RecoverableDocument>& recoverable) {
  if (!decisions.question.answer) return Decision::kNone;
  KERF_ASSERT(*decisions.question.answer < decisions.question.choices.size());
  const size_t answer = *std::exchange(decisions.question, {}).answer;
  return decisions.about == Decisions::About::kUnsaved ? decide_on_unsaved(decisions, answer)
                                                       : decide_on_recovery(decisions, recoverable, answer);
}

}  // namespace kerf
