#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>

#include "core/base/tick.h"
#include "core/document/stroke.h"
#include "core/world/world.h"

namespace kerf {

// What waits to be walked in a document, in its order: moves of the beam, ends of strokes with a smooth rim,
// and ticks, each of a step of the history. Moves are queued whole and subdivided when they are begun, for
// how finely depends on how far from the beam the bodies stand then.
class BeamQueue {
 public:
  enum class Kind { kMove, kRim, kTicks };

  bool empty() const { return ready_.empty() && entries_.empty(); }
  // How many moves, ends of strokes and ticks wait. A move counts as many times as it would be subdivided
  // where the bodies stood when it was queued; once it is begun, the count is exact.
  size_t size() const { return size_; }
  // Whether anything waits but ticks.
  bool holds_beam() const { return size_ > ticks_; }
  // Whether anything waits of a step of the history.
  bool holds(size_t step) const;

  void push_move(size_t step, std::shared_ptr<Stroke> stroke, const BeamMove& move, const World& world);
  void push_rim(size_t step, std::shared_ptr<Stroke> stroke);
  void push_ticks(size_t step, Ticks ticks);
  // Ticks that pass before all that waits.
  void push_ticks_in_front(size_t step, Ticks ticks);

  // What comes first. Precondition: !empty().
  size_t front_step() const;
  Kind front_kind() const { return ready_.empty() ? entries_.front().kind : Kind::kMove; }
  const std::shared_ptr<Stroke>& front_stroke() const;
  Ticks front_ticks() const;  // of a front of that kind

  // The move that the next step begins with, or goes on with; none where it is no move.
  std::optional<BeamMove> next_move(const World& world) const;

  // Begins moves of the step in front: subdivides them, which adds them to the path of their stroke, and
  // returns up to `most` of them, one or more. Precondition: the front is a move, most > 0.
  std::vector<BeamMove> begin_moves(const World& world, size_t most);
  // Where the first move was left by the last step.
  UnfinishedMove& unfinished() { return unfinished_; }

  // What was begun came to its end.
  void pop_moves(size_t count);
  void pop_rim();
  void pop_ticks(Ticks count);

  // What waits of a step of the history is not to be walked: all of it, or all but ticks.
  void drop(size_t step);
  void drop_strokes(size_t step);
  void clear() { *this = BeamQueue(); }

 private:
  struct Entry {
    size_t step = 0;
    Kind kind = Kind::kMove;
    std::shared_ptr<Stroke> stroke;  // null: ticks
    BeamMove move;                   // of a move, not subdivided
    size_t count = 1;                // how many of size() it is; of ticks: how many
  };
  void push(Entry entry);
  template <typename Drops>
  void drop_if(size_t step, Drops drops);

  std::deque<BeamMove> ready_;  // moves that were begun, of one stroke; the first may be unfinished
  size_t ready_step_ = 0;
  std::shared_ptr<Stroke> ready_stroke_;
  UnfinishedMove unfinished_;
  std::deque<Entry> entries_;  // behind them, by ascending step
  size_t size_ = 0;
  size_t ticks_ = 0;  // among those
};

}  // namespace kerf
