#include "ui/editor/request_desk.h"

#include <algorithm>

#include "core/document/edit_path.h"
#include "core/document/save.h"
#include "core/document/stroke_settings.h"
#include "ui/editor/file_choice.h"
#include "ui/editor/laser_desk.h"
#include "ui/editor/work/save_work.h"

namespace kerf {

void RequestDesk::fulfil() {
  decide();
  Requests wanted = std::exchange(state_.requests, {});
  load_paths(wanted.open);
  state_.requests.screenshot = wanted.screenshot;  // waits for the picture
  Decisions& decisions = state_.decisions;
  if (!wanted.save_to.empty()) {
    save_to(wanted.save_to);
  } else if (decisions.leaving && !decisions.question.open() && !state_.browser.open) {
    decisions.leaving.reset();  // the user did not choose where to save
  }
  if (wanted.leaves_work() && !decisions.question.open()) {
    cancel_stroke(state_.hand, state_.work.document);
    if (may_leave(decisions, state_.work, state_.view.look.lights, wanted)) leave(wanted);
  }
  if (!wanted.save_path_to.empty()) save_path_to(wanted.save_path_to);
  opener_.take_loaded();
  if (!state_.opening.loader.busy()) change_world(wanted);  // otherwise what is open is about to go
}

void RequestDesk::decide() {
  switch (take_decision(state_.decisions, state_.opening.left_work)) {
    case Decision::kNone:
      break;
    case Decision::kLeave:
      leave(*std::exchange(state_.decisions.leaving, {}));
      break;
    case Decision::kSaveFirst:
      if (state_.work.file.empty()) {
        choose_file_for(state_, FileBrowser::Purpose::kSave);
      } else {
        state_.requests.save_to = state_.work.file;
      }
      break;
    case Decision::kGoOn:
      opener_.open_left_work();
      break;
  }
}

void RequestDesk::save_to(const std::filesystem::path& file) {
  cancel_stroke(state_.hand, state_.work.document);
  const bool saved = save_work(state_.work, state_.view, file, state_.settings, state_.message);
  recovery_.begin(state_.work, state_.view);
  std::optional<Requests>& leaving = state_.decisions.leaving;
  if (saved && leaving) leave(*std::exchange(leaving, {}));
}

// The open work is saved, or is to be discarded.
void RequestDesk::leave(const Requests& wanted) {
  state_.opening.loader.cancel();
  if (!wanted.quit) return opener_.open(wanted);
  quit_ = true;
  state_.work.saved_commands = state_.work.document.journal().size();
  state_.work.saved_lights = state_.view.look.lights;
}

// Takes the path files out of those that are to be opened, and loads them.
void RequestDesk::load_paths(std::vector<std::filesystem::path>& files) {
  const auto first = std::stable_partition(files.begin(), files.end(),
                                           [](const std::filesystem::path& f) { return !is_path_file(f); });
  for (auto file = first; file != files.end(); ++file) {
    if (const std::string why = load_path(state_, *file); !why.empty()) state_.message.say(why, true);
  }
  files.erase(first, files.end());
}

void RequestDesk::save_path_to(const std::filesystem::path& file) {
  PathWork& path = state_.lasers.path;
  const Status saved = save_path(file, path.strokes());
  if (saved) path.note_saved(file);
  state_.message.say(saved ? "Saved: " + file.string() : saved.error().message, !saved.ok());
}

void RequestDesk::run_path() {
  PathWork& path = state_.lasers.path;
  if (const auto why = why_no_cut(path.strokes())) return state_.message.say(*why, true);
  cancel_stroke(state_.hand, state_.work.document);
  const Document& document = state_.work.document;
  const size_t from = document.history().position();
  path.note_run(from);
  std::function<Resolution(double)> resolution;
  if (state_.lasers.at_panel_resolution)
    resolution = [controls = state_.hand.laser.resolution](double radius) { return controls.of(radius); };
  changes_.run_path(path_commands(path.strokes(), document.world().bounds().diagonal(), resolution),
                    [this, &document, from] {
                      run_ = Run{from, document.history().position(), document.journal().size()};
                    });
  state_.hand.cut_once = true;
}

// A step back from the end of the run goes to where it began, and a step forth from there to its end.
void RequestDesk::step_through_history(bool back) {
  const Document& document = state_.work.document;
  const size_t position = document.history().position();
  const bool alone = run_ && document.journal().size() == run_->commands;
  if (!alone || position != (back ? run_->to : run_->from)) return changes_.step_through_history(back);
  run_->commands += run_->to - run_->from;
  changes_.travel_to(back ? run_->from : run_->to,
                     back ? "Undone: the run of the path" : "Done again: the run of the path");
}

void RequestDesk::change_world(const Requests& wanted) {
  if (wanted.undo || wanted.redo) step_through_history(wanted.undo);
  if (wanted.travel && !changes_.is_pending()) changes_.travel_to(*wanted.travel);
  for (const Command& command : wanted.commands) {
    if (changes_.is_pending()) break;
    changes_.apply(command);
  }
  if (wanted.run_path && !changes_.is_pending()) run_path();
  if (wanted.hide_chosen) state_.requests.hide_chosen = changes_.hide_chosen();
  if (wanted.delete_chosen) state_.requests.delete_chosen = changes_.delete_chosen();
  if (wanted.pin_chosen && !changes_.is_pending()) changes_.pin_chosen(*wanted.pin_chosen);
  if (wanted.duplicate_chosen && !changes_.is_pending()) changes_.duplicate_chosen();
  if (wanted.show_hidden && !changes_.is_pending()) changes_.show_hidden();
  if (wanted.isolate && !changes_.is_pending()) changes_.isolate_chosen();
  const bool recut = wanted.recut || wanted.recut_radius;
  if (recut && !changes_.is_pending()) changes_.recut_last_stroke(wanted.recut_radius);
}

}  // namespace kerf
