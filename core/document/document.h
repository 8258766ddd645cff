#pragma once

#include <deque>
#include <vector>

#include "core/base/result.h"
#include "core/document/command.h"
#include "core/world/world.h"

namespace kerf {

// A world and the commands that led to it.
//
// Commands say what happens; steps let it happen: a command of a stroke queues moves of the beam, and step()
// walks as many of them as it is asked to. However the moves are dealt out to steps, the same faces go.
class Document {
 public:
  Document() = default;
  explicit Document(World world) : world_(std::move(world)) {}

  const World& world() const { return world_; }

  // Appends the command to the journal and queues its moves. A stroke that is running is ended by the next
  // BeginStroke; moves without a stroke do nothing.
  void apply(const Command& command);

  // Moves that wait.
  size_t waiting() const { return moves_.size(); }
  // The first of them; null when none waits.
  const BeamMove* next_move() const { return moves_.empty() ? nullptr : &moves_.front(); }

  // Walks up to so many of them as one step; an empty delta when none waits. On failure the moves that wait
  // are dropped and the stroke ends; see cut_step for the state of the world.
  Result<StepResult> step(size_t moves);

  const std::vector<Command>& journal() const { return journal_; }
  size_t strokes() const { return strokes_; }
  bool in_stroke() const { return in_stroke_; }

 private:
  double reach(const Pose& pose) const;

  World world_;
  std::vector<Command> journal_;
  CutSettings settings_;  // of the stroke that runs
  Pose last_;
  bool in_stroke_ = false;
  size_t strokes_ = 0;
  std::deque<BeamMove> moves_;
};

}  // namespace kerf
