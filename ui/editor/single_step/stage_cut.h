#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "core/document/document.h"
#include "core/document/single_step.h"
#include "ui/editor/shared/workspace.h"
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

// Executes the last stroke of the open document in single steps, forth and back, while the user wants it.
// Earlier strokes of which moves wait are left to WorldChanges::cut.
class StageCut {
 public:
  // Both must outlive it.
  StageCut(Workspace& workspace, StageState& stages) : workspace_(workspace), stages_(stages) {}

  // Executes what the user asked for, at most for a part of a frame; `seconds` have passed since the last
  // frame. Going back in a long stroke becomes a pending change.
  void advance(double seconds);
  // Finds out whether the stages in the log are those of the last stroke, and begins anew where they are not.
  // To be called before the user asks for more of them.
  void follow();
  // Whether the next step of the document waits for the user.
  bool holds_back() const;
  // Whether the last stroke waits for earlier ones, which are cut without stages. What the user asks for
  // waits, too.
  bool waits_for_earlier() const;
  // Whether more stages are to be executed.
  bool wants_more() const;
  // Whether more is to be executed in the next frames.
  bool waits() const;

 private:
  // What the stages in the log belong to.
  struct Key {
    size_t revision = 0, position = 0, forgotten = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  Key key_now() const;
  void begin();
  void go_back(size_t stages);
  bool must_go_back() const;
  bool can_go_on() const;
  void go_on();
  void drop_fulfilled();
  bool next();
  void note(const StageRecord& stage);
  void show();

  Workspace& workspace_;
  StageState& stages_;
  std::optional<SingleStep> single_;
  std::optional<Key> key_;
  bool went_back_ = false;      // since the last frame
  bool from_its_start_ = true;  // the last stroke is executed in single steps from its start on
  double spent_ = 0;            // s, on the stages that were executed
  double due_ = 0;              // stages, while playing
};

}  // namespace kerf
