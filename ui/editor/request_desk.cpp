#include "ui/editor/request_desk.h"

#include "ui/editor/file_choice.h"
#include "ui/editor/work/save_work.h"

namespace kerf {

void RequestDesk::fulfil() {
  decide();
  const Requests wanted = std::exchange(state_.requests, {});
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

void RequestDesk::change_world(const Requests& wanted) {
  if (wanted.undo || wanted.redo) changes_.step_through_history(wanted.undo);
  if (wanted.travel && !changes_.is_pending()) changes_.travel_to(*wanted.travel);
  for (const Command& command : wanted.commands) {
    if (changes_.is_pending()) break;
    changes_.apply(command);
  }
  if (wanted.hide_chosen) state_.requests.hide_chosen = changes_.hide_chosen();
  if (wanted.delete_chosen) state_.requests.delete_chosen = changes_.delete_chosen();
  if (wanted.duplicate_chosen && !changes_.is_pending()) changes_.duplicate_chosen();
  if (wanted.show_hidden && !changes_.is_pending()) changes_.show_hidden();
  if (wanted.isolate && !changes_.is_pending()) changes_.isolate_chosen();
  const bool recut = wanted.recut || wanted.recut_radius;
  if (recut && !changes_.is_pending()) changes_.recut_last_stroke(wanted.recut_radius);
}

}  // namespace kerf
