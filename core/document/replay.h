#pragma once

#include <optional>

#include "core/document/journal.h"
#include "core/document/walk.h"

namespace kerf {

// Applies the commands of a journal to a document that holds its scene, and compares the world with the marks
// on the way. Both must outlive it.
class Replay {
 public:
  Replay(const Journal& journal, Document& document) : journal_(journal), document_(document) { compare(); }

  bool done() const { return next_ == journal_.commands.size() && document_.waiting() == 0; }
  // How much of the journal is applied, 0 to 1.
  double fraction() const;

  // Applies the next command, walks what it queued (see walk), and has `told` hear of each step; of what the
  // command did at once as of a step too. Where `told` goes on after a failure, so did the work that is
  // replayed. Precondition: !done().
  Status next(const Walk& how);
  // All that is left. Fails as walk does, and where `progress`, which is told the fraction, stops it.
  Status run(const Walk& how);

  // The first mark that the world did not come up to, and the hash that it had there instead.
  struct Difference {
    StateMark mark;
    uint64_t hash = 0;
  };
  const std::optional<Difference>& difference() const { return difference_; }

 private:
  Status tell(const Walk& how, Outcome at_once) const;
  void compare();

  const Journal& journal_;
  Document& document_;
  size_t next_ = 0, next_mark_ = 0;
  std::optional<Difference> difference_;
};

}  // namespace kerf
