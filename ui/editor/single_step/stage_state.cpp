#include "ui/editor/single_step/stage_state.h"

namespace kerf {

namespace {

constexpr const char* kOff = "Single steps are off.";

}  // namespace

void play_or_pause(StageState& stages, const Document& document) {
  StageWishes& wishes = stages.wishes;
  const bool play = !wishes.playing;
  if (play && why_no_next_stage(stages, document) != nullptr) {
    wishes.begin_again();
  } else {
    wishes.stop();
  }
  wishes.playing = play;
}

const char* why_not_again(const Document& document) {
  if (!document.history().last_cut()) return "Nothing is cut yet.";
  if (*document.history().last_cut() + 1 != document.history().position())
    return "Something was done after the last stroke: undo that first.";
  return document.can_start_again() ? nullptr : "What was before the last stroke is no longer remembered.";
}

const char* why_no_next_stage(const StageState& stages, const Document& document) {
  if (!stages.wishes.on) return kOff;
  if (document.waiting() > 0 && stages.runs_on)
    return "This stroke is cut to its end: what was before it is no longer remembered.";
  return document.waiting() > 0 ? nullptr : "The stroke is cut. Go back, start again, or draw another one.";
}

const char* why_no_stage_back(const StageState& stages, const Document& document) {
  if (!stages.wishes.on) return kOff;
  return stages.log.done() > 0 ? why_not_again(document) : "No stage was executed yet.";
}

}  // namespace kerf
