#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"
#include "core/document/journal.h"

namespace kerf {

// A run of commands of a journal that only simulate bodies, and the mark with the resulting states. A replay
// may apply these states instead, and reaches the same world.
struct TimeSkip {
  size_t first = 0;  // index of the first of these commands
  size_t mark = 0;   // index in Journal::marks
  Ticks ticks = 0;   // duration until the mark
};

// Returns the runs of at least `least` ticks that can be skipped, in order. A run begins with Play or at the
// end of the stroke before it, and ends at its last mark from which motion continues bit-identically: at the
// end of the history step, or at a full minute (see CommandQueue::kTicksToForget).
std::vector<TimeSkip> time_skips(const Journal& journal, Ticks least);

// Returns a document of the loaded world of a scene. To undo a step whose before-images were discarded, as a
// journal may require, the document loads the scene again and replays.
Document document_of(World world, const SceneDescription& scene);

// Applies the commands of a journal to a document with the journal's scene, and compares the state of the
// world with each mark. The journal and the document must outlive the replay.
class Replay {
 public:
  // `skips`: runs of time for which bodies get the states of the marks instead of being simulated.
  Replay(const Journal& journal, Document& document, std::vector<TimeSkip> skips = {})
      : journal_(journal), document_(document), skips_(std::move(skips)) {
    compare();
  }

  bool done() const { return next_ == journal_.commands.size() && document_.waiting() == 0; }
  // The number of commands applied so far. A call of `told` refers to the last of them.
  size_t applied() const { return next_; }
  // Progress, 0 .. 1.
  double fraction() const;

  // Applies the next command, executes the queue (see run_queue) and calls `told` after each step, and also
  // for the changes of an immediate command. A failed command or step does not end the replay if `told`
  // returns success, because it also failed when the journal was recorded; a mesh file that cannot be read
  // does. Precondition: !done().
  Status next(const QueueRun& how);
  // Replays the remaining commands. Reports fraction() to QueueRun::progress. Fails like run_queue().
  Status run(const QueueRun& how);

  // The first mark whose hash differs from that of the world, and the hash of the world there. Marks after
  // motion recorded on another kind of machine are not compared.
  struct Difference {
    StateMark mark;
    uint64_t hash = 0;
  };
  const std::optional<Difference>& difference() const { return difference_; }

  // The kind of machine that recorded a different motion, so that the states of bodies were taken from the
  // marks; empty if there is none. Does not count as a difference.
  const std::string& other_machine() const { return other_machine_; }
  // Returns true if such a difference of motion changed the result of a stroke that was drawn while bodies
  // moved.
  bool cut_otherwise() const { return cut_otherwise_; }

  // Returns true if the looks of the bodies differ from those at a mark, because a material library, an image
  // or the mesh file was edited. The shape can be equal nevertheless.
  bool looks_differ() const { return looks_differ_; }

  Ticks skipped() const { return skipped_; }

 private:
  template <typename Kind>
  bool is_a(size_t command) const {
    return command < journal_.commands.size() && std::holds_alternative<Kind>(journal_.commands[command]);
  }
  size_t end_of_stopped();
  size_t end_of_undone();
  void find_undone();
  Status report(const QueueRun& how, Outcome outcome) const;
  Status skip(const QueueRun& how, const TimeSkip& skip);
  void compare();
  bool takes_bodies(const StateMark& mark);

  const Journal& journal_;
  Document& document_;
  size_t next_ = 0, next_mark_ = 0;
  size_t end_of_moves_ = 0;  // the first command from next_ + 1 on that does not continue a stroke, if known
  size_t cuts_end_ = 0;      // the end of strokes and recuts that follow each other
  size_t undone_begin_ = 0,
         undone_end_ = 0;  // those of them that are undone behind the last, and their Undos
  std::optional<Difference> difference_;
  std::string other_machine_;
  bool cut_otherwise_ = false, looks_differ_ = false;
  std::vector<TimeSkip> skips_;  // ascending
  size_t next_skip_ = 0;
  Ticks skipped_ = 0;
};

}  // namespace kerf
