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

// A step of the history: its commands, how far they have been executed, and what they changed.
class HistoryStep {
 public:
  enum class Kind {
    kStroke,  // a stroke with all its moves, and the time that passes within and after it
    kRecut,   // the previous stroke cut again with other settings, and the time that passes after it
    kTime,    // time that passes without a stroke before it, or after Play
    kEdit,    // a command that is executed at once, and the time that joins it
  };
  enum class State {
    kWaiting,  // nothing has been executed yet
    kBegun,    // a part is still in the queue, or more commands may follow
    kDone,
  };
  // The before-images of what the step changed.
  enum class Images {
    kNone,   // the step is waiting
    kHeld,   // all are kept, or are being recorded
    kLetGo,  // some were discarded, so that the step can only be undone by a replay
  };

  // Precondition: the command is one that can begin a step.
  explicit HistoryStep(const Command& first);

  Kind kind() const { return kind_; }
  const std::vector<Command>& commands() const { return commands_; }
  Command& first() { return commands_.front(); }
  void add(const Command& command);
  void take_out_last() { commands_.pop_back(); }
  // The generation of bodies that the step creates (see BodyId).
  uint32_t generation = 0;
  // The name of the piece that the first command names, as it was when the step was begun; empty where there
  // is none.
  std::string piece_name;

  // The number of live faces that the step removed, and their area (m^2).
  size_t removed_faces() const { return sums_.removed_faces; }
  double removed_area() const { return sums_.removed_area; }  // see Delta
  double removed_mass() const { return sums_.removed_mass; }
  // The sum of the statistics of all cut steps that executed it.
  const StepStatistics& statistics() const { return sums_.statistics; }

  State state() const { return state_; }
  bool waiting() const { return state_ == State::kWaiting; }
  bool done() const { return state_ == State::kDone; }
  // Begins the step if it is waiting. `record`: the before-images of all its changes will be added.
  void begin(bool record);
  // Precondition: it was begun.
  void finish();
  // Makes a finished step begun again, because commands were added to it.
  void reopen();

  Images images() const { return images_; }
  size_t bytes() const { return sums_.bytes; }  // memory of its before-images
  void add(World::Change change);
  // Notes what the step changed, from which the delta is made when the step is undone or redone.
  void touch(const Delta& delta);
  void add(const StepStatistics& statistics) { sums_.statistics.add(statistics); }
  // Makes the step waiting again, after its changes were taken out of the world. Drops all records of them.
  void forget();
  // Discards the before-images. The changes stay in the world.
  void drop_before_images();

  // The id after the step of a body that has the id `before` ahead of it and was not removed by it.
  BodyId id_after_step(BodyId before) const { return id_after(bodies_, before); }

  // The id after the step of a piece, which another body has if the step detached it.
  PieceId piece_after_step(PieceId before) const;

  // The pieces that came off in the step, by the ids of the bodies after the step, and the label of the piece
  // that each came off. record_new_pieces() is told of each part of the step right after it: what came off
  // what is found from the faces that were removed beside a new piece.
  const std::map<PieceId, uint32_t>& came_off() const { return sums_.came_off; }
  void record_new_pieces(const World& world, const Delta& delta);
  // Of these, those that were specks when they came off (see is_speck), found or not what they came off.
  const std::set<PieceId>& specks() const { return sums_.specks; }
  // The pieces that the step detached, one after the other.
  const std::vector<Detached>& detached() const { return bodies_.detached; }
  // How many faces the beam removed in the step from what (see count_cut_names).
  const std::map<std::string, size_t>& cut_names() const { return sums_.cut_names; }

  // The faces that the beam removed in the step, by the id of the body after the step, for views of the cut.
  // They are kept while the step is undone, and when its before-images are discarded. Beyond
  // kMaxCutFaces, and after drop_cut_faces(), some are missing.
  static constexpr size_t kMaxCutFaces = 200'000;
  const CutFaces& cut_faces() const { return cut_faces_; }
  size_t cut_faces_kept() const { return sums_.cut_faces_kept; }
  bool has_all_cut_faces() const { return sums_.cut_faces_kept == sums_.removed_faces; }
  void drop_cut_faces();

  // Undoes or redoes the step by exchanging what it changed with its before-images. Preconditions: the images
  // are held, and all later steps are undone.
  Delta undo(World& world);
  Delta redo(World& world);
  // What the parts of the step that have been executed sum up to.
  struct Sums {
    size_t bytes = 0;  // memory of the before-images
    size_t removed_faces = 0, cut_faces_kept = 0;
    double removed_area = 0, removed_mass = 0;
    StepStatistics statistics;
    std::map<PieceId, uint32_t> came_off;
    std::set<PieceId> specks;
    std::map<std::string, size_t> cut_names;
  };
  // How far the execution of the step has come. All that the step notes is appended or summed up.
  struct Mark {
    size_t commands = 0;
    Ticks ticks = 0;  // of the last command, to which more may be added
    size_t changes = 0;
    Sums sums;
    std::map<BodyId, std::pair<size_t, size_t>> touched;  // numbers of corners and labels
    std::map<BodyId, size_t> cut_faces;
  };
  // Precondition: the step was begun, and no recording is open.
  Mark mark() const;
  // Whether the step has only been executed further since then, has left the bodies as they are but for their
  // faces, and its images are held.
  bool can_go_back_to(const Mark& mark) const;
  // Goes back to there: the step is begun. Returns what changed. Preconditions: can_go_back_to(mark), no
  // recording is open, and all later steps are undone.
  Delta go_back_to(const Mark& mark, World& world);

