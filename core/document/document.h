#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/command.h"
#include "core/world/world.h"

namespace kerf {

// A world and the commands that led to it.
//
// Commands say what happens; steps let it happen: a command of a stroke queues moves of the beam, and step()
// walks as many of them as it is asked to. However the moves are dealt out to steps, the same faces go and
// the same pieces come off.
class Document {
 public:
  Document() = default;
  explicit Document(World world) : world_(std::move(world)), bounds_(world_.bounds()) {}

  const World& world() const { return world_; }

  // Appends the command to the journal and queues its moves. A stroke that is running is ended by the next
  // BeginStroke; moves without a stroke do nothing.
  void apply(const Command& command);

  // Moves that wait; the end of a stroke with a smooth rim counts as one.
  size_t waiting() const { return work_.size(); }
  // The first of them; null when none waits.
  const BeamMove* next_move() const { return work_.empty() ? nullptr : &work_.front().move; }

  // Walks up to so many of them as one step; an empty delta when none waits. On failure the stroke
  // ends there and its moves that wait are dropped; see cut_step for the state of the world.
  Result<StepResult> step(size_t moves, const Progress* progress = nullptr);

  // Takes the last stroke back and queues its moves again with other settings, as if it had been drawn so;
  // the journal says so too. Nothing else must have changed the world since. The world is a new one for
  // everything that follows it. Bodies of more than kMostFacesToRecut faces are not remembered, for a copy of
  // them would hold up the stroke.
  static constexpr size_t kMostFacesToRecut = 400'000;
  bool can_recut() const { return before_stroke_.has_value() && !in_stroke_; }
  void recut(const CutSettings& settings);

  // Of the last stroke: its settings, its commands as far as they came, and the world before it; null where
  // there is no stroke and where it was too large to be remembered.
  const CutSettings& stroke_settings() const { return stroke_->settings; }
  std::span<const Command> last_stroke() const {
    return std::span(journal_).subspan(stroke_at_, stroke_commands_);
  }
  const World* before_last_stroke() const { return before_stroke_ ? &*before_stroke_ : nullptr; }

  const std::vector<Command>& journal() const { return journal_; }
  size_t strokes() const { return strokes_; }
  bool in_stroke() const { return in_stroke_; }

 private:
  struct Stroke {
    CutSettings settings;
    std::vector<BeamMove> path;  // all of it, straight ways as one move
  };
  // A move of the beam, or the end of a stroke with a smooth rim.
  struct Work {
    BeamMove move;
    bool closes = false;
    std::shared_ptr<Stroke> stroke;
  };
  void run(const Command& command);
  void begin(const BeginStroke& begin);
  void move_to(const Pose& pose);
  void end();
  double reach(const Pose& pose) const;

  World world_;
  World::Bounds bounds_;  // before anything was cut
  std::vector<Command> journal_;
  std::shared_ptr<Stroke> stroke_ = std::make_shared<Stroke>();  // the last
  std::optional<World> before_stroke_;
  size_t stroke_at_ = 0;  // where the last stroke begins in the journal
  size_t stroke_commands_ = 0;
  Pose last_;
  bool in_stroke_ = false;
  size_t strokes_ = 0;
  Result<StepResult> walk_one(const Progress* progress);
  void drop(const std::shared_ptr<Stroke>& stroke);

  std::deque<Work> work_;
};

}  // namespace kerf
