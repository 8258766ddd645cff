#include "core/document/document.h"

#include <algorithm>
#include <cassert>

#include "core/document/piece_commands.h"
#include "core/graph/separation.h"

namespace kerf {

Result<Delta> Document::apply(const Command& command, const Progress* progress) {
  if (const auto* c = std::get_if<BeginStroke>(&command)) {
    apply(*c);
  } else if (const auto* m = std::get_if<MoveStroke>(&command)) {
    apply(*m);
  } else {
    end();
    if (const auto* again = std::get_if<Recut>(&command)) return recut(*again);
    if (std::holds_alternative<Undo>(command)) return undo(progress);
    if (std::holds_alternative<Redo>(command)) return redo(progress);
    if (!std::holds_alternative<EndStroke>(command)) return at_once(command, progress);
  }
  return Delta{};
}

void Document::apply(const BeginStroke& command) {
  end();
  history_.append(HistoryStep(command));
  ++revision_;
  in_stroke_ = true;
  run(history_.position() - 1, command);
  journal_.emplace_back(command);
}

void Document::apply(const MoveStroke& command) {
  if (!in_stroke_) return;
  history_.last().commands.emplace_back(command);
  run(history_.position() - 1, command);
  journal_.emplace_back(command);
}

void Document::apply(const EndStroke&) { end(); }

void Document::end() {
  if (!in_stroke_) return;
  const size_t step = history_.position() - 1;
  history_.last().commands.emplace_back(EndStroke{});
  run(step, EndStroke{});
  journal_.emplace_back(EndStroke{});
  in_stroke_ = false;
  settle(step);
}

// Queues what a command of a stroke asks for.
void Document::run(size_t step, const Command& command, const CutSettings* instead) {
  if (const auto* c = std::get_if<BeginStroke>(&command)) {
    stroke_ = std::make_shared<Stroke>(instead ? *instead : c->settings, c->pose);
    work_.push_back({step, {c->pose, c->pose}, false, stroke_});
  } else if (const auto* m = std::get_if<MoveStroke>(&command)) {
    stroke_->reach = reach(stroke_->pose);
    for (const BeamMove& move : stroke_->move_to(m->pose)) work_.push_back({step, move, false, stroke_});
  } else if (stroke_->settings.smooth()) {
    work_.push_back({step, {stroke_->pose, stroke_->pose}, true, stroke_});
  }
}

// How far along the beam there is anything to cut: to the farthest corner of what was loaded, for what is
// left of it depends on how far the moves that wait were walked.
double Document::reach(const Pose& pose) const {
  const World::Bounds bounds = world_.loaded_bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - pose.origin), glm::abs(bounds.max - pose.origin));
  return std::min(stroke_->settings.laser.range.high, glm::length(far));
}

// Strokes of the history ------------------------------------------------------------------------------------

bool Document::cuts(size_t step) const {
  const Command& first = history_.step(step).commands.front();
  return std::holds_alternative<BeginStroke>(first) || std::holds_alternative<Recut>(first);
}

// The stroke that a step of the history cuts, or cuts again.
size_t Document::base_of(size_t step) const {
  while (std::holds_alternative<Recut>(history_.step(step).commands.front())) --step;
  return step;
}

std::optional<size_t> Document::last_cut() const {
  for (size_t i = history_.position(); i-- > 0;) {
    if (cuts(i)) return i;
  }
  return std::nullopt;
}

const CutSettings& Document::stroke_settings() const {
  const Command& first = history_.step(*last_cut()).commands.front();
  if (const auto* again = std::get_if<Recut>(&first)) return again->settings;
  return std::get<BeginStroke>(first).settings;
}

const std::vector<Command>& Document::last_stroke() const {
  return history_.step(base_of(*last_cut())).commands;
}

size_t Document::strokes() const {
  size_t strokes = 0;
  for (size_t i = 0; i < history_.position(); ++i) strokes += cuts(i) && base_of(i) == i;
  return strokes;
}

bool Document::is_cut_again(size_t step) const {
  return step + 1 < history_.position() && cuts(step + 1) && base_of(step + 1) != step + 1;
}

size_t Document::removed_faces() const {
  size_t faces = 0;
  for (size_t i = 0; i < history_.position(); ++i)
    faces += is_cut_again(i) ? 0 : history_.step(i).removed_faces;
  return faces;
}

