#pragma once

#include <optional>

#include "core/document/history/single_step.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/single_step/stage_state.h"

namespace kerf {

// Executes the last stroke of the open document in single steps, forth and back, while the user wants it.
// Earlier strokes of which moves wait are left to WorldChanges::cut.
class StageCut {
 public:
  // Both must outlive it.
  StageCut(Workspace& on, StageState& stages) : on_(on), stages_(stages) {}

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

  Workspace& on_;
  StageState& stages_;
  std::optional<SingleStep> single_;
  std::optional<Key> key_;
  bool went_back_ = false;      // since the last frame
  bool from_its_start_ = true;  // the last stroke is executed in single steps from its start on
  double spent_ = 0;            // s, on the stages that were executed
  double due_ = 0;              // stages, while playing
};

}  // namespace kerf
