#include "ui/editor/shared/world_changes.h"

#include <algorithm>
#include <chrono>
#include <variant>

#include "core/base/assert.h"
#include "core/cut/cut_step.h"
#include "core/document/commands.h"
#include "core/document/extract.h"
#include "core/document/text/fields.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/workspace.h"
#include "ui/render/view/view_options.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces = 40'000;  // changes of bodies with more faces take longer than a part of a frame
constexpr size_t kManyMoves = 20;      // of the queue, which take longer than a part of a frame

constexpr size_t kMovesOfStep = 16;

// Prepares render data of the new bodies or, if the world was replaced, of all bodies.
PreparedBodies prepare(const World& world, const Delta& delta, const LoadedShadings& loaded) {
  PreparedBodies prepared;
  for (const BodyId id : delta.replaced ? world.ids() : delta.created)
    prepared.emplace(id, prepare_shading(world.body(id), loaded));
  (void)prepare_shadows(world, prepared, nullptr);  // is never stopped
  return prepared;
}

// Returns true if redo, or a recut in progress, may bring back missing pieces.
bool pieces_may_return(const UndoStack& history) {
  if (history.size() > history.position()) return true;
  return history.position() > 0 && history.last().kind() == HistoryStep::Kind::kRecut;
}

// Returns true if a beam touches a body, or if there are commands other than those of strokes.
bool may_cut(std::span<const Command> commands, const World& world) {
  Laser laser;
  Pose at;
  return std::any_of(commands.begin(), commands.end(), [&](const Command& command) {
    if (const auto* begin = std::get_if<BeginStroke>(&command)) {
      laser = begin->settings.laser;
      at = begin->pose;
      return hits_anything(world, laser, at);
    }
    const auto* move = std::get_if<MoveBeam>(&command);
    if (move == nullptr) return !std::holds_alternative<EndStroke>(command);
    return hits_anything(world, laser, BeamMove{std::exchange(at, move->pose), move->pose, 0});
  });
}

}  // namespace

ChangeThread::~ChangeThread() {
  if (job_) stop();
}

void ChangeThread::start(Document& document, LongChange change) {
  KERF_ASSERT(!busy() && change.run && change.then);
  job_ = std::make_unique<Job>();
  job_->change = std::move(change);
  job_->result = std::async(std::launch::async, [job = job_.get(), &document] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      job->told = true;
      return !job->stopped;
    }};
    return job->change.run(document, progress);
  });
}