double Document::removed_area() const {
  double area = 0;
  for (size_t i = 0; i < history_.position(); ++i)
    area += is_cut_again(i) ? 0 : history_.step(i).removed_area;
  return area;
}

std::optional<World> Document::before_last_stroke() {
  const auto last = last_cut();
  if (!last || *last + 1 != history_.position() || world_.live_faces() > kMostFacesToCopy)
    return std::nullopt;
  const std::optional<size_t> open = open_;
  close();
  World before = world_;
  if (open) remember(*open);
  for (size_t i = *last + 1; i-- > base_of(*last);) {
    const HistoryStep& step = history_.step(i);
    if (step.begun && !step.remembered()) return std::nullopt;
    step.restore(before);
  }
  return before;
}

// Walking ---------------------------------------------------------------------------------------------------

size_t Document::waiting() const { return work_.empty() && !is_settled(world_) ? 1 : work_.size(); }

Result<StepResult> Document::step(size_t moves, const Progress* progress) {
  // What came apart in one stroke is known before the next one begins.
  const bool walked = open_ && (work_.empty() || work_.front().step != *open_);
  if (walked && !is_settled(world_))
    return noted(*open_, go_on_separating(world_, stroke_->settings.search_a_move));
  if (work_.empty() || moves == 0) return StepResult{};
  const size_t step = work_.front().step;
  bool stopped = false;
  const Progress watched{[&](double fraction) {
    stopped = progress && !progress->report(fraction);
    return !stopped;
  }};
  Result<StepResult> some = walk_some(moves, watched);
  if (some) return noted(step, std::move(*some));
  give_up(step, stopped);
  return some.error();
}

// The moves of one stroke that come next, or its end.
Result<StepResult> Document::walk_some(size_t most, const Progress& progress) {
  constexpr size_t kMostAtOnce = 64;  // of a queue that may be long: a bite holds a few of them
  const Work first = work_.front();
  remember(first.step);
  if (first.closes) {
    work_.pop_front();
    return close_rim(world_, first.stroke->settings, first.stroke->path, &progress);
  }
  std::vector<BeamMove> now;
  for (const Work& w : work_) {
    if (now.size() == std::min(most, kMostAtOnce) || w.closes || w.step != first.step) break;
    now.push_back(w.move);
  }
  Result<StepResult> some = cut_step(world_, first.stroke->settings, now, unfinished_, &progress);
  if (some) work_.erase(work_.begin(), work_.begin() + static_cast<std::ptrdiff_t>(some->moves));
  return some;
}

// What was done of a step of the history.
StepResult Document::noted(size_t step, StepResult some) {
  history_.step(step).touch(some.delta);
  settle(step);
  return some;
}

// A stroke that cannot be cut to its end has cut nothing: it stays in the history, for whoever replays it
// comes to the same. One that was stopped is taken back, with all that waits behind it.
void Document::give_up(size_t step, bool stopped) {
  if (in_stroke_ && (stopped || step + 1 == history_.position())) end();
  drop_work(step);
  if (stopped) work_.clear();
  if (open_ == step) close();
  ++revision_;
  HistoryStep& failed = history_.step(step);
  failed.done = true;
  if (!failed.remembered()) return;
  failed.take_back(world_);
  failed.forget();
  if (!stopped) {
    remember(step);
    return settle(step);
  }
  for (; history_.position() > step; history_.back()) journal_.emplace_back(Undo{});
}

bool Document::waits(size_t step) const {
  return std::any_of(work_.begin(), work_.end(), [&](const Work& w) { return w.step == step; });
}

void Document::drop_work(size_t step) {
  if (!work_.empty() && work_.front().step == step) unfinished_ = UnfinishedMove{};
  std::erase_if(work_, [&](const Work& w) { return w.step == step; });
}

// From here on what changes is that step's doing.
void Document::remember(size_t step) {
  if (open_ == step) return;
  close();
  history_.forget_behind(step);
  // A step begins alike whatever way the world has come to where it begins.
  if (!history_.step(step).begun) {
    for (const BodyId id : world_.ids()) forget_removals(world_.body(id));
  }
  history_.step(step).begun = true;
  open_ = step;
  remembering_ = history_.window() > 0;
  if (remembering_) world_.begin_change();
}

