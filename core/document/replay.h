#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"
#include "core/document/journal.h"

namespace kerf {

// Commands of a journal that only let bodies move, and the mark that says where this brought them: whoever
// replays the journal may put them there, and comes to the same.
struct TimeSkip {
  size_t first = 0;  // the first of these commands
  size_t mark = 0;   // index in Journal::marks
  Ticks ticks = 0;   // that pass until then
};

// The runs of at least `least` ticks that can be skipped, in their order. A run begins with Play, or where
// the stroke before it ends, and ends at the last mark in it from which bodies go on to the bit: where the
// step of the history is over, or at a full minute (see Execution::kTicksToForget).
std::vector<TimeSkip> time_skips(const Journal& journal, Ticks least);

// Applies the commands of a journal to a document that holds the journal's scene, and compares the state of
// the world with the marks of the journal on the way. The journal and the document must outlive the replay.
class Replay {
 public:
  // With `skips`: bodies are put where marks say that time brought them.
  Replay(const Journal& journal, Document& document, std::vector<TimeSkip> skips = {})
      : journal_(journal), document_(document), skips_(std::move(skips)) {
    compare();
  }

  bool done() const { return next_ == journal_.commands.size() && document_.waiting() == 0; }
  // The number of commands applied so far. What `told` hears of is what the last of these did.
  size_t applied() const { return next_; }
  // How much of the journal is applied, 0 to 1.
  double fraction() const;

  // Applies the next command, executes what it queued (see run_queue) and calls `told` after each step. A
  // change that the command made at once is reported to `told` as a step, too. A command or step that fails
  // does not end the replay if `told` returns success, because it failed when the journal was recorded as
  // well. Precondition: !done().
  Status next(const QueueRun& how);
  // Replays the rest of the journal. Fails like run_queue(), or if `progress`, which receives fraction(),
  // stops it.
  Status run(const QueueRun& how);

  // The first mark whose hash differs from that of the world, unless bodies moved on another kind of machine
  // before, and the hash that the world had there.
  struct Difference {
    StateMark mark;
    uint64_t hash = 0;
  };
  const std::optional<Difference>& difference() const { return difference_; }

  // The kind of machine on which bodies came elsewhere than here, so that their states were taken from a mark
  // of it; empty if there was none. This is no difference.
  const std::string& other_machine() const { return other_machine_; }
  // Whether, because of that, a stroke that was drawn while bodies moved has cut otherwise here.
  bool cut_otherwise() const { return cut_otherwise_; }

  // The ticks that were skipped.
  Ticks skipped() const { return skipped_; }

 private:
  // Whether the command with this number is of this kind; false if there is none.
  template <typename Kind>
  bool is_a(size_t command) const {
    return command < journal_.commands.size() && std::holds_alternative<Kind>(journal_.commands[command]);
  }
  size_t end_of_stopped() const;
  size_t end_of_undone() const;
  Status tell(const QueueRun& how, Outcome at_once) const;
  Status skip(const QueueRun& how, const TimeSkip& skip);
  void compare();
  bool takes_bodies(const StateMark& mark);

  const Journal& journal_;
  Document& document_;
  size_t next_ = 0, next_mark_ = 0;
  std::optional<Difference> difference_;
  std::string other_machine_;
  bool cut_otherwise_ = false;
  std::vector<TimeSkip> skips_;  // ascending
  size_t next_skip_ = 0;
  Ticks skipped_ = 0;
};

}  // namespace kerf
