#include "ui/editor/changes/world_changes.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/document/command_words.h"
#include "core/document/stop_strokes.h"
#include "ui/editor/changes/long_step.h"
#include "ui/editor/changes/prepare_pieces.h"
#include "ui/editor/view/piece_set.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {

// What pictures need of the bodies that came or, where the world was replaced, of all of them.
PreparedBodies prepare(const World& world, const Delta& delta, const LoadedShadings& loaded) {
  PreparedBodies prepared;
  for (const BodyId id : delta.anew ? world.ids() : delta.came)
    prepared.emplace(id, prepare_shading(world.body(id), loaded));
  (void)prepare_shadows(world, prepared, nullptr);  // nobody stops it
  return prepared;
}

// Whether redo, or a recut that is being walked, may bring back pieces that are not there.
bool pieces_may_return(const History& history) {
  if (history.size() > history.position()) return true;
  return history.position() > 0 && history.last().kind() == HistoryStep::Kind::kRecut;
}

auto apply_all(std::vector<Command> commands) {
  return [commands = std::move(commands)](Document& document, const Progress* progress) {
    Outcome all;
    for (size_t i = 0; i < commands.size() && all.ok(); ++i)
      all.append(document.apply(commands[i], progress));
    return all;
  };
}

std::vector<BodyId> hidden_bodies(const World& world) {
  std::vector<BodyId> hidden;
  for (const BodyId id : world.ids()) {
    if (world.body(id).hidden) hidden.push_back(id);
  }
  return hidden;
}

// Applies a command to pieces one after the other, because a piece may be part of another body after a
// command.
template <typename Make>
Outcome edit_all(Document& document, std::vector<PieceId> pieces, Make command_for,
                 const Progress* progress) {
  Outcome all;
  for (size_t i = 0; i < pieces.size() && all.ok(); ++i) {
    Outcome one = document.apply(command_for(pieces[i]), progress);
    for (PieceId& piece : pieces) piece = named_after(one.delta, piece);
    all.append(std::move(one));
  }
  return all;
}