void Document::close() {
  if (!open_) return;
  if (remembering_) history_.step(*open_).add(world_.end_change());
  open_.reset();
  history_.trim();
}

// Ends a step of the history of which nothing waits any more.
void Document::settle(size_t step) {
  const bool running = in_stroke_ && step + 1 == history_.position();
  if (running || !is_settled(world_) || (!work_.empty() && work_.front().step == step)) return;
  history_.step(step).done = true;
  if (open_ == step) close();
}

// Walks all moves that wait; what that changed is appended to `walked`.
Status Document::finish(Delta& walked, const Progress* progress) {
  const auto all = static_cast<double>(waiting());
  while (waiting() > 0) {
    const Progress going = share_of(progress, 1 - static_cast<double>(waiting()) / all, 1);
    Result<StepResult> done = step(waiting(), &going);
    if (!done) return done.error();
    walked.append(std::move(done->delta));
  }
  return Done{};
}

// History ---------------------------------------------------------------------------------------------------

void Document::queue(size_t step) {
  const HistoryStep& s = history_.step(step);
  const auto* again = std::get_if<Recut>(&s.commands.front());
  for (const Command& c : history_.step(base_of(step)).commands)
    run(step, c, again ? &again->settings : nullptr);
}

bool Document::can_recut() const {
  const auto last = last_cut();
  return !in_stroke_ && last && *last + 1 == history_.position() && can_go_before(*last);
}

// Whether what the stroke of a step did, cut again or not, is remembered.
bool Document::can_go_before(size_t last) const {
  for (size_t i = base_of(last); i <= last; ++i) {
    const HistoryStep& step = history_.step(i);
    if (step.begun && !step.remembered() && !(open_ == i && remembering_)) return false;
  }
  return true;
}

Result<Delta> Document::recut(const Recut& command) {
  if (!can_recut()) return Delta{};
  history_.append(HistoryStep(command));
  journal_.emplace_back(command);
  ++revision_;
  return cut_again();
}

// Of the last step: the world goes back to before the stroke as an edit of its own. A stroke of which moves
// wait is taken back for good: whoever undoes the recut has it walked again.
Delta Document::cut_again() {
  const size_t step = history_.position() - 1, before = step - 1;
  drop_work(before);
  if (open_ == before) close();
  Delta delta;
  if (!history_.step(before).done) {
    delta = history_.step(before).take_back(world_);
    history_.step(before).forget();
  }
  // Where nothing of the stroke was walked yet, an earlier one may wait, half-way through a move.
  if (history_.step(base_of(step)).begun) remember(step);
  for (size_t i = step; i-- > base_of(step);) {
    const Delta back = history_.step(i).restore(world_);
    history_.last().touch(back);
    delta.append(back);
  }
  queue(step);
  return delta;
}

// Has the moves of the last step walked as if they had just been drawn.
Delta Document::walk_again() {
  const size_t step = history_.position() - 1;
  if (base_of(step) != step) return cut_again();
  queue(step);
  return Delta{};
}

Result<Delta> Document::undo(const Progress* progress) {
  if (history_.position() == 0) return Delta{};
  const size_t last = history_.position() - 1;
  drop_work(last);
  if (open_ == last) close();
  HistoryStep& step = history_.step(last);
  if (step.begun && !step.remembered()) return replay(last, progress);
  Delta delta = step.take_back(world_);
  if (!step.done) step.forget();
  history_.back();
  const bool was_left = history_.position() > 0 && !history_.last().begun && !waits(history_.position() - 1);
  if (was_left) delta.append(walk_again());
  journal_.emplace_back(Undo{});
  ++revision_;
  return delta;
}

Result<Delta> Document::redo(const Progress* progress) {
  if (history_.position() == history_.size()) return Delta{};
  const size_t step = history_.position();
  HistoryStep& s = history_.step(step);
  Delta delta;
  if (s.remembered() && s.done && work_.empty()) {
    close();
    delta = s.bring_again(world_);
    history_.forth();
  } else if (cuts(step)) {
    if (base_of(step) != step && !can_go_before(step - 1)) return replay(step + 1, progress);
    s.forget();
    history_.forth();
    delta = walk_again();
  } else {
    Result<Delta> again = redo_at_once(step, progress);
    if (!again) return again;
    delta = std::move(*again);
  }
  journal_.emplace_back(Redo{});
  ++revision_;
  return delta;
}

