#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "core/document/history/document.h"
#include "ui/editor/single_step/stage_log.h"

namespace kerf {

// What the user asks for in single steps.
struct StageWishes {
  static constexpr double kSlowest = 0.5, kFastest = 60;
  static constexpr size_t kAll = std::numeric_limits<size_t>::max();

  bool on = false;              // the last stroke is executed in single steps
  double per_second = 4;        // stages, while playing
  bool playing = false;         // stages are executed one after the other
  bool start_again = false;     // the last stroke is taken back, to be executed again
  bool to_end_of_move = false;  // stages are executed until a move of the beam is finished
  std::optional<size_t> stage;  // the number of stages of the stroke that are to be executed; kAll: all

  void stop() {
    playing = to_end_of_move = false;
    stage.reset();
  }
  void go_to(size_t stages) {
    stop();
    stage = stages;
  }
  void run_to_end_of_move() {
    stop();
    to_end_of_move = true;
  }
  void begin_again() {
    stop();
    on = start_again = true;
  }
};

// Single steps of the last stroke in the editor; StageCut executes them.
struct StageState {
  StageWishes wishes;
  StageLog log;
  bool runs_on = false;  // a part of the last stroke was cut without stages, and cannot be taken back
};

// Plays the stages or pauses; at the end of the stroke, and while single steps are off, it begins again.
void play_or_pause(StageState& stages, const Document& document);

// Why the last stroke cannot be stepped through again, why there is no next stage, and why the last one
// cannot be taken back; one sentence each, or null where it can be done.
const char* why_not_again(const Document& document);
const char* why_no_next_stage(const StageState& stages, const Document& document);
const char* why_no_stage_back(const StageState& stages, const Document& document);

}  // namespace kerf
