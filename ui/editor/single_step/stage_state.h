#pragma once

#include "core/document/history/document.h"
#include "ui/editor/single_step/stage_log.h"
#include "ui/editor/single_step/stage_wishes.h"

namespace kerf {

// Single steps of the last stroke in the editor; StageCut executes them.
struct StageState {
  StageWishes wishes;
  StageLog log;
};

// Plays the stages or pauses; at the end of the stroke, and while single steps are off, it begins again.
void play_or_pause(StageState& stages, const Document& document);

// Why the last stroke cannot be stepped through again, why there is no next stage, and why the last one
// cannot be taken back; one sentence each, or null where it can be done.
const char* why_not_again(const Document& document);
const char* why_no_next_stage(const StageState& stages, const Document& document);
const char* why_no_stage_back(const StageState& stages, const Document& document);

}  // namespace kerf