// Does a command that has no moves to wait for, after those that wait, and remembers what it changed. Returns
// that; what the moves changed is appended to `walked`.
Result<Delta> Document::do_at_once(HistoryStep& step, Delta& walked, const Progress* progress) {
  const Status finished = finish(walked, progress);
  if (!finished) return finished.error();
  close();
  step.commands.front() = with_whole_id(world_, step.commands.front());
  const bool remembering = history_.window() > 0;
  if (remembering) world_.begin_change();
  Result<Delta> delta = run_at_once(world_, step.commands.front(), step.generation, progress);
  if (remembering) {
    World::Change change = world_.end_change();
    if (delta) step.add(std::move(change));
  }
  if (!delta) return delta;
  step.touch(*delta);
  step.begun = step.done = true;
  return delta;
}

Result<Delta> Document::at_once(const Command& command, const Progress* progress) {
  HistoryStep step(command);
  step.generation = static_cast<uint32_t>(journal_.size() + 1);
  Delta all;
  Result<Delta> delta = do_at_once(step, all, progress);
  if (!delta) return delta;
  const bool nothing = delta->empty();
  all.append(std::move(*delta));
  if (nothing) return all;
  assert(step.generation == journal_.size() + 1);
  journal_.push_back(step.commands.front());
  history_.append(std::move(step));
  history_.trim();
  return all;
}

Result<Delta> Document::redo_at_once(size_t at, const Progress* progress) {
  HistoryStep& step = history_.step(at);
  step.forget();
  history_.forget_behind(at);
  Delta all;
  Result<Delta> delta = do_at_once(step, all, progress);
  history_.trim();
  if (!delta) return delta;
  history_.forth();
  all.append(std::move(*delta));
  return all;
}

bool Document::remembers_way_to(size_t position) const {
  for (size_t i = position; i < history_.position(); ++i) {
    const HistoryStep& step = history_.step(i);
    if (step.begun && !step.remembered() && !(open_ == i && remembering_)) return false;
  }
  return true;
}

Result<Delta> Document::travel(size_t position, const Progress* progress) {
  end();
  position = std::min(position, history_.size());
  if (!remembers_way_to(position)) return replay(position, progress);
  Delta all;
  while (history_.position() != position) {
    Result<Delta> one = history_.position() > position ? undo(progress) : redo(progress);
    if (!one) return one;
    all.append(std::move(*one));
  }
  return all;
}

// Starts again from the origin. What is cut again right away need not be cut first.
Result<Delta> Document::replay(size_t position, const Progress* progress) {
  if (!origin_) return failed("what the world was then is no longer remembered");
  const Progress loading = share_of(progress, 0, 0.3);
  Result<World> origin = origin_(&loading);
  if (!origin) return origin.error();
  world_ = std::move(*origin);
  work_.clear();
  unfinished_ = UnfinishedMove{};
  open_.reset();
  ++revision_;
  const size_t before = history_.position(), written = journal_.size();
  while (history_.position() > 0) history_.back();
  for (size_t i = 0; i < history_.size(); ++i) history_.step(i).forget();
  Status done = Done{};
  while (done && history_.position() < position) {
    const size_t step = history_.position();
    const double share = 0.7 / static_cast<double>(position), from = 0.3 + share * static_cast<double>(step);
    const Progress walking = share_of(progress, from, from + share);
    if (!cuts(step)) {
      const Result<Delta> again = redo_at_once(step, &walking);
      if (!again) done = again.error();
      continue;
    }
    history_.forth();
    if (step + 1 < position && cuts(step + 1) && base_of(step + 1) != step + 1) continue;
    walk_again();
    Delta walked;  // all of the world is another one
    done = finish(walked, &walking);
  }
  journal_.erase(journal_.begin() + static_cast<std::ptrdiff_t>(written), journal_.end());
  for (size_t i = history_.position(); i < before; ++i) journal_.emplace_back(Undo{});
  for (size_t i = before; i < history_.position(); ++i) journal_.emplace_back(Redo{});
  if (!done) return done.error();
  Delta all;
  all.anew = true;
  return all;
}

}  // namespace kerf
