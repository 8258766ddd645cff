#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
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
    kBegun,    // begun; parts are still queued, or more commands may follow
    kDone,
  };
  enum class Images {
    kNone,       // the step is waiting
    kHeld,       // all images are kept or being recorded
    kDiscarded,  // some images were discarded: the step can be undone only by a replay
  };
  // Sums over the parts of the step that have been executed.
  struct Totals {
    size_t bytes = 0;  // memory of the before-images
    // Live faces removed, and their area [m^2] (see Delta) and mass [kg].
    size_t removed_faces = 0;
    double removed_area = 0, removed_mass = 0;
    size_t cut_faces_kept = 0;  // number of faces in cut_faces()
    StepStatistics statistics;
    // The pieces that the step separated, by the ids of their bodies after the step, with the label of the
    // piece from which each was cut off.
    std::map<PieceId, uint32_t> came_off;
    // The separated pieces that were specks when they were cut off (see is_speck), including those of unknown
    // origin.
    std::set<PieceId> specks;
    // The number of faces that the beam removed, by name of the part or piece (see count_cut_names).
    std::map<std::string, size_t> cut_names;
    bool has_all_cut_faces() const { return cut_faces_kept == removed_faces; }
  };
  class SavePoint;

  // Precondition: the command can begin a step.
  explicit HistoryStep(const Command& first);

  Kind kind() const { return kind_; }
  const std::vector<Command>& commands() const { return commands_; }
  void add(const Command& command);
  void take_out_last() { commands_.pop_back(); }
  // Generation of the bodies that the step creates (see BodyId).
  uint32_t generation = 0;
  // Name of the piece that the first command refers to, when the step was begun; empty if there is none.
  std::string piece_name;

  bool waiting() const { return state_ == State::kWaiting; }
  bool done() const { return state_ == State::kDone; }
  // Begins the step if it is waiting. `record`: before-images of all its changes will be added.
  void begin(bool record);
  // Precondition: the step was begun.
  void finish();
  // Returns a finished step to kBegun, because commands were added to it.
  void reopen();

  const Totals& totals() const { return totals_; }
  // All changes except those of faces.
  const Delta& body_changes() const { return bodies_; }
  // Records changes of the step, from which undo and redo compute their delta.
  void record(const Delta& delta);
  // Records an executed part of the step, including the pieces that it separated. Call directly after the
  // part, because the origin of a new piece is derived from the faces removed next to it.
  void record(const World& world, const StepResult& part);
  // Resets the step to kWaiting after its changes were removed from the world. Drops all records of these
  // changes.
  void forget();

  Images images() const { return images_; }
  void add(World::Change change);
  // Discards the before-images. The changes stay in the world.
  void drop_before_images();

  // The faces that the beam removed in the step, by the id of the body after the step, for views of the
  // cut. They are kept while the step is undone and when its before-images are discarded. Incomplete beyond
  // kMaxCutFaces and after drop_cut_faces().
  static constexpr size_t kMaxCutFaces = 200'000;
  const CutFaces& cut_faces() const { return cut_faces_; }
  void drop_cut_faces();

  // Undoes or redoes the step by exchanging its changes with its before-images. Preconditions: the images
  // are held, and all later steps are undone.
  Delta undo(World& world);
  Delta redo(World& world);
  // Undoes the step by an edit of the world that is recorded like any other; the step itself does not change.
  // Undo several steps from the latest to the earliest; `slots` is slots_before() of the earliest (see
  // World::restore).
  Delta restore(World& world, size_t slots) const;
  // The number of body slots of the world before the step; nullopt if the step holds no images.
  std::optional<size_t> slots_before() const;

 private:
  // Face slots, possibly repeated: faces that were added, removed or had corners moved, and faces whose
  // label changed.
  struct Touched {
    std::vector<FaceId> corners, labels;
  };
  Delta delta(const World& world, bool back, const SavePoint* since = nullptr) const;
  void follow_bodies(const Delta& delta);
  void keep_cut_faces(const BodyDelta& delta);
  void record_new_pieces(const World& world, const Delta& delta);

  Kind kind_ = Kind::kEdit;
  State state_ = State::kWaiting;
  Images images_ = Images::kNone;
  std::vector<Command> commands_;
  std::vector<World::Change> changes_;  // in the order in which they were made
  std::map<BodyId, Touched> touched_;   // by the id of the body after the step
  Delta bodies_;
  CutFaces cut_faces_;
  Totals totals_;
};

// A save point in the execution of a step. It stores sizes and sums, because records of a step are only
// appended or summed.
class HistoryStep::SavePoint {
 public:
  // Precondition: the step was begun, and no recording is open.
  explicit SavePoint(const HistoryStep& step);

  // Returns true if the images of the step are held and, since the save point, the step has only been
  // executed further and has changed only faces of bodies.
  bool can_restore(const HistoryStep& step) const;
  // Restores the save point and sets the step to kBegun. Returns the changes. Preconditions:
  // can_restore(step), no recording is open, and all later steps are undone.
  Delta restore(HistoryStep& step, World& world) const;

 private:
  friend class HistoryStep;

  size_t commands_ = 0;
  Ticks ticks_ = 0;  // of the last command, which may grow
  size_t changes_ = 0;
  Totals totals_;
  std::map<BodyId, std::pair<size_t, size_t>> touched_;  // numbers of corners and labels
  std::map<BodyId, size_t> cut_faces_;
};

// Returns the kind of the history step that a command begins after a step of kind `last`, or at the start
// of the history. Returns nullopt for a command that continues that step, and for Undo and Redo.
std::optional<HistoryStep::Kind> history_step_kind(const Command& command,
                                                   std::optional<HistoryStep::Kind> last);

}  // namespace kerf
