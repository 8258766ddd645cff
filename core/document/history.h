#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/document/command.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// One step of a history: a stroke with all its moves, or another command, and what it did to the world.
class HistoryStep {
 public:
  explicit HistoryStep(const Command& first) : commands(1, first) {}

  std::vector<Command> commands;
  uint32_t generation = 0;  // of the bodies that they make: 1 + the place of the command in the journal
  size_t removed_faces = 0;
  double removed_area = 0;  // m^2, see Delta

  // Work was begun and all of it is done; what it changed is remembered, and can be exchanged.
  bool begun = false, done = false;
  bool remembered() const { return !changes_.empty(); }
  size_t bytes() const { return bytes_; }

  void add(World::Change change);
  // Notes what a part of the step changed.
  void touch(const Delta& delta);
  // Nothing of it is in the world any more, nor remembered.
  void forget();
  // Its before-images go; it stays done.
  void let_go();

  // Takes back what the step did, or does it again; returns what that changed.
  Delta take_back(World& world);
  Delta bring_again(World& world);
  // What the step did is taken back as an edit of the world; the step stays as it is.
  Delta restore(World& world) const;

 private:
  // Slots of faces, some more than once: with corners that changed, came or went, and with labels that did.
  struct Touched {
    std::vector<FaceId> corners, labels;
  };
  Delta delta(const World& world, bool back) const;

  std::vector<World::Change> changes_;  // in their order
  std::map<BodyId, Touched> touched_;   // by the id after the step
  Delta bodies_;                        // what it changed, but for the faces
  size_t bytes_ = 0;
};

// The steps of a document up to where it is, and those that were taken back. Before-images are held as far as
// a window of memory allows; the oldest go first.
class History {
 public:
  size_t position() const { return position_; }
  size_t size() const { return steps_.size(); }
  HistoryStep& step(size_t i) { return *steps_[i]; }
  const HistoryStep& step(size_t i) const { return *steps_[i]; }
  HistoryStep& last() { return *steps_[position_ - 1]; }
  const HistoryStep& last() const { return *steps_[position_ - 1]; }

  // A new step behind the position; those that were taken back are gone.
  void append(HistoryStep step);
  void back() { --position_; }
  void forth() { ++position_; }
  // Steps behind this one can only be done again by their commands.
  void forget_behind(size_t step);

  // Bytes of before-images that are held at most; 0: none are made.
  size_t window() const { return window_; }
  void set_window(size_t bytes);
  size_t bytes() const;
  void trim();

 private:
  std::vector<std::unique_ptr<HistoryStep>> steps_;
  size_t position_ = 0;
  size_t window_ = size_t{1} << 30;
};

}  // namespace kerf
