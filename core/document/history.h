#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/commands.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// A history step: its commands, the progress of their execution, and the changes that they made.
class HistoryStep {
 public:
  enum class Kind {
    kStroke,  // a stroke with all its moves, and the time that passes within and after it
    kRecut,   // the previous stroke cut with other settings, and the time that passes after it
    kTime,    // time without a stroke before it, or after Play
    kEdit,    // a command that executes immediately, and the time that joins it
  };
  enum class State {
    kWaiting,  // nothing has been executed yet
    kBegun,    // a part is still queued, or more commands may follow
    kDone,
  };
  enum class Images {
    kNone,   // the step is waiting
    kHeld,   // all are kept or being recorded
    kLetGo,  // some were discarded: the step can be undone only by a replay
  };

  // Precondition: the command can begin a step.
  explicit HistoryStep(const Command& first);

  Kind kind() const { return kind_; }
  const std::vector<Command>& commands() const { return commands_; }
  Command& first() { return commands_.front(); }
  void add(const Command& command);
  void take_out_last() { commands_.pop_back(); }
  // Generation of the bodies that the step creates (see BodyId).
  uint32_t generation = 0;
  // Name of the piece that the first command refers to, when the step was begun; empty if there is none.
  std::string piece_name;

  // Live faces removed by the step, and their area [m^2] (see Delta) and mass [kg].
  size_t removed_faces() const { return sums_.removed_faces; }
  double removed_area() const { return sums_.removed_area; }
  double removed_mass() const { return sums_.removed_mass; }
  const StepStatistics& statistics() const { return sums_.statistics; }

  State state() const { return state_; }
  bool waiting() const { return state_ == State::kWaiting; }
  bool done() const { return state_ == State::kDone; }
  // Begins the step if it is waiting. `record`: the before-images of all its changes will be added.
  void begin(bool record);
  // Precondition: it was begun.
  void finish();
  // Returns a finished step to kBegun, because commands were added to it.
  void reopen();

  Images images() const { return images_; }
  size_t bytes() const { return sums_.bytes; }  // memory of its before-images
  void add(World::Change change);
  // Records changes of the step, from which undo and redo compute their delta.
  void touch(const Delta& delta);
  void add(const StepStatistics& statistics) { sums_.statistics.add(statistics); }
  // Returns the step to kWaiting after its changes were removed from the world. Drops all records of them.
  void forget();
  // Discards the before-images. The changes stay in the world.
  void drop_before_images();

  // Maps the id of a body before the step to its id after it. Precondition: the step did not remove the
  // body.
  BodyId id_after_step(BodyId before) const { return id_after(bodies_, before); }

  // The same for a piece, which is in another body if the step detached it.
  PieceId piece_after_step(PieceId before) const;

  // The pieces that the step separated, by the ids of their bodies after the step, with the label of the
  // piece from which each came off. Call record_new_pieces() directly after each part of the step: it finds
  // that label from the faces removed next to a new piece.
  const std::map<PieceId, uint32_t>& came_off() const { return sums_.came_off; }
  void record_new_pieces(const World& world, const Delta& delta);
  // The separated pieces that were specks when they came off (see is_speck), whether or not their origin is
  // known.
  const std::set<PieceId>& specks() const { return sums_.specks; }
  const std::vector<Detached>& detached() const { return bodies_.detached; }
  // The number of faces that the beam removed, by name of the part or piece (see count_cut_names).
  const std::map<std::string, size_t>& cut_names() const { return sums_.cut_names; }

  // The faces that the beam removed in the step, by the id of the body after the step, for views of the
  // cut. They are kept while the step is undone and when its before-images are discarded. Incomplete beyond
  // kMaxCutFaces and after drop_cut_faces().
  static constexpr size_t kMaxCutFaces = 200'000;
  const CutFaces& cut_faces() const { return cut_faces_; }
  size_t cut_faces_kept() const { return sums_.cut_faces_kept; }
  bool has_all_cut_faces() const { return sums_.cut_faces_kept == sums_.removed_faces; }
  void drop_cut_faces();

  // Undoes or redoes the step by exchanging its changes with its before-images. Preconditions: the images
  // are held, and all later steps are undone.
  Delta undo(World& world);
  Delta redo(World& world);
  struct Sums {
    size_t bytes = 0;  // memory of the before-images
    size_t removed_faces = 0, cut_faces_kept = 0;
    double removed_area = 0, removed_mass = 0;
    StepStatistics statistics;
    std::map<PieceId, uint32_t> came_off;
    std::set<PieceId> specks;
    std::map<std::string, size_t> cut_names;
  };
  // A save point of the execution of the step. All records of a step are appended or summed.
  struct Mark {
    size_t commands = 0;
    Ticks ticks = 0;  // of the last command, which may grow
    size_t changes = 0;
    Sums sums;
    std::map<BodyId, std::pair<size_t, size_t>> touched;  // numbers of corners and labels
    std::map<BodyId, size_t> cut_faces;
  };
  // Precondition: the step was begun, and no recording is open.
  Mark mark() const;
  // Returns true if the step has only been executed further since then, has changed nothing of the bodies
  // but their faces, and its images are held.
  bool can_go_back_to(const Mark& mark) const;
  // Restores the save point; the step is kBegun then. Returns the changes. Preconditions:
  // can_go_back_to(mark), no recording is open, and all later steps are undone.
  Delta go_back_to(const Mark& mark, World& world);