// The pieces that were hidden because others were isolated, and still are.
std::vector<PieceId> to_show_again(const World& world, const ViewState& view) {
  std::vector<PieceId> pieces;
  for (const PieceId& piece : hidden_pieces(view.look.pieces)) {
    const std::vector<BodyId>& bodies = view.isolated_from;
    if (world.contains(piece.body) && std::find(bodies.begin(), bodies.end(), piece.body) != bodies.end())
      pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

const char* why_no_isolation(const World& world, const ViewState& view) {
  if (!to_show_again(world, view).empty()) return nullptr;
  if (const char* why = why_none_chosen(view.look.pieces)) return why;
  return other_pieces(world, view.look.pieces).empty() ? "All pieces are chosen." : nullptr;
}

const char* why_no_recut(const Document& document) {
  if (!document.has_stroke()) return "Nothing is cut yet.";
  if (document.in_stroke()) return "A stroke is being cut.";
  if (!document.can_recut()) return "What was before the last stroke is no longer remembered.";
  return nullptr;
}

// Commands
// --------------------------------------------------------------------------------------------------------

void WorldChanges::apply(const Command& command) {
  change(words(command), is_quick(on_.work.document, command),
         [command](Document& d, const Progress* progress) { return d.apply(command, progress); });
}

void WorldChanges::travel_to(size_t position, const std::string& said) {
  const Document& document = on_.work.document;
  change(
      "Through the history", is_small(document) && document.remembers_way_to(position),
      [position](Document& d, const Progress* progress) { return d.travel(position, progress); }, said);
}

void WorldChanges::step_through_history(bool back) {
  cancel_stroke(on_.hand, on_.work.document);
  const History& history = on_.work.document.history();
  const bool there_is_one = back ? history.position() > 0 : history.position() < history.size();
  std::string said;
  if (there_is_one) {
    const HistoryStep& step = back ? history.last() : history.step(history.position());
    said = (back ? "Undone: " : "Done again: ") + words(step.commands().front());
  }
  const Command command = back ? Command(Undo{}) : Command(Redo{});
  change(
      words(command), is_quick(on_.work.document, command),
      [command](Document& d, const Progress* progress) { return d.apply(command, progress); }, said);
}

// One after the other, because a piece may be part of another body after a command.
template <typename Make>
bool WorldChanges::change_chosen(Make command_for) {
  while (const auto piece = first_chosen(on_.view.look.pieces)) {
    if (pending_) return true;
    on_.view.look.pieces[*piece].selected = false;
    apply(command_for(*piece));
  }
  return false;
}

bool WorldChanges::hide_chosen() {
  return change_chosen([](const PieceId& piece) { return Command(HidePiece{piece, true}); });
}

bool WorldChanges::delete_chosen() {
  return change_chosen([](const PieceId& piece) { return Command(DeletePiece{piece}); });
}

void WorldChanges::pin_chosen(bool pinned) {
  std::vector<PieceId> pieces;
  for (const auto& [id, look] : on_.view.look.pieces) {
    if (look.selected) pieces.push_back(id);
  }
  cancel_stroke(on_.hand, on_.work.document);
  change(pinned ? "Pin pieces" : "Unpin pieces", is_small(on_.work.document),
         [pieces, pinned](Document& document, const Progress* progress) {
           return edit_all(
               document, pieces,
               [pinned](const PieceId& piece) {
                 return PinPiece{piece, pinned};
               },
               progress);
         });
}

void WorldChanges::set_sheet(const Sheet& sheet) {
  std::vector<PieceId> pieces;
  const bool all = chosen_pieces(on_.view.look.pieces) == 0;
  for (const PieceRow& row : list_pieces(on_.work.document.world(), on_.view.look.pieces)) {
    const auto look = on_.view.look.pieces.find(row.id);
    const bool chosen = look != on_.view.look.pieces.end() && look->second.selected;
    if (!row.part && (all || chosen)) pieces.push_back(row.id);
  }
  cancel_stroke(on_.hand, on_.work.document);
  change("Set the material", is_small(on_.work.document),
         [pieces, sheet](Document& document, const Progress* progress) {
           return edit_all(
               document, pieces,
               [sheet](const PieceId& piece) {
                 return SetSheet{piece, sheet};
               },
               progress);
         });
}

void WorldChanges::prepare_chosen(const Preparation& preparation) {
  const std::vector<PieceRow> pieces = pieces_to_prepare(on_.work.document.world(), on_.view.look.pieces);
  cancel_stroke(on_.hand, on_.work.document);
  const FaceForecast faces = forecast(pieces, preparation);
  const bool quick = std::max(faces.before, faces.after.value_or(0)) <= kQuickToPrepare;
  change(preparation_title(preparation.tool), quick,
         [pieces, preparation](Document& d, const Progress* progress) {
           return prepare_pieces(d, pieces, preparation, progress);
         });
}

void WorldChanges::duplicate_chosen() {
  KERF_ASSERT(chosen_pieces(on_.view.look.pieces) > 0);
  const PieceId piece = *first_chosen(on_.view.look.pieces);
  const World& world = on_.work.document.world();
  on_.hand.newest_before_copy = world.ids().back();
  apply(DuplicatePiece{piece, world.body(piece.body).placement});
}

// Hidden pieces are bodies of their own, so that no id changes when one of them is shown.
void WorldChanges::show_hidden() {
  std::vector<Command> commands;
  for (const PieceId& piece : hidden_pieces(on_.view.look.pieces))
    commands.emplace_back(HidePiece{piece, false});
  change("Show all pieces", is_small(on_.work.document), apply_all(std::move(commands)));
}

void WorldChanges::isolate_chosen() {
  const World& world = on_.work.document.world();
  std::vector<PieceId> pieces = to_show_again(world, on_.view);
  const bool hide = pieces.empty();
  if (hide) {
    pieces = other_pieces(world, on_.view.look.pieces);
    hidden_before_ = hidden_bodies(world);
  }
  cancel_stroke(on_.hand, on_.work.document);
  change(hide ? "Isolate pieces" : "Show the other pieces", is_small(on_.work.document),
         [pieces, hide](Document& document, const Progress* progress) {
           return edit_all(
               document, pieces,
               [hide](const PieceId& piece) {
                 return HidePiece{piece, hide};
               },
               progress);
         });
}

void WorldChanges::recut_last_stroke(bool radius) {
  const Document& document = on_.work.document;
  if (why_no_recut(document) != nullptr) return;
  CutSettings settings = document.stroke_settings();
  if (radius) settings.laser.radius = on_.hand.laser.radius;
  settings.resolution = on_.hand.laser.resolution.of(settings.laser.radius);
  std::vector<Command> commands;
  const HistoryStep& last = document.history().last();
  const bool again = last.kind() == HistoryStep::Kind::kRecut;
  if (again) commands.emplace_back(Undo{});
  commands.emplace_back(Recut{settings});
  // The time that passed after the recut that is undone passes again.
  if (again) commands.insert(commands.end(), last.commands().begin() + 1, last.commands().end());
  change("Cut again", true, apply_all(std::move(commands)));
  ++on_.figures.recuts;
}

void WorldChanges::stop_cutting() {
  cancel_stroke(on_.hand, on_.work.document);
  change(
      "Stop cutting", true, [](Document& document, const Progress*) { return stop_strokes(document); },
      "Stopped: the stroke ends here. Undo takes it back.");
}

void WorldChanges::run_path(std::vector<Command> commands) {
  const auto run = [commands = std::move(commands)](Document& document, const Progress* progress) {
    Outcome outcome = document.run_whole(commands, progress);
    if (!outcome.ok() && outcome.error().message == cancelled().message)
      outcome.fail(failed("The path was stopped: nothing was cut."));
    return outcome;
  };
  change("Cutting the path", false, run, "The path is cut.");
}

// A quick change is done at once, another beside the frames.
void WorldChanges::change(const std::string& title, bool quick, const Change& what, const std::string& said) {
  KERF_ASSERT(!pending_);
  on_.message.say("");
  said_later_.clear();
  if (quick) return show_outcome(what(on_.work.document, nullptr), {}, said);
  const auto prepared = std::make_shared<PreparedBodies>();
  LongChange change;
  change.title = title;
  change.run = [what, prepared, loaded = on_.renderer.loaded_shadings()](Document& document,
                                                                         const Progress& progress) {
    Outcome outcome = what(document, &progress);
    *prepared = prepare(document.world(), outcome.delta, loaded);
    return outcome;
  };
  change.then = [this, prepared, said](const Outcome& outcome) {
    show_outcome(outcome, std::move(*prepared), said);
  };
  pending_ = std::move(change);
}

// Steps of a cut
// --------------------------------------------------------------------------------------------------------

bool WorldChanges::step(const Part& part) {
  KERF_ASSERT(!pending_);
  if (do_beside(part)) return false;
  const Result<StepResult> step = part(on_.work.document);
  if (!step) {
    show_failed_step(step.error());
    return false;
  }
  follow_step(*step);
  return true;
}

bool WorldChanges::do_beside(const Part& part) {
  const char* title = why_beside(on_.work.document);
  if (title == nullptr) return false;
  const auto step = std::make_shared<StepResult>();
  const auto prepared = std::make_shared<PreparedBodies>();
  LongChange change;
  change.title = title;
  change.run = [step, prepared, part, loaded = on_.renderer.loaded_shadings()](Document& document,
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
    on_.figures.world_changed = true;
  };
  pending_ = std::move(change);
  return true;
}

void WorldChanges::follow_step(const StepResult& step, PreparedBodies prepared) {
  if (step.last) on_.hand.beam.reach(step.last->to);
  on_.renderer.follow(on_.work.document.world(), step.delta, std::move(prepared));
  if (on_.view.look.ghost || on_.view.look.show.face_numbers)
    on_.renderer.catch_up(on_.work.document.world());
  follow_released(step.delta);
  const bool came = std::any_of(step.delta.bodies.begin(), step.delta.bodies.end(),
                                [](const BodyDelta& body) { return !body.new_pieces.empty(); });
  if (came || on_.view.numbers.waits()) {
    on_.view.numbers.follow(on_.work.document.world(), false, pieces_may_return(on_.work.document.history()),
                            on_.view.look.pieces);
  }
  on_.figures.chart.note_step(step);
}

// Pieces that came off become bodies when time passes.
void WorldChanges::follow_released(const Delta& delta) {
  if (delta.came.empty() && delta.detached.empty()) return;
  const World& world = on_.work.document.world();
  ViewOptions& look = on_.view.look;
  follow_world(world, delta, look.pieces);
  on_.view.numbers.follow(world, false, pieces_may_return(on_.work.document.history()), look.pieces);
  if (on_.hand.spring) on_.hand.spring->piece = named_after(delta, on_.hand.spring->piece);
}

void WorldChanges::show_failed_step(const Error& error) {
  cancel_stroke(on_.hand, on_.work.document);
  on_.renderer.resend(on_.work.document.world());
  on_.message.say(error.message, true);
}

// The picture
// --------------------------------------------------------------------------------------------------------

void WorldChanges::show_outcome(const Outcome& outcome, PreparedBodies prepared, const std::string& said) {
  show_change(outcome.delta, std::move(prepared));
  if (!outcome.ok()) {
    on_.message.say(outcome.error().message, true);
  } else {
    said_later_ = said;
    tell_done();
  }
}

void WorldChanges::tell_done() {
  if (said_later_.empty() || on_.work.document.beam_waits()) return;
  on_.message.say(std::exchange(said_later_, ""));
}

void WorldChanges::show_change(const Delta& delta, PreparedBodies prepared) {
  const World& world = on_.work.document.world();
  on_.renderer.follow(world, delta, std::move(prepared));
  ViewOptions& look = on_.view.look;
  follow_world(world, delta, look.pieces);
  on_.view.numbers.follow(world, true, pieces_may_return(on_.work.document.history()), look.pieces);
  if (on_.view.spread > 0) spread_pieces(world, on_.view.spread, look);
  if (hidden_before_) {
    on_.view.isolated_from = hidden_bodies(world);
    std::erase_if(on_.view.isolated_from, [&](const BodyId& id) {
      return std::find(hidden_before_->begin(), hidden_before_->end(), id) != hidden_before_->end();
    });
    hidden_before_.reset();
  }
  if (look.tree.body && !world.contains(*look.tree.body)) look.tree.body.reset();
  on_.view.picture_old = on_.figures.world_changed = true;
}

void WorldChanges::show_world(const World& world, Renderer& renderer) const {
  if (on_.work.as_loaded) {
    renderer.show(*on_.work.as_loaded, on_.work.paints);
    renderer.resend(world);
  } else {
    renderer.show(world, on_.work.paints);
  }
}

}  // namespace kerf
