#include <algorithm>

#include "core/document/command_queue.h"
#include "core/document/extract.h"
#include "core/edit/separation.h"
#include "core/joints/joined_parts.h"
#include "core/physics/physics.h"
#include "core/physics/sleep.h"
#include "core/world/world.h"

namespace kerf {

size_t CommandQueue::waiting() const { return pending_.empty() && next_searches() ? 1 : pending_.size(); }

size_t CommandQueue::next_prepared_faces() const {
  const bool tick = !next_searches() && !pending_.empty() && pending_.front_kind() == BeamQueue::Kind::kTicks;
  if (!tick || !pending_.front_in_time().bodies) return 0;
  const bool beam = pending_.front_in_time().stroke != nullptr;
  size_t faces = 0;
  for (const BodyId id : world_.ids()) {
    const Body& body = world_.body(id);
    if (has_pieces_off(body) || (!body.hidden && physics_.needs_collider(world_, id, beam)))
      faces += body.mesh.live_faces();
  }
  return faces;
}

bool CommandQueue::next_is_of_last_step() const {
  const std::optional<size_t> open = recorder_.step();
  if (next_searches()) return open && is_last(*open);
  return !pending_.empty() && is_last(pending_.front_step());
}

Result<StepResult> CommandQueue::step(size_t most, bool one_stage, const Progress& progress) {
  if (next_searches()) return separate_more();
  if (pending_.empty() || most == 0) return StepResult{};
  const size_t step = pending_.front_step();
  switch (pending_.front_kind()) {
    case BeamQueue::Kind::kSpring:
      return change_spring();
    case BeamQueue::Kind::kTicks:
      return pass_ticks(most, progress);
    case BeamQueue::Kind::kRim:
      return recorded(step, close_rim_of_stroke(progress));
    case BeamQueue::Kind::kMove:
      break;
  }
  return recorded(step, run_moves(most, one_stage, progress));
}

// The pieces that a stroke separates are known before the next stroke or tick begins. If all queued moves of
// a running stroke are executed, the search waits for the next command: the end of a search determines which
// part keeps its label, and the time at which the queue becomes empty depends on the speed of execution.
bool CommandQueue::next_searches() const {
  // An edit begins and ends without a search; this makes a sequence of edits linear.
  const bool edited = history_.position() > 0 && history_.last().kind() == HistoryStep::Kind::kEdit;
  if ((edited && pending_.empty()) || is_settled(world_)) return false;
  if (pending_.empty()) return !in_stroke();
  return pending_.front_kind() == BeamQueue::Kind::kTicks || recorder_.step() != pending_.front_step();
}

StepResult CommandQueue::separate_more() {
  const size_t most = walked_ ? walked_->settings.search_a_move : CutSettings{}.search_a_move;
  StepResult some = continue_separation(world_, most);
  if (recorder_.step()) {
    record_cut(*recorder_.step(), some);
    finish(*recorder_.step());
  }
  return some;
}

Result<StepResult> CommandQueue::run_moves(size_t most, bool one_stage, const Progress& progress) {
  constexpr size_t kMaxAtOnce = 64;  // entries of a queue that may be long: a step covers a few of them
  if (is_over_budget()) return over_face_budget(face_budget_);
  begin(pending_.front_step());
  walked_ = pending_.front_stroke();
  const std::vector<BeamMove> moves =
      pending_.begin_moves(world_, one_stage ? 1 : std::min(most, kMaxAtOnce));
  walked_->list_path(world_);
  const CutSettings& settings = walked_->settings;
  UnfinishedMove& unfinished = pending_.unfinished();
  Result<StepResult> some = one_stage ? cut_stage(world_, settings, moves.front(), unfinished, &progress)
                                      : cut_step(world_, settings, moves, unfinished, &progress);
  if (some) pending_.pop_moves(some->moves);
  return some;
}

Result<StepResult> CommandQueue::close_rim_of_stroke(const Progress& progress) {
  if (is_over_budget() && !pending_.unfinished_rim().is_uninterruptible())
    return over_face_budget(face_budget_);
  begin(pending_.front_step());
  walked_ = pending_.front_stroke();
  Result<StepResult> some = rim_step(world_, walked_->settings, walked_->path, walked_->swept,
                                     pending_.unfinished_rim(), &progress);
  if (some && !pending_.unfinished_rim().begun()) pending_.pop();
  return some;
}

Result<StepResult> CommandQueue::pass_ticks(size_t most, const Progress& progress) {
  const size_t step = pending_.front_step();
  begin(step);
  if (pending_.front_in_time().bodies) return move_bodies(step, progress);
  pass(std::min<Ticks>(most, pending_.front_in_time().count));
  keep_open(step);
  return StepResult{};
}

void CommandQueue::pass(Ticks ticks) {
  world_.pass(ticks);
  cool_for_ticks(world_, ticks);
  pending_.pop(ticks);
}

// Executes one tick. First detaches pieces that were cut off since the last tick, and parts that turn on
// joints, as bodies.
Result<StepResult> CommandQueue::move_bodies(size_t step, const Progress& progress) {
  StepResult all;
  if (world_.clock() % kTicksToForget == 0) forget_details(world_);
  if (!physics_.has_joints_cached()) separate_by_joints(world_, JointMode::kArticulated, all.delta);
  release_pieces(world_, history_.step(step).generation, all.delta);
  follow_with_spring(world_, all.delta);
  record_cut(step, all);
  if (const auto& stroke = pending_.front_in_time().stroke) stroke->inherit(all.delta.detached);
  Result<StepResult> moved = move_under_beam(step, progress);
  if (!moved) return moved;
  all.delta.append(std::move(moved->delta));
  all.statistics.add(moved->statistics);
  pass(1);
  keep_open(step);
  return all;
}

// Moves bodies for a tick and, if the beam is on, cuts the bodies that move through it. In the thermal model
// the beam cuts only during its own moves: the energy of a tick belongs to them.
Result<StepResult> CommandQueue::move_under_beam(size_t step, const Progress& progress) {
  const std::shared_ptr<Stroke> stroke = pending_.front_in_time().stroke;
  std::map<BodyId, Placement> before;
  if (stroke) {
    for (const BodyId id : world_.ids()) before[id] = world_.body(id).placement;
  }
  StepResult all;
  all.delta = physics_.tick(world_, stroke != nullptr);
  history_.step(step).record(world_, all);
  if (!stroke) return all;
  walked_ = stroke;
  for (const BodyId id : std::vector<BodyId>(all.delta.moved)) {
    const Body& body = world_.body(id);
    const std::vector<BeamMove> moves =
        stroke->move_body(id, body, before[id], pending_.front_in_time().move.to);
    if (moves.empty() || !stroke->settings.cuts(id) || stroke->settings.model == Model::kThermal) continue;
    Result<StepResult> cut = cut_body(world_, stroke->settings, id, moves, &progress);
    if (!cut) return cut;
    record_cut(step, *cut);
    all.delta.append(std::move(cut->delta));
    all.statistics.add(cut->statistics);
  }
  return all;
}

StepResult CommandQueue::change_spring() {
  const size_t step = pending_.front_step();
  begin(step);
  world_.set_spring(pending_.front_in_time().spring);
  pending_.pop();
  keep_open(step);
  return {};
}

// Keeps the recording of a finished step open, because the ticks to come belong to it.
void CommandQueue::keep_open(size_t step) {
  if (is_over(step)) history_.step(step).finish();
}

void CommandQueue::begin(size_t step) {
  if (recorder_.step() == step) return;
  close_and_trim();
  history_.forget_behind(step);
  HistoryStep& begun = history_.step(step);
  // A step begins with the same contact state, whether its start was reached by execution, undo or redo.
  const bool newly_begun = begun.waiting();
  if (newly_begun) {
    for (const BodyId id : world_.ids()) forget_removals(world_.body(id));
    physics_.begin_step();
  }
  begun.begin(history_.window() > 0);
  recorder_.open(world_, step, begun.images() == HistoryStep::Images::kHeld);
  if (newly_begun && !world_.contact_memory().empty()) forget_details(world_);
}

void CommandQueue::close() {
  const std::optional<size_t> step = recorder_.step();
  if (!step) return;
  if (std::optional<World::Change> change = recorder_.close(world_))
    history_.step(*step).add(std::move(*change));
}

void CommandQueue::close_and_trim() {
  if (!recorder_.step()) return;
  close();
  history_.trim();
}

// Also wakes bodies that touched a changed body.
void CommandQueue::record_cut(size_t step, const StepResult& some) {
  forget_contacts(world_, some.delta);
  physics_.follow(some.delta);
  history_.step(step).record(world_, some);
}

Result<StepResult> CommandQueue::recorded(size_t step, Result<StepResult> some) {
  if (!some) return some;
  record_cut(step, *some);
  finish(step);
  return some;
}

// Queues the work of a timed command at the front.
void CommandQueue::enqueue_in_front(size_t step, const Command& command) {
  std::visit(Overloaded{
                 [&](const AdvanceTime& c) { pending_.push_ticks_in_front(step, c.ticks, c.bodies); },
                 [&](const DragBody& c) {
                   pending_.push_spring_in_front(step, Spring{c.piece, c.at, c.to});
                 },
                 [&](const ReleaseBody&) { pending_.push_spring_in_front(step, std::nullopt); },
                 [](const auto&) {},
             },
             command);
}

// Returns true if no work of a history step is queued or can be added by a running stroke.
bool CommandQueue::is_over(size_t step) const {
  const bool running = in_stroke() && is_last(step);
  return !running && !pending_.holds(step) && is_settled(world_);
}

void CommandQueue::finish(size_t step) {
  if (!is_over(step)) return;
  history_.step(step).finish();
  if (recorder_.step() == step) close_and_trim();
}

// A stroke that cannot be cut to its end stays in the history, because a replay fails in the same way, and
// so do the moves drawn after the failure: the stroke may be recut. If the failed step is a recut, nothing
// is cut, because the earlier settings no longer apply.
bool CommandQueue::give_up(size_t step, bool stopped) {
  KERF_ASSERT(!pending_.unfinished_rim().is_uninterruptible());
  if (in_stroke() && is_last(step)) drawn_->given_up = true;
  pending_.drop_strokes(step);
  if (stopped) pending_.clear();
  if (recorder_.step() == step) close();
  if (history_.step(step).images() == HistoryStep::Images::kDiscarded) {
    finish(step);
    return false;
  }
  undo(step);
  history_.step(step).forget();
  if (stopped) return true;
  begin(step);
  const bool recut = history_.step(step).kind() == HistoryStep::Kind::kRecut;
  if (recut && history_.holds_images(history_.base_of(step), step)) undo_strokes_of(step);
  const std::vector<Command> commands = history_.commands_of(step);
  for (size_t i = commands.size(); i-- > 0;) enqueue_in_front(step, commands[i]);
  finish(step);
  return true;
}

StepResult CommandQueue::set_states(std::span<const BodyState> states, std::span<const NearPair> pairs) {
  while (!pending_.empty()) {
    if (pending_.front_kind() == BeamQueue::Kind::kSpring) {
      change_spring();
      continue;
    }
    KERF_ASSERT(pending_.front_kind() == BeamQueue::Kind::kTicks && !pending_.front_in_time().stroke);
    begin(pending_.front_step());
    pass(pending_.front_in_time().count);
  }
  KERF_ASSERT(waiting() == 0 && history_.position() > 0);
  const size_t step = history_.position() - 1;
  begin(step);
  StepResult taken;
  for (const BodyState& state : states) {
    if (!world_.contains(state.id)) continue;
    Body& body = world_.body(state.id);
    body.placement = state.placement;
    body.motion = state.motion;
    taken.delta.moved.push_back(state.id);
  }
  set_known_pairs(world_, pairs);
  history_.step(step).record(world_, taken);
  keep_open(step);
  return taken;
}

}  // namespace kerf
