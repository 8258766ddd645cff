#include "ui/editor/files/recovery.h"

#include "ui/editor/files/save_work.h"

namespace kerf {

namespace {
constexpr std::chrono::seconds kBetweenTries{1};
}  // namespace

void Recovery::begin(const OpenWork& work, const ViewState& view) {
  lights_ = view.look.lights;
  head_ = work.scene.others;
  autosave_.begin(scene_now(work, view), work.file, work.files);
}

bool Recovery::follow(OpenWork& work, const ViewState& view, bool mouse_moves, Message& message) {
  if (!is_to_be_kept(work, view.look.lights)) {
    if (autosave_.keeps()) autosave_.drop();
    return true;
  }
  if (!well_ && Clock::now() < failed_at_ + kBetweenTries) return false;
  mark_state(work.document, work.marks);
  const bool changed = view.look.lights != lights_ || work.scene.others != head_;
  if (!mouse_moves && changed) begin(work, view);
  const Status kept = autosave_.follow(work.document, work.marks);
  if (!kept && well_) message.say("What is not saved cannot be kept: " + kept.error().message, true);
  if (!kept) failed_at_ = Clock::now();
  well_ = kept.ok();
  return well_;
}

}  // namespace kerf
