#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/tick.h"
#include "core/cut/cut_step.h"
#include "core/document/commands.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// A stroke while it is cut: its settings, the end of its queued moves, and the path that the beam has swept.
struct Stroke {
  CutSettings settings;
  BeamAt beam;                 // the pose and time at the end of the last queued move
  bool ended = false;          // its end is queued
  bool given_up = false;       // a part of it failed: what is still drawn of it is not executed
  size_t queued = 0;           // moves that were queued
  std::vector<BeamMove> path;  // the moves that were begun; moves that rotate the beam are subdivided
  // For each body that has moved since the stroke began, all that the beam has swept, in the frame of the
  // body: moves of the beam and moves of the body under it. Bodies that are not listed have stood still.
  SweptByBody swept;

  // Lists what was appended to the path since the last call for the bodies that have moved. To be called
  // before a body moves again. O(appended moves * listed bodies).
  void list_path(const World& world);

  // Shortens the path by this many moves, and appends one to it if it is given: the moves were begun, but the
  // stroke was stopped before them. Precondition: list_path() was called since they were begun, and no body
  // has moved since.
  void cut_back(const World& world, size_t moves, const std::optional<BeamMove>& instead);

  // Pieces that were detached have been swept like the body that they were detached from.
  void inherit(std::span<const Detached> detached);

  // A body has moved from one placement to another while the beam stood still at a pose. Returns the moves of
  // the beam in the frame of the body, subdivided, without those that cannot meet the body, and lists them.
  // Precondition: list_path() was called. Only for a body that moved for the first time is the cost
  // proportional to the path.
  std::vector<BeamMove> move_body(BodyId id, const Body& body, const Placement& from, const Pose& beam);

 private:
  size_t listed_ = 0;  // moves of the path that swept has
};

// The work of a document that has not been executed yet, in order: moves of the beam, ends of strokes with a
// smooth rim, ticks, and changes of the spring. Each entry belongs to a step of the history. Moves are stored
// whole and subdivided when they are begun, because the subdivision depends on where the bodies are at that
// moment.
class BeamQueue {
 public:
  enum class Kind { kMove, kRim, kTicks, kSpring };
  struct Entry {
    size_t step = 0;
    Kind kind = Kind::kMove;
    std::shared_ptr<Stroke> stroke = {};  // of kMove and kRim; of kTicks under a beam
    BeamMove move = {};                   // of a move, not subdivided; of ticks, where the beam is
    size_t number = 0;                    // of a move: that of the moves of its stroke before it
    size_t count = 1;                     // its share of size(); the number of ticks
    bool bodies = false;                  // of ticks: bodies move
    std::optional<Spring> spring = {};    // of kSpring
    double share = 1;                     // of a move, > 0: the part of it that is executed
    bool in_time() const { return kind == Kind::kTicks || kind == Kind::kSpring; }
  };

  bool empty() const { return ready_.empty() && entries_.empty(); }
  // The number of moves, ends of strokes, ticks and changes of the spring. A move counts as the number of
  // parts into which it would have been subdivided when it was appended; once it is begun, the count is
  // exact.
  size_t size() const { return size_; }
  // Whether the queue holds moves or ends of strokes.
  bool holds_beam() const { return size_ > in_time_; }
  bool holds_moves() const { return !ready_.empty() || rims_ + in_time_ < size_; }
  // Whether it is not empty, and holds only ticks in which bodies stand still.
  bool only_cools() const;
  // Whether the queue holds anything of a step of the history.
  bool holds(size_t step) const;

  void push_move(size_t step, std::shared_ptr<Stroke> stroke, const BeamMove& move, const World& world);
  void push_rim(size_t step, std::shared_ptr<Stroke> stroke);
  // `bodies`: bodies move in these ticks, under the beam of `stroke` at the end of its moves so far, or under
  // none if it is null.
  void push_ticks(size_t step, Ticks ticks, bool bodies, std::shared_ptr<Stroke> stroke);
  void push_spring(size_t step, const std::optional<Spring>& spring);
  // Appends ticks without a beam, or a change of the spring, before everything else. Precondition: no move
  // and no end of a stroke is unfinished.
  void push_ticks_in_front(size_t step, Ticks ticks, bool bodies);
  void push_spring_in_front(size_t step, const std::optional<Spring>& spring);

