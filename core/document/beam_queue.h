#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/cut/cut_step.h"
#include "core/document/commands.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// A stroke being cut: its settings, the end of its queued moves, and the path that the beam has swept.
struct Stroke {
  CutSettings settings;
  BeamAt beam;                 // pose and time at the end of the last queued move
  bool ended = false;          // true if the end of the stroke is queued
  bool given_up = false;       // true if a part of the stroke failed: further moves are not executed
  size_t queued = 0;           // number of moves queued
  std::vector<BeamMove> path;  // moves that were begun; moves that rotate the beam are subdivided
  // For each body that has moved since the stroke began, the path of the beam in the frame of the body, from
  // moves of the beam and of the body. Unlisted bodies have not moved.
  SweptByBody swept;

  // Adds the path since the last call to `swept` for the bodies that have moved. Call before a body moves
  // again. O(appended moves * listed bodies).
  void list_path(const World& world);

  // Removes from the end of the path this number of moves, which were begun but not reached before the stroke
  // was stopped, and appends `instead` if given. Preconditions: list_path() was called after these moves were
  // begun, and no body has moved since.
  void cut_back(const World& world, size_t moves, const std::optional<BeamMove>& instead);

  // Copies the swept volumes of bodies to the pieces detached from them, which are cut if the bodies are.
  void inherit(std::span<const Detached> detached);

  // Records the motion of a body, from the placement `from`, under a stationary beam. Returns the resulting
  // moves of the beam in the frame of the body, subdivided and without moves that cannot hit the body, and
  // adds them to `swept`. Precondition: list_path() was called. The cost is proportional to the path only for
  // a body that moves for the first time.
  std::vector<BeamMove> move_body(BodyId id, const Body& body, const Placement& from, const Pose& beam);

 private:
  size_t listed_ = 0;  // number of moves of the path in `swept`
};

// The pending work of a document, in order: beam moves, ends of strokes with a smooth rim, ticks, and changes
// of the spring. Each entry belongs to a history step. A move is subdivided when it is begun, because the
// subdivision depends on the placements of the bodies at that time.
class BeamQueue {
 public:
  enum class Kind { kMove, kRim, kTicks, kSpring };
  struct Entry {
    size_t step = 0;
    Kind kind = Kind::kMove;
    std::shared_ptr<Stroke> stroke = {};  // of kMove and kRim, and of kTicks under a beam
    BeamMove move = {};                   // of kMove: not subdivided; of kTicks: the pose of the beam
    size_t number = 0;                    // of kMove: index of the move in its stroke
    size_t count = 1;                     // contribution to size(); of kTicks: the number of ticks
    bool bodies = false;                  // of kTicks: bodies move
    std::optional<Spring> spring = {};    // of kSpring
    double share = 1;                     // of kMove, > 0: the fraction of it to execute
    bool in_time() const { return kind == Kind::kTicks || kind == Kind::kSpring; }
  };

  bool empty() const { return ready_.empty() && entries_.empty(); }
  // The number of moves, ends of strokes, ticks and spring changes. A move counts as the number of parts of
  // its subdivision, estimated when it is appended and exact once it is begun.
  size_t size() const { return size_; }
  bool holds_beam() const { return size_ > in_time_; }
  bool holds_moves() const { return !ready_.empty() || rims_ + in_time_ < size_; }
  // Returns true if the queue is not empty and holds only ticks in which bodies do not move.
  bool only_cools() const;
  // Returns true if the queue holds work of a history step.
  bool holds(size_t step) const;

  void push_move(size_t step, std::shared_ptr<Stroke> stroke, const BeamMove& move, const World& world);
  void push_rim(size_t step, std::shared_ptr<Stroke> stroke);
  // `bodies`: bodies move in these ticks, under the beam of `stroke` at the end of its moves so far, or
  // without a beam if it is null.
  void push_ticks(size_t step, Ticks ticks, bool bodies, std::shared_ptr<Stroke> stroke);
  void push_spring(size_t step, const std::optional<Spring>& spring);
  // Insert ticks without a beam, or a spring change, at the front. Precondition: no move and no end of a
  // stroke is partly executed.
  void push_ticks_in_front(size_t step, Ticks ticks, bool bodies);
  void push_spring_in_front(size_t step, const std::optional<Spring>& spring);

  // The front of the queue. Precondition: !empty().
  size_t front_step() const;
  Kind front_kind() const { return ready_.empty() ? entries_.front().kind : Kind::kMove; }
  const std::shared_ptr<Stroke>& front_stroke() const;
  // Precondition: front_kind() is kTicks or kSpring.
  const Entry& front_in_time() const;

  // The move that the next step begins or continues; nullopt if the front is not a move.
  std::optional<BeamMove> next_move(const World& world) const;

  // Begins moves at the front: subdivides them, appends the parts to the path of their stroke, and returns
  // 1 to `most` parts. Preconditions: the front is a move, most > 0.
  std::vector<BeamMove> begin_moves(const World& world, size_t most);
  // Progress of the last step in the first move.
  UnfinishedMove& unfinished() { return unfinished_; }
  const UnfinishedMove& unfinished() const { return unfinished_; }
  // Progress of the last step in the end of a stroke at the front.
  UnfinishedRim& unfinished_rim() { return unfinished_rim_; }
  const UnfinishedRim& unfinished_rim() const { return unfinished_rim_; }

  // The progress of the beam in the stroke of a history step, counted as in StopStroke. An unfinished part
  // of a move counts as executed.
  StopStroke reached(size_t step) const;
  // Returns true if moves of the stroke are queued behind reached(step).
  bool holds_moves(size_t step) const;
  // Switches the beam of a stroke off at a place of its path: drops its later moves, and passes its later
  // ticks without a beam. The first move is kept. Precondition: the place is not before reached(step).
  void stop(size_t step, StopStroke at, const World& world);

  void pop_moves(size_t count);
  // Removes the front entry or, of ticks, the first `count`. Precondition: the front is not a move.
  void pop(size_t count = 1);

  // Remove the entries of a history step: all of them, or those of its strokes, so that its ticks pass
  // without a beam.
  void drop(size_t step);
  void drop_strokes(size_t step);
  void clear() { *this = BeamQueue(); }

 private:
  struct Begun {
    BeamMove move;
    size_t number = 0;   // see Entry
    size_t parts = 1;    // number of parts of its subdivision
    size_t in_path = 1;  // number of moves that it added to the path of its stroke
  };
  struct Part {
    BeamMove move;
    std::shared_ptr<const Begun> of;
    size_t number = 0;     // index of the part
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
  StopStroke reached_;  // of the stroke of reached_step_
  size_t reached_step_ = 0;
  std::shared_ptr<Stroke> ready_stroke_;
  UnfinishedMove unfinished_;
  UnfinishedRim unfinished_rim_;
  std::deque<Entry> entries_;  // behind ready_, in the order of steps
  size_t size_ = 0;
  size_t in_time_ = 0;  // number of ticks and spring changes among them
  size_t rims_ = 0;     // number of ends of strokes with a smooth rim among them
};

}  // namespace kerf
