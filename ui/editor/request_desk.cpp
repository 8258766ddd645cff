#include "ui/editor/request_desk.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/document/edit_path.h"
#include "core/document/save.h"
#include "core/document/stroke_settings.h"
#include "ui/editor/changes/prepare_pieces.h"
#include "ui/editor/file_choice.h"
#include "ui/editor/laser_desk.h"
#include "ui/editor/view/piece_set.h"
#include "ui/editor/work/save_work.h"

namespace kerf {

void RequestDesk::fulfil() {
  groups_.follow(state_.work.document);
  decide();
  Requests wanted = std::exchange(state_.requests, {});
  load_paths(wanted.open);
  state_.requests.screenshot = wanted.screenshot;  // waits for the picture
  state_.requests.play = wanted.play;              // waits for the end of the frame
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
  take_loaded();
  if (!state_.opening.loader.busy()) change_world(wanted);  // otherwise what is open is about to go
}

void RequestDesk::take_loaded() {
  if (!state_.opening.loader.busy()) return;
  opener_.take_loaded();
  if (!state_.opening.loader.busy()) groups_ = StepGroups();
}

void RequestDesk::decide() {
  switch (take_decision(state_.decisions, state_.opening.left_work)) {
    case Decision::kNone:
      break;
    case Decision::kLeave:
      KERF_ASSERT(state_.decisions.leaving);
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
  if (!wanted.quit) {
    opener_.open(wanted);
    groups_ = StepGroups();
    return;
  }
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
  path.note_run(document.history().position());
  std::function<Resolution(double)> resolution;
  if (state_.lasers.at_panel_resolution)
    resolution = [controls = state_.hand.laser.resolution](double radius) { return controls.of(radius); };
  begin_group("Run of the path");
  changes_.run_path(path_commands(path.strokes(), document.world().bounds().diagonal(), resolution));
  state_.hand.cut_once = true;
}

void RequestDesk::begin_group(const char* name) {
  if (!open_group_) open_group_ = {state_.work.document.history().position(), name};
}

// Not before all of the group is done.
void RequestDesk::end_group() {
  if (!open_group_ || changes_.is_pending() || state_.requests.hide_chosen || state_.requests.delete_chosen)
    return;
  groups_.add(open_group_->from, state_.work.document, open_group_->name);
  open_group_.reset();
}

void RequestDesk::step_through_history(bool back) {
  groups_.follow(state_.work.document);
  const StepGroups::Group* group = groups_.at(state_.work.document, back);
  if (group == nullptr) return changes_.step_through_history(back);
  cancel_stroke(state_.hand, state_.work.document);
  changes_.travel_to(back ? group->from : group->to, (back ? "Undone: " : "Done again: ") + group->name);
}

void RequestDesk::change_world(const Requests& wanted) {
  if (wanted.stop) changes_.stop_cutting();
  if (wanted.undo || wanted.redo) step_through_history(wanted.undo);
  if (wanted.travel && !changes_.is_pending()) changes_.travel_to(*wanted.travel);
  for (const Command& command : wanted.commands) {
    if (changes_.is_pending()) break;
    changes_.apply(command);
  }
  if (wanted.run_path && !changes_.is_pending()) run_path();
  change_pieces(wanted);
  const bool recut = wanted.recut || wanted.recut_radius;
  if (recut && !changes_.is_pending()) changes_.recut_last_stroke(wanted.recut_radius);
  end_group();
}

void RequestDesk::change_pieces(const Requests& wanted) {
  if (wanted.hide_chosen) {
    begin_group("Hide pieces");
    state_.requests.hide_chosen = changes_.hide_chosen();
  }
  if (wanted.delete_chosen) {
    begin_group("Delete pieces");
    state_.requests.delete_chosen = changes_.delete_chosen();
  }
  if (wanted.pin_chosen && !changes_.is_pending()) {
    begin_group(*wanted.pin_chosen ? "Pin pieces" : "Unpin pieces");
    changes_.pin_chosen(*wanted.pin_chosen);
  }
  if (wanted.sheet && !changes_.is_pending()) {
    begin_group("Set the material");
    changes_.set_sheet(*wanted.sheet);
  }
  if (wanted.preparation && !changes_.is_pending()) {
    begin_group(preparation_title(wanted.preparation->tool));
    changes_.prepare_chosen(*wanted.preparation);
  }
  // A piece that was hidden in the same frame is not chosen any more.
  if (wanted.duplicate_chosen && !changes_.is_pending() && chosen_pieces(state_.view.look.pieces) > 0)
    changes_.duplicate_chosen();
  if (wanted.show_hidden && !changes_.is_pending()) {
    begin_group("Show all pieces");
    changes_.show_hidden();
  }
  if (wanted.isolate && !changes_.is_pending()) {
    begin_group("Isolate pieces");
    changes_.isolate_chosen();
  }
}

}  // namespace kerf
