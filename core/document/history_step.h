#pragma once

#include <map>
#include <vector>

#include "core/document/command.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// One step of a history: its commands, how far they have come, and what they did to the world.
class HistoryStep {
 public:
  enum class Kind {
    kStroke,  // a stroke with all its moves, and the time that passed after it
    kRecut,   // the stroke of the step before, cut again; and the time that passed after it
    kTime,    // time that passed where no stroke was before
    kEdit,    // a command that happens at once
  };
  enum class State {
    kWaiting,  // nothing of it was begun
    kBegun,    // some of it waits, or more may come
    kDone,
  };
  // Of what the step changed: what it was before.
  enum class Images {
    kNone,   // the step is waiting
    kHeld,   // all are held, or being recorded
    kLetGo,  // some are not: the step can only be taken back by a replay
  };

  // Precondition: the command is one that a step begins with.
  explicit HistoryStep(const Command& first);

  Kind kind() const { return kind_; }
  const std::vector<Command>& commands() const { return commands_; }
  Command& first() { return commands_.front(); }
  void add(const Command& command);
  // The generation of bodies that the step makes (see BodyId); it is of kind kEdit.
  uint32_t generation = 0;

  // What it took away: live faces, and their area (m^2).
  size_t removed_faces() const { return removed_faces_; }
  double removed_area() const { return removed_area_; }  // see Delta
  // What the steps that walked it looked at, made and took since it was begun.
  const StepFigures& figures() const { return figures_; }

  State state() const { return state_; }
  bool waiting() const { return state_ == State::kWaiting; }
  bool done() const { return state_ == State::kDone; }
  // The step is begun where it waits; `record`: all that it changes will be added.
  void begin(bool record);
  // Precondition: it was begun.
  void finish();
  // More was added to a step that was done.
  void reopen();

  Images images() const { return images_; }
  size_t bytes() const { return bytes_; }  // of memory that its images hold
  void add(World::Change change);
  // Notes what the step changed, so that a delta can tell of it when it is taken back.
  void touch(const Delta& delta);
  void add(const StepFigures& figures) { figures_.add(figures); }
  // Nothing of the step is in the world any more, nor remembered: it waits.
  void forget();
  // Its images go; what it did stays.
  void let_go();

  // Exchanges what the step changed with its images: it is taken back, or done again. Precondition: images
  // are held, and all steps behind it are taken back.
  Delta take_back(World& world);
  Delta bring_again(World& world);
  // Takes what the step did back as an edit of the world; the step stays as it is.
  Delta restore(World& world) const;

 private:
  // Slots of faces, some more than once: those whose corners changed, that came or went, and those whose
  // label changed.
  struct Touched {
    std::vector<FaceId> corners, labels;
  };
  Delta delta(const World& world, bool back) const;

  Kind kind_;
  State state_ = State::kWaiting;
  Images images_ = Images::kNone;
  std::vector<Command> commands_;
  size_t removed_faces_ = 0;
  double removed_area_ = 0;
  StepFigures figures_;
  std::vector<World::Change> changes_;  // in their order
  std::map<BodyId, Touched> touched_;   // by the id of the body after the step
  Delta bodies_;                        // what the step changed, except for faces
  size_t bytes_ = 0;
};

}  // namespace kerf
