#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "core/document/document.h"
#include "core/document/single_step.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/single_step/stage_log.h"

namespace kerf {

// Requests of the user in single steps.
struct StageRequests {
  static constexpr double kSlowest = 0.5, kFastest = 60;
  static constexpr size_t kAll = std::numeric_limits<size_t>::max();

  bool on = false;              // single steps are enabled
  double per_second = 4;        // speed of playback [stages/s]
  bool playing = false;         // stages are executed one after the other
  bool start_again = false;     // undo the last stroke and execute it again
  bool to_end_of_move = false;  // execute the remaining stages of the segment
  std::optional<size_t> stage;  // target number of executed stages; kAll: all

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
  void start_over() {
    stop();
    on = start_again = true;
  }
};

// State of single steps; StageCut executes them.
struct StageState {
  StageRequests requests;
  StageLog log;
  bool runs_on = false;  // a part of the last stroke was cut without stages and cannot be undone
};

// Plays or pauses the stages; restarts at the end of the stroke and while single steps are off.
void play_or_pause(StageState& stages, const Document& document);

// Return why the last stroke cannot be stepped through again, why there is no next stage, and why the last
// stage cannot be undone; a sentence, or null if it is possible.
const char* restart_disabled_reason(const Document& document);
const char* next_stage_disabled_reason(const StageState& stages, const Document& document);
const char* stage_back_disabled_reason(const StageState& stages, const Document& document);

// Executes the last stroke of the open document in single steps, forward and backward. Leaves earlier
// strokes with queued moves to WorldChanges::cut.
class StageCut {
 public:
  // Both must outlive it.
  StageCut(Workspace& workspace, StageState& stages) : workspace_(workspace), stages_(stages) {}

  // Executes requested stages, at most for a part of a frame; `seconds` since the last frame. Going back in
  // a long stroke becomes a pending change.
  void advance(double seconds);
  // Restarts the log if it does not belong to the last stroke. Call before the user requests more stages.
  void follow();
  // Returns true if the next step of the document waits for the user.
  bool holds_back() const;
  // Returns true if the last stroke and its requests wait for earlier strokes, which are cut without stages.
  bool waits_for_earlier() const;
  // Returns true if more stages are requested.
  bool needs_more() const;
  // Returns true if the next frames have to execute more.
  bool waits() const;

 private:
  // Identifies the stroke and queue that the log belongs to.
  struct Key {
    size_t revision = 0, position = 0, forgotten = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  Key key_now() const;
  void begin();
  void go_back(size_t stages);
  bool needs_step_back() const;
  bool can_continue() const;
  void advance();
  void drop_fulfilled();
  bool next();
  void note(const StageRecord& stage);
  void show();

  Workspace& workspace_;
  StageState& stages_;
  std::optional<SingleStep> single_;
  std::optional<Key> key_;
  bool stepped_back_ = false;   // since the last frame
  bool from_its_start_ = true;  // the last stroke is in single steps from its start
  double spent_ = 0;            // on the executed stages [s]
  double due_ = 0;              // stages due while playing
};

// Panel of single steps: the switch, the buttons for the stages, and a description of each stage.
class SingleStepPanel {
 public:
  void draw(StageState& stages, const Document& document, const ViewState& view);

 private:
  void draw_list(StageState& stages, const Document& document);

  size_t shown_ = 0;  // stage that the list was last scrolled to
};

}  // namespace kerf