  // The front of the queue. Precondition of these: !empty().
  size_t front_step() const;
  Kind front_kind() const { return ready_.empty() ? entries_.front().kind : Kind::kMove; }
  const std::shared_ptr<Stroke>& front_stroke() const;
  // Precondition: front_kind() is kTicks or kSpring.
  const Entry& front_in_time() const;

  // The move that the next step begins or continues, or nothing if the front is no move.
  std::optional<BeamMove> next_move(const World& world) const;

  // Begins moves at the front: subdivides them, appends the parts to the path of their stroke, and returns
  // between 1 and `most` parts. Preconditions: the front is a move, most > 0.
  std::vector<BeamMove> begin_moves(const World& world, size_t most);
  // How far the last step executed the first move.
  UnfinishedMove& unfinished() { return unfinished_; }
  const UnfinishedMove& unfinished() const { return unfinished_; }
  // How far the last step executed the end of a stroke at the front.
  UnfinishedRim& unfinished_rim() { return unfinished_rim_; }
  const UnfinishedRim& unfinished_rim() const { return unfinished_rim_; }

  // How far the beam of the stroke of a step of the history has been executed, counted as StopStroke does. A
  // part of a move that is unfinished counts as executed.
  StopStroke reached(size_t step) const;
  // Whether moves of the stroke wait behind that.
  bool holds_moves(size_t step) const;
  // Switches the beam of a stroke off at a place: drops its moves from there on, and lets its ticks pass
  // without a beam. The first move is kept. Precondition: the place is not before reached(step).
  void stop(size_t step, StopStroke at, const World& world);

  // Remove what has been executed from the front.
  void pop_moves(size_t count);
  // The front is no move; of ticks, some may be left.
  void pop(size_t count = 1);

  // Remove the entries of a step of the history: all of them, or all of its strokes, so that its ticks pass
  // without a beam.
  void drop(size_t step);
  void drop_strokes(size_t step);
  void clear() { *this = BeamQueue(); }

 private:
  // A move that was begun, and a part of it.
  struct Begun {
    BeamMove move;
    size_t number = 0;   // see Entry
    size_t parts = 1;    // into which it was subdivided
    size_t in_path = 1;  // moves of the path of its stroke that it became
  };
  struct Part {
    BeamMove move;
    std::shared_ptr<const Begun> of;
    size_t number = 0;     // of the parts before it
    double begin() const;  // as StopStroke::moves
    double end() const;
  };
  void push(Entry entry);
  void push_in_front(Entry entry);
  template <typename Drops>
  void drop_if(size_t step, Drops drops);

  void begin_move(const Entry& entry, std::span<const BeamMove> parts);
  void stop_begun(const StopStroke& at, const World& world);
  bool stop_move(Entry& move, double moves, std::deque<Entry>& kept);
  static void stop_ticks(Entry ticks, Ticks on, std::deque<Entry>& kept);

  std::deque<Part> ready_;  // of begun moves, all of one stroke; the first may be unfinished
  size_t ready_step_ = 0;
  StopStroke reached_;  // by the stroke of this step of the history
  size_t reached_step_ = 0;
  std::shared_ptr<Stroke> ready_stroke_;
  UnfinishedMove unfinished_;
  UnfinishedRim unfinished_rim_;
  std::deque<Entry> entries_;  // after those, in the order of steps
  size_t size_ = 0;
  size_t in_time_ = 0;  // of these, ticks and changes of the spring
  size_t rims_ = 0;     // of these, ends of strokes with a smooth rim
};

}  // namespace kerf
