#include "ui/editor/work/work_keeper.h"

#include "ui/editor/work/save_work.h"

namespace kerf {

namespace {
constexpr std::chrono::seconds kBetweenTries{1};
}  // namespace

void WorkKeeper::begin(const EditorState& state) {
  lights_ = state.look.lights;
  autosave_.begin(scene_now(state), state.work.file);
}

bool WorkKeeper::follow(EditorState& state) {
  if (!is_unsaved(state)) {
    if (autosave_.keeps()) autosave_.drop();
    return true;
  }
  if (!well_ && Clock::now() < failed_at_ + kBetweenTries) return false;
  mark_state(state.document, state.work.marks);
  if (state.drag != Drag::kLight && state.look.lights != lights_) begin(state);
  const Status kept = autosave_.follow(state.document, state.work.marks);
  if (!kept && well_) state.say("What is not saved cannot be kept: " + kept.error().message, true);
  if (!kept) failed_at_ = Clock::now();
  well_ = kept.ok();
  return well_;
}

}  // namespace kerf