  // Undoes the step by an edit of the world that is recorded like any other. The step is left unchanged.
  // Several in a row are undone the latest first; `slots` is that of the earliest (see World::restore).
  Delta restore(World& world, size_t slots) const;
  // The slots of bodies that the world had before the step; none where the step holds no images.
  std::optional<size_t> slots_before() const;

 private:
  // Slots of faces, possibly repeated: faces that were added, removed or had corners moved, and faces whose
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

// The kind of the step of the history that a command begins where the step before it is of the kind `last`,
// or where there is none. Nothing for a command that goes on with that step, and for Undo and Redo.
std::optional<HistoryStep::Kind> history_step_kind(const Command& command,
                                                   std::optional<HistoryStep::Kind> last);

// The timeline of a document: the steps before its position are done, those from the position on were undone.
// The before-images of steps are kept within a limit of memory, the window; the oldest are discarded first.
class History {
 public:
  size_t position() const { return position_; }
  size_t size() const { return steps_.size(); }
  // Precondition: i < size().
  HistoryStep& step(size_t i) { return *steps_[i]; }
  const HistoryStep& step(size_t i) const { return *steps_[i]; }
  // The step before the position. Precondition: position() > 0.
  HistoryStep& last() { return *steps_[position_ - 1]; }
  const HistoryStep& last() const { return *steps_[position_ - 1]; }

  // Adds a step at the position and drops the steps that were undone.
  void append(HistoryStep step);
  void drop_undone() { steps_.resize(position_); }
  // Takes the undone steps out, and puts such steps in place of those that are undone.
  std::vector<std::unique_ptr<HistoryStep>> take_undone();
  void put_undone(std::vector<std::unique_ptr<HistoryStep>> steps);
  void back() { --position_; }
  void forth() { ++position_; }
  // Forgets what the steps after this one did, so that they can only be redone by executing their commands.
  void forget_behind(size_t step);

  // Whether a step is a stroke or a recut of one.
  bool cuts(size_t step) const;
  // The stroke itself, or for a recut the stroke that it cuts again.
  size_t base_of(size_t step) const;
  // Whether a step is a stroke or a recut whose effect a later recut took back.
  bool is_cut_again(size_t step) const;
  // The last step before the position that is a stroke or a recut.
  std::optional<size_t> last_cut() const;
  // The settings of the last stroke before the position, with which it was cut last, and its commands so far.
  // Precondition: last_cut().
  const CutSettings& last_settings() const { return settings_of(*last_cut()); }
  const std::vector<Command>& last_stroke() const { return step(base_of(*last_cut())).commands(); }
  // The settings with which a step cuts. Precondition: cuts(step).
  const CutSettings& settings_of(size_t step) const;
  // The commands that reproduce the effect of a step. For a recut these are the commands of the stroke with
  // the settings of the recut, followed by the time that passed after the stroke and after each recut.
  std::vector<Command> commands_of(size_t step) const;
  // Sums over the strokes before the position: their number, the faces they removed, and the area (m^2) and
  // the mass (kg) of these.
  size_t strokes() const;
  size_t removed_faces() const;
  double removed_area() const;
  double removed_mass() const;

  // The faces that the last stroke before the position removed (see HistoryStep::cut_faces), by the ids that
  // the bodies have at the position; a body that a later step removed is listed, too. Empty without a stroke.
  CutFaces last_cut_faces() const;

  // Whether the before-images of all steps first .. end - 1 are kept.
  bool holds_images(size_t first, size_t end) const;
  // Whether any of the steps first .. end - 1 has been begun, i.e. may have changed the world.
  bool any_begun(size_t first, size_t end) const;

  // The slots of bodies that the world had before the first of the steps first .. end - 1 of which images are
  // held; 0 without one.
  size_t slots_before(size_t first, size_t end) const;

  // The limit for the before-images, in bytes; with 0 none are recorded.
  size_t window() const { return window_; }
  void set_window(size_t bytes);
  size_t bytes() const;
  // Discards before-images, the oldest first, until they are within the window; and the faces that the oldest
  // steps cut, until at most kMaxCutFaces are kept besides those of the latest step.
  static constexpr size_t kMaxCutFaces = 500'000;
  void trim();

 private:
  void trim_cut_faces();

  std::vector<std::unique_ptr<HistoryStep>> steps_;
  size_t position_ = 0;
  size_t window_ = size_t{1} << 30;
};

}  // namespace kerf
