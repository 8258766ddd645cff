#pragma once

#include <optional>

#include "core/document/document.h"
#include "core/document/journal.h"

namespace kerf {

// Lets the commands of a journal happen to a document that holds its scene, one after the other, and holds
// the world against the marks on the way. Both must outlive it.
class Replay {
 public:
  Replay(const Journal& journal, Document& document) : journal_(journal), document_(document) { compare(); }

  bool done() const { return next_ == journal_.commands.size() && document_.waiting() == 0; }
  // Of the commands, 0 to 1.
  double fraction() const;

  // Gives the next command to the document; nothing must wait there. What it changed at once.
  Result<Delta> next_command(const Progress* progress = nullptr);
  // Walks up to so many moves that wait, as Document::step. After a failure the replay can go on with the
  // next command, as the work that is replayed did.
  Result<StepResult> step(size_t moves, const Progress* progress = nullptr);

  // The next command where nothing waits, then moves as above, in one delta: called until done(), it replays
  // all.
  Result<StepResult> advance(size_t moves, const Progress* progress = nullptr);

  // The first mark that the world did not come up to, and the hash that it had there instead.
  struct Difference {
    StateMark mark;
    uint64_t hash = 0;
  };
  const std::optional<Difference>& difference() const { return difference_; }
  // Whether the command that was given last begins a stroke.
  bool begins_stroke() const {
    return next_ > 0 && std::holds_alternative<BeginStroke>(journal_.commands[next_ - 1]);
  }

 private:
  void compare();

  const Journal& journal_;
  Document& document_;
  size_t next_ = 0, next_mark_ = 0;
  std::optional<Difference> difference_;
};

}  // namespace kerf