bool ChangeThread::is_over(double seconds) const {
  KERF_ASSERT(busy());
  return job_->result.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

void ChangeThread::finish() {
  KERF_ASSERT(busy());
  const std::unique_ptr<Job> job = std::move(job_);
  const Outcome result = job->result.get();
  job->change.then(result);
}

bool is_small(const Document& document) { return document.world().live_faces() <= kManyFaces; }

bool is_quick(const Document& document, const Command& command) {
  const bool small = is_small(document);
  const size_t now = document.history().position();
  return std::visit(
      Overloaded{
          [](const BeginStroke&) { return true; },
          [](const MoveBeam&) { return true; },
          [](const EndStroke&) { return true; },
          [&](const StopStroke&) { return document.queue().stop_here().has_value(); },
          [](const Recut&) { return true; },
          [](const TimedCommand auto&) { return true; },
          [](const Play&) { return true; },
          [&](const Undo&) { return small && (now == 0 || document.history().holds_images(now - 1, now)); },
          [&](const Redo&) { return small; },
          [](const AddMesh&) { return false; },
          [&](const ImmediateCommand auto&) { return small && document.waiting() <= kManyMoves; },
      },
      command);
}

const char* background_reason(const Document& document) {
  return document.queue().next_prepared_faces() > kManyFaces ? "Creating bodies of the pieces" : nullptr;
}

// Any command other than Undo and Redo may replace the steps that are undone at that time; `position` is
// then the minimum position of the history.
void StepGroups::follow(const Document& document) {
  const std::vector<Command>& journal = document.journal();
  size_t position = position_, kept = document.history().size();
  if (journal.size() < commands_) kept = std::min(kept, document.history().position());
  for (size_t i = std::min(commands_, journal.size()); i < journal.size(); ++i) {
    if (std::holds_alternative<Undo>(journal[i])) {
      position -= std::min<size_t>(position, 1);
    } else if (std::holds_alternative<Redo>(journal[i])) {
      ++position;
    } else {
      kept = std::min(kept, position);
    }
  }
  std::erase_if(groups_, [&](const Group& group) { return group.to > kept; });
  position_ = document.history().position();
  commands_ = journal.size();
}

void StepGroups::add(size_t from, const Document& document, std::string name) {
  follow(document);
  const size_t to = document.history().position();
  if (to > from + 1) groups_.push_back({from, to, std::move(name)});
}

void StepGroups::mark(Document& document, std::vector<StateMark>& marks) {
  if (document.queue().in_stroke() || document.waiting() > 0) return;
  for (Group& group : groups_) {
    if (std::exchange(group.is_marked, true)) continue;
    mark_group(document, marks, group.from, group.to, group.name);
  }
}

void StepGroups::restore(const Document& document, std::span<const StateMark> marks) {
  const std::vector<Command>& journal = document.journal();
  std::vector<HistoryStep::Kind> kinds;  // of the steps up to the position, and of those that are undone
  size_t position = 0;
  groups_.clear();
  for (size_t i = 0; i <= journal.size(); ++i) {
    for (; !marks.empty() && marks.front().commands <= i; marks = marks.subspan(1)) {
      const StateMark& mark = marks.front();
      if (mark.group_from < mark.group_to && mark.group_to <= kinds.size())
        groups_.push_back({mark.group_from, mark.group_to, mark.group, true});
    }
    if (i == journal.size()) break;
    if (std::holds_alternative<Undo>(journal[i])) {
      position -= std::min<size_t>(position, 1);
    } else if (std::holds_alternative<Redo>(journal[i])) {
      position = std::min(position + 1, kinds.size());
    } else {
      std::erase_if(groups_, [&](const Group& group) { return group.to > position; });
      const auto last = position > 0 ? std::optional(kinds[position - 1]) : std::nullopt;
      if (const auto kind = history_step_kind(journal[i], last)) {
        kinds.resize(position++);
        kinds.push_back(*kind);
      }
    }
  }
  position_ = document.history().position();
  commands_ = journal.size();
  if (position != position_) groups_.clear();  // the journal was edited
}

bool StepGroups::has_row(size_t position) const {
  return std::none_of(groups_.begin(), groups_.end(),
                      [&](const Group& g) { return g.from < position && position < g.to; });
}

const StepGroups::Group* StepGroups::at(size_t position, bool back) const {
  const auto group = std::find_if(groups_.begin(), groups_.end(),
                                  [&](const Group& g) { return position == (back ? g.to : g.from); });
  return group != groups_.end() ? &*group : nullptr;
}

WorldChanges::Change apply_all(std::vector<Command> commands) {
  return [commands = std::move(commands)](Document& document, const Progress* progress) {
    Outcome all;
    for (size_t i = 0; i < commands.size() && all.ok(); ++i)
      all.append(document.apply(commands[i], progress));
    return all;
  };
}

WorldChanges::Change cut_along(std::vector<Command> commands, std::string what) {
  return
      [commands = std::move(commands), what = std::move(what)](Document& document, const Progress* progress) {
        const size_t before = document.history().position();
        Outcome outcome;
        if (may_cut(commands, document.world())) outcome = document.run_whole(commands, progress);
        if (!outcome.ok() && outcome.error().message == cancelled().message)
          outcome.fail(failed(what + " stopped; nothing was cut."));
        if (outcome.ok() && document.history().position() == before)
          outcome.fail(failed(what + " meets no surface."));
        return outcome;
      };
}

WorldChanges::Change edit_all(std::vector<PieceId> pieces,
                              std::function<Command(const PieceId&)> command_for) {
  return [pieces = std::move(pieces), command_for = std::move(command_for)](
             Document& document, const Progress* progress) mutable {
    Outcome all;
    for (size_t i = 0; i < pieces.size() && all.ok(); ++i) {
      Outcome one = document.apply(command_for(pieces[i]), progress);
      for (PieceId& piece : pieces) piece = named_after(one.delta, piece);
      all.append(std::move(one));
    }
    return all;
  };
}

Renderer& WorldChanges::renderer() const {
  KERF_ASSERT(workspace_.screen.picture != nullptr);
  return workspace_.screen.picture->first();
}

// The queue
// --------------------------------------------------------------------------------------------------------

void WorldChanges::enqueue(Request change) {
  KERF_ASSERT(change.run);
  std::erase_if(requests_, [&](const Request& a) {
    return !a.has_begun && !change.name.empty() && a.name == change.name;
  });
  requests_.push_back(std::move(change));
}

void WorldChanges::enqueue(std::string name, const std::function<void()>& run) {
  enqueue({std::move(name), [run] {
             run();
             return true;
           }});
}

void WorldChanges::enqueue(const Command& command) {
  enqueue("", [this, command] { apply(command); });
}

void WorldChanges::process_requests() {
  DocumentSession& session = workspace_.session;
  groups_.follow(session.document);
  if (!pending_) groups_.mark(session.document, session.marks);
  for (size_t left = requests_.size(); left > 0 && !requests_.empty() && !pending_; --left) {
    Request next = std::move(requests_.front());
    requests_.pop_front();
    if (!next.always && workspace_.opening.loader.busy()) continue;  // the document is about to be replaced
    if (next.is_one && !group_) group_ = {workspace_.session.document.history().position(), next.name};
    if (!next.run()) {
      next.has_begun = true;
      requests_.push_front(std::move(next));
      return;
    }
    end_group();
  }
}

// Ends the group when its change is complete.
void WorldChanges::end_group() {
  if (!group_ || pending_) return;
  groups_.add(group_->from, workspace_.session.document, group_->name);
  group_.reset();
}

void WorldChanges::end_pending() {
  const bool goes_on = group_ && !requests_.empty() && requests_.front().name == group_->name;
  if (!goes_on) end_group();
  workspace_.view.picture_old = true;
}

void WorldChanges::begin(LongChange reading) {
  KERF_ASSERT(!pending_);
  pending_ = std::move(reading);
}

void WorldChanges::forget() {
  groups_.restore(workspace_.session.document, workspace_.session.marks);
  group_.reset();
  pending_.reset();
  pending_message_.clear();
  std::erase_if(requests_, [](const Request& a) { return !a.always; });
}

// Commands
// --------------------------------------------------------------------------------------------------------

void WorldChanges::apply(const Command& command) {
  change(command_label(command, workspace_.view.frame.unit), is_quick(workspace_.session.document, command),
         [command](Document& d, const Progress* progress) { return d.apply(command, progress); });
}

void WorldChanges::travel_to(size_t position, const std::string& title, const std::string& message) {
  const Document& document = workspace_.session.document;
  const UndoStack& history = document.history();
  change(
      title, is_small(document) && history.holds_images(position, history.position()),
      [position](Document& d, const Progress* progress) { return d.travel(position, progress); }, message);
}

void WorldChanges::step_through_history(bool back) {
  const Document& document = workspace_.session.document;
  const std::string did = back ? "Undo: " : "Redo: ";
  groups_.follow(document);
  const StepGroups::Group* group = groups_.at(document.history().position(), back);
  cancel_stroke(workspace_);
  if (group != nullptr)
    return travel_to(back ? group->from : group->to, did + group->name, did + group->name);
  const UndoStack& history = document.history();
  const bool there_is_one = back ? history.position() > 0 : history.position() < history.size();
  std::string message;
  if (there_is_one) {
    const size_t step = back ? history.position() - 1 : history.position();
    message = did + step_words(history, step, workspace_.view.frame.unit);
  }
  const Command command = back ? Command(Undo{}) : Command(Redo{});
  change(
      command_label(command, workspace_.view.frame.unit), is_quick(document, command),
      [command](Document& d, const Progress* progress) { return d.apply(command, progress); }, message);
}

// Makes a quick change at once, any other in the background.
void WorldChanges::change(const std::string& title, bool quick, const Change& what,
                          const std::string& message) {
  KERF_ASSERT(!pending_);
  workspace_.message.clear();
  if (!pending_message_.empty()) workspace_.message.note(std::exchange(pending_message_, ""), false);
  if (quick) return show_outcome(what(workspace_.session.document, nullptr), {}, message);
  const auto prepared = std::make_shared<PreparedBodies>();
  LongChange change;
  change.title = title;
  change.run = [what, prepared, loaded = renderer().loaded_shadings()](Document& document,
                                                                       const Progress& progress) {
    Outcome outcome = what(document, &progress);
    *prepared = prepare(document.world(), outcome.delta, loaded);
    return outcome;
  };
  change.then = [this, prepared, message](const Outcome& outcome) {
    show_outcome(outcome, std::move(*prepared), message);
  };
  pending_ = std::move(change);
}

// Steps of a cut
// --------------------------------------------------------------------------------------------------------

bool WorldChanges::step(const Part& part) {
  KERF_ASSERT(!pending_);
  if (run_in_background(part)) return false;
  const Result<StepResult> step = part(workspace_.session.document);
  if (!step) {
    show_failed_step(step.error());
    return false;
  }
  follow_step(*step);
  return true;
}

bool WorldChanges::can_cut() const {
  return workspace_.session.document.waiting() > 0 && !workspace_.links.holds_back();
}

void WorldChanges::cut() {
  const Document& document = workspace_.session.document;
  if (!can_cut() || pending_) return;
  const double began = workspace_.screen.clock->seconds();
  const bool cools = document.queue().only_cools(),
             beam = workspace_.beam.cutting() || document.queue().pending().holds_beam();
  while (can_cut() && workspace_.screen.clock->seconds() < workspace_.screen.cut_until) {
    if (!step([](Document& d) { return d.step(kMovesOfStep); })) break;
  }
  if (beam) workspace_.beam.find_impact(document);
  if (workspace_.view.spread > 0)
    spread_pieces(document.world(), workspace_.view.spread, workspace_.view.look);
  workspace_.screen.cut_seconds += workspace_.screen.clock->seconds() - began;
  if (!cools) workspace_.view.picture_old = true;
  if (cools && !workspace_.links.cools_unseen) workspace_.view.heat_old = true;
  workspace_.services.statistics.world_changed = true;
}

bool WorldChanges::run_in_background(const Part& part) {
  const char* title = background_reason(workspace_.session.document);
  if (title == nullptr) return false;
  const auto step = std::make_shared<StepResult>();
  const auto prepared = std::make_shared<PreparedBodies>();
  LongChange change;
  change.title = title;
  change.run = [step, prepared, part, loaded = renderer().loaded_shadings()](Document& document,
                                                                             const Progress&) {
    Result<StepResult> done = part(document);
    Outcome outcome;
    if (!done) outcome.fail(done.error());
    if (!done) return outcome;
    *prepared = prepare(document.world(), done->delta, loaded);
    *step = std::move(*done);
    return outcome;
  };
  change.then = [this, step, prepared](const Outcome& done) {
    if (!done.ok()) return show_failed_step(done.error());
    follow_step(*step, std::move(*prepared));
    workspace_.services.statistics.world_changed = true;
  };
  pending_ = std::move(change);
  return true;
}

void WorldChanges::follow_step(const StepResult& step, PreparedBodies prepared) {
  if (step.last) workspace_.beam.reach(step.last->to);
  renderer().follow(workspace_.world(), step.delta, std::move(prepared));
  if (workspace_.view.look.ghost || workspace_.view.look.show.face_numbers)
    renderer().send_faces(workspace_.world());
  follow_released(step.delta);
  if (step.delta.removed_faces > 0) {
    std::erase_if(workspace_.view.look.pieces,
                  [&](const auto& entry) { return !has_faces(workspace_.world(), entry.first); });
  }
  const bool created = std::any_of(step.delta.bodies.begin(), step.delta.bodies.end(),
                                   [](const BodyDelta& body) { return !body.new_pieces.empty(); });
  if (created || workspace_.view.numbers.waits()) {
    workspace_.view.numbers.follow(workspace_.world(), false,
                                   pieces_may_return(workspace_.session.document.history()),
                                   workspace_.view.look.pieces);
  }
  workspace_.services.statistics.chart.record_step(step);
  report_left_open(step.delta);
}

// Reports solid bodies that a stroke left open: shows the first, and logs all.
void WorldChanges::report_left_open(const Delta& delta) {
  const auto text = [this](const LeftOpen& open) {
    return left_open_text(open, workspace_.world(), workspace_.view.frame.unit);
  };
  for (size_t i = delta.left_open.size(); i-- > 1;) workspace_.message.note(text(delta.left_open[i]), true);
  if (!delta.left_open.empty()) workspace_.message.error(text(delta.left_open.front()));
}

// Pieces that came off become bodies when time passes.
void WorldChanges::follow_released(const Delta& delta) {
  if (delta.created.empty() && delta.detached.empty()) return;
  const World& world = workspace_.world();
  ViewOptions& look = workspace_.view.look;
  follow_world(world, delta, look.pieces);
  workspace_.view.numbers.follow(world, false, pieces_may_return(workspace_.session.document.history()),
                                 look.pieces);
  followed(delta);
}

// The stroke was undone, with the pieces that it had cut off.
void WorldChanges::show_failed_step(const Error& error) {
  pending_message_.clear();  // it would state a success
  cancel_stroke(workspace_);
  Delta all;
  all.replaced = true;
  show_change(all, {});
  workspace_.message.error(error.message);
}

// Viewport
// --------------------------------------------------------------------------------------------------------

void WorldChanges::show_outcome(const Outcome& outcome, PreparedBodies prepared, const std::string& message) {
  show_change(outcome.delta, std::move(prepared));
  if (!outcome.ok()) {
    workspace_.message.error(outcome.error().message);
  } else {
    pending_message_ = message;
    report_done();
    report_left_open(outcome.delta);
  }
}

void WorldChanges::report_done() {
  if (pending_message_.empty() || workspace_.session.document.queue().pending().holds_beam()) return;
  workspace_.message.info(std::exchange(pending_message_, ""));
}

void WorldChanges::show_change(const Delta& delta, PreparedBodies prepared) {
  const World& world = workspace_.world();
  renderer().follow(world, delta, std::move(prepared));
  ViewOptions& look = workspace_.view.look;
  follow_world(world, delta, look.pieces);
  workspace_.view.numbers.follow(world, true, pieces_may_return(workspace_.session.document.history()),
                                 look.pieces);
  if (workspace_.view.spread > 0) spread_pieces(world, workspace_.view.spread, look);
  followed(delta);
  workspace_.view.picture_old = workspace_.services.statistics.world_changed = true;
}

void WorldChanges::show_world(const World& world, Renderer& renderer) const {
  if (workspace_.session.as_loaded) {
    renderer.show(*workspace_.session.as_loaded, workspace_.session.paints);
    renderer.resend(world);
  } else {
    renderer.show(world, workspace_.session.paints);
  }
}

}  // namespace kerf
