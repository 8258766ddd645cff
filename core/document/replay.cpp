#include "core/document/replay.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/physics/physics.h"
#include "core/world/world.h"

namespace kerf {

namespace {

// Returns true if a command may be part of a run after its first one.
bool goes_on(const Command& command) {
  return moves_bodies(command) || std::holds_alternative<DragBody>(command) ||
         std::holds_alternative<ReleaseBody>(command);
}

bool is_beam_on(const Command& command, bool before) {
  if (std::holds_alternative<BeginStroke>(command)) return true;
  const bool stays =
      std::holds_alternative<MoveBeam>(command) || std::holds_alternative<AdvanceTime>(command) ||
      std::holds_alternative<DragBody>(command) || std::holds_alternative<ReleaseBody>(command);
  return before && stays;
}

size_t end_of_run(const std::vector<Command>& commands, size_t first) {
  size_t end = first + 1;
  while (end < commands.size() && goes_on(commands[end])) ++end;
  return end;
}

// The last mark after `first` commands from which bodies continue to the bit.
std::optional<size_t> last_mark(const Journal& journal, size_t first, size_t end) {
  std::optional<size_t> last;
  for (size_t i = 0; i < journal.marks.size() && journal.marks[i].commands <= end; ++i) {
    const StateMark& mark = journal.marks[i];
    const bool whole_minute = mark.clock > 0 && mark.clock % CommandQueue::kTicksToForget == 0;
    if (mark.commands > first && !mark.bodies.empty() && (mark.commands == end || whole_minute)) last = i;
  }
  return last;
}

Ticks ticks_of(const std::vector<Command>& commands, size_t first, size_t end) {
  Ticks ticks = 0;
  for (size_t i = first; i < end; ++i) {
    if (const auto* advance = std::get_if<AdvanceTime>(&commands[i])) ticks += advance->ticks;
  }
  return ticks;
}

}  // namespace

std::vector<TimeSkip> time_skips(const Journal& journal, Ticks least) {
  std::vector<TimeSkip> skips;
  bool beam = false;
  for (size_t i = 0; i < journal.commands.size();) {
    const Command& command = journal.commands[i];
    beam = is_beam_on(command, beam);
    const bool begins = !beam && (std::holds_alternative<Play>(command) || goes_on(command));
    const size_t end = begins ? end_of_run(journal.commands, i) : i + 1;
    const std::optional<size_t> mark = begins ? last_mark(journal, i, end) : std::nullopt;
    const Ticks ticks = mark ? ticks_of(journal.commands, i, journal.marks[*mark].commands) : 0;
    if (mark && ticks >= std::max<Ticks>(least, 1)) skips.push_back({i, *mark, ticks});
    i = end;
  }
  return skips;
}

Document document_of(World world, const SceneDescription& scene) {
  return Document(std::move(world), [scene](const Progress* progress) -> Result<World> {
    auto again = load_scene(scene, progress);
    if (!again) return again.error();
    return std::move(again->world);
  });
}

double Replay::fraction() const {
  const size_t all = journal_.commands.size();
  return all > 0 ? static_cast<double>(next_) / static_cast<double>(all) : 1;
}

// Returns the end of the commands to apply before a stopped stroke is executed: a stroke waits for its
// StopStroke, if only its moves, its end and time precede that.
size_t Replay::end_of_stopped() {
  const auto goes_on = [](const Command& command) {
    return std::visit(Overloaded{
                          [](const MoveBeam&) { return true; },
                          [](const EndStroke&) { return true; },
                          [](const TimedCommand auto&) { return true; },
                          [](const auto&) { return false; },
                      },
                      command);
  };
  end_of_moves_ = std::max(end_of_moves_, next_ + 1);
  while (end_of_moves_ < journal_.commands.size() && goes_on(journal_.commands[end_of_moves_]))
    ++end_of_moves_;
  return is_a<StopStroke>(end_of_moves_) ? end_of_moves_ + 1 : next_ + 1;
}

// Strokes and recuts that are undone directly afterwards are not executed either, unless a mark records their
// result: they may have been given up because they exceeded the face budget.
size_t Replay::end_of_undone() {
  if (next_ >= cuts_end_) find_undone();
  return next_ == undone_begin_ ? undone_end_ : next_ + 1;
}

// Finds the strokes and recuts that begin at the next command and follow each other, and which of them are
// undone behind the last.
void Replay::find_undone() {
  std::vector<size_t> begins;
  size_t end = next_;
  while (is_a<BeginStroke>(end) || is_a<Recut>(end)) {
    begins.push_back(end++);
    while (is_a<MoveBeam>(end)) ++end;
    if (is_a<EndStroke>(end)) ++end;
  }
  cuts_end_ = undone_begin_ = undone_end_ = end;
  if (begins.empty()) return;
  size_t first = begins.size(), mark = next_mark_;
  while (first > 0 && is_a<Undo>(end + begins.size() - first)) --first;
  for (; mark < journal_.marks.size() && journal_.marks[mark].commands <= end; ++mark) {
    while (first < begins.size() && begins[first] < journal_.marks[mark].commands) ++first;
  }
  const size_t behind = end + begins.size() - first;
  const bool marked = mark < journal_.marks.size() && journal_.marks[mark].commands < behind;
  if (first == begins.size() || marked) return;
  undone_begin_ = begins[first];
  undone_end_ = behind;
}

// Reports the changes of an immediate command; the work of a queued one is reported by its steps.
Status Replay::report(const QueueRun& how, Outcome outcome) const {
  if (!how.told) return outcome.ok() ? Status(Done{}) : Status(outcome.error());
  if (!outcome.ok()) return how.told(outcome.error());
  if (outcome.delta.empty() && document_.waiting() > 0) return Done{};
  StepResult result;
  result.delta = std::move(outcome.delta);
  return how.told(std::move(result));
}

Status Replay::next(const QueueRun& how) {
  KERF_ASSERT(!done());
  compare();
  while (next_skip_ < skips_.size() && skips_[next_skip_].first < next_) ++next_skip_;
  if (next_skip_ < skips_.size() && skips_[next_skip_].first == next_) return skip(how, skips_[next_skip_]);
  const size_t end = next_ < journal_.commands.size() ? std::max(end_of_stopped(), end_of_undone()) : next_;
  while (next_ < end) {
    const bool adds_mesh = is_a<AddMesh>(next_);
    Outcome outcome = document_.apply(journal_.commands[next_++], how.progress);
    document_.seal_journal();  // to keep the commands and their indices equal
    // Without the mesh, later commands would undo other steps and concern other bodies.
    if (adds_mesh && !outcome.ok()) return outcome.error();
    if (const Status status = report(how, std::move(outcome)); !status) return status;
  }
  const Status ran = run_queue(document_, how);
  compare();
  return ran;
}

// Does not skip the first tick, in which separated pieces become bodies.
Status Replay::skip(const QueueRun& how, const TimeSkip& skip) {
  const StateMark& mark = journal_.marks[skip.mark];
  while (next_ < mark.commands) {
    (void)document_.apply(journal_.commands[next_++]);  // only queues it
    document_.seal_journal();
  }
  const Ticks before = document_.world().clock();
  const auto report_step = [&](const Result<StepResult>& step) -> Status {
    if (how.told) return how.told(step);
    return step ? Status(Done{}) : Status(step.error());
  };
  while (document_.waiting() > 0 && document_.world().clock() == before) {
    if (const Status told = report_step(document_.step(1, how.progress)); !told) return told;
  }
  const Status told = report_step(document_.set_states(mark.bodies, mark.pairs));
  skipped_ += skip.ticks;
  compare();
  return told;
}

Status Replay::run(const QueueRun& how) {
  const Progress watched{[&](double) { return !how.progress || how.progress->report(fraction()); }};
  QueueRun each = how;
  each.progress = &watched;
  while (!done()) {
    if (!watched.report(0)) return cancelled();
    if (const Status status = next(each); !status) return status;
  }
  // `told` accepts the failure of a last command that was stopped.
  return watched.report(1) ? Status(Done{}) : cancelled();
}

// Compares the world with the marks at the current command, if nothing is queued.
void Replay::compare() {
  for (; document_.waiting() == 0 && next_mark_ < journal_.marks.size() &&
         journal_.marks[next_mark_].commands <= next_;
       ++next_mark_) {
    const StateMark& mark = journal_.marks[next_mark_];
    if (mark.looks && mark.commands == next_)
      looks_differ_ = looks_differ_ || mark.looks != looks_hash(document_.world());
    if (difference_ || mark.commands < next_) continue;
    uint64_t hash = state_hash(document_.world());
    if (hash != mark.hash && takes_bodies(mark)) hash = state_hash(document_.world());
    if (hash == mark.hash) continue;
    if (other_machine_.empty()) {
      difference_ = Difference{mark, hash};
    } else {
      cut_otherwise_ = true;
    }
  }
}

// Bodies move differently in the last bits on another kind of machine. Before the first history step, and
// after all were undone, none has moved.
bool Replay::takes_bodies(const StateMark& mark) {
  if (mark.bodies.empty() || mark.machine == machine_kind()) return false;
  if (document_.history().position() == 0) return false;
  other_machine_ = mark.machine;
  document_.set_states(mark.bodies, mark.pairs);
  return true;
}

}  // namespace kerf