  // Undoes the step by an edit of the world that is recorded like any other; the step is unchanged. Undo
  // several steps from the latest to the earliest; `slots` is that of the earliest (see World::restore).
  Delta restore(World& world, size_t slots) const;
  // The number of body slots of the world before the step; nullopt if the step holds no images.
  std::optional<size_t> slots_before() const;

 private:
  // Face slots, possibly repeated: faces that were added, removed or had corners moved, and faces whose
  // label changed.
  struct Touched {
    std::vector<FaceId> corners, labels;
  };
  Delta delta(const World& world, bool back, const Mark* since = nullptr) const;
  void follow_bodies(const Delta& delta);
  void keep_cut_faces(const BodyDelta& delta);

  Kind kind_ = Kind::kEdit;
  State state_ = State::kWaiting;
  Images images_ = Images::kNone;
  std::vector<Command> commands_;
  std::vector<World::Change> changes_;  // in the order in which they were made
  std::map<BodyId, Touched> touched_;   // by the id of the body after the step
  Delta bodies_;                        // all changes except those of faces
  CutFaces cut_faces_;
  Sums sums_;
};

// Returns the kind of the history step that a command begins after a step of kind `last`, or at the start
// of the history. Returns nullopt for a command that continues that step, and for Undo and Redo.
std::optional<HistoryStep::Kind> history_step_kind(const Command& command,
                                                   std::optional<HistoryStep::Kind> last);

// The timeline of a document: steps before the position are done, steps from it on are undone. The
// before-images are kept within a memory limit, the window; the oldest are discarded first.
class History {
 public:
  size_t position() const { return position_; }
  size_t size() const { return steps_.size(); }
  // Precondition: i < size().
  HistoryStep& step(size_t i) { return *steps_[i]; }
  const HistoryStep& step(size_t i) const { return *steps_[i]; }
  // Precondition: position() > 0.
  HistoryStep& last() { return *steps_[position_ - 1]; }
  const HistoryStep& last() const { return *steps_[position_ - 1]; }

  // Adds a step at the position and drops the steps that were undone.
  void append(HistoryStep step);
  void drop_undone() { steps_.resize(position_); }
  // Removes and returns the undone steps; replaces the undone steps by these.
  std::vector<std::unique_ptr<HistoryStep>> take_undone();
  void put_undone(std::vector<std::unique_ptr<HistoryStep>> steps);
  void back() { --position_; }
  void forth() { ++position_; }
  // Drops the records of the steps after this one, so that they can only be redone by executing their
  // commands.
  void forget_behind(size_t step);

  // Returns true if a step is a stroke or a recut.
  bool cuts(size_t step) const;
  // The stroke itself, or for a recut the stroke that it cuts again.
  size_t base_of(size_t step) const;
  // Returns true if a step is a stroke or a recut that a later recut replaced.
  bool is_cut_again(size_t step) const;
  // The last stroke or recut before the position.
  std::optional<size_t> last_cut() const;
  // The settings of the last cut of the last stroke before the position, and the commands of the stroke so
  // far. Precondition: last_cut().
  const CutSettings& last_settings() const { return settings_of(*last_cut()); }
  const std::vector<Command>& last_stroke() const { return step(base_of(*last_cut())).commands(); }
  // The cut settings of a step. Precondition: cuts(step).
  const CutSettings& settings_of(size_t step) const;
  // The commands that reproduce the effect of a step. For a recut: the commands of the stroke with the
  // settings of the recut, followed by the time that passed after the stroke and after each recut.
  std::vector<Command> commands_of(size_t step) const;
  // Totals of the strokes before the position: their number, the faces they removed, and the area [m^2] and
  // mass [kg] of these.
  size_t strokes() const;
  size_t removed_faces() const;
  double removed_area() const;
  double removed_mass() const;

  // The faces removed by the last stroke before the position (see HistoryStep::cut_faces), by the ids that
  // the bodies have at the position; includes bodies that a later step removed. Empty without a stroke.
  CutFaces last_cut_faces() const;

  bool holds_images(size_t first, size_t end) const;
  // Returns true if any of the steps first .. end - 1 has been begun, i.e. may have changed the world.
  bool any_begun(size_t first, size_t end) const;

  // The number of body slots of the world before the first of the steps first .. end - 1 that holds images;
  // 0 if none does.
  size_t slots_before(size_t first, size_t end) const;

  // Memory limit of the before-images [bytes]; 0 records none.
  size_t window() const { return window_; }
  void set_window(size_t bytes);
  size_t bytes() const;
  // Discards the oldest before-images until they fit the window, and the cut faces of the oldest steps
  // until at most kMaxCutFaces are kept in addition to those of the latest step.
  static constexpr size_t kMaxCutFaces = 500'000;
  void trim();

 private:
  void trim_cut_faces();

  std::vector<std::unique_ptr<HistoryStep>> steps_;
  size_t position_ = 0;
  size_t window_ = size_t{1} << 30;
};

}  // namespace kerf
