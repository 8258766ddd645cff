#include "ui/editor/changes/change_world.h"

#include <algorithm>

#include "core/document/command_words.h"
#include "ui/editor/tools/piece_set.h"
#include "ui/editor/tools/viewport_input.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces =
    40'000;  // of which most changes of bodies are no longer done in a part of a frame

void show_result(EditorState& state, Renderer& renderer, const Result<Delta>& delta,
                 PreparedBodies prepared = {}) {
  if (delta) {
    show_change(state, renderer, *delta, std::move(prepared));
    return;
  }
  // What waited may have been cut, or taken back, before the command failed.
  Delta all;
  all.anew = true;
  show_change(state, renderer, all);
  state.say(delta.error().message, true);
}

// What pictures need of the bodies that came; where the world was replaced, of all of them, but of those that
// are shown already only what casts their shadows.
PreparedBodies prepare(const World& world, const Delta& delta, const std::map<BodyId, FloatFrame>& frames) {
  PreparedBodies prepared;
  for (const BodyId id : delta.came) prepared.emplace(id, prepare_shading(world.body(id)));
  for (const BodyId id : delta.anew ? world.ids() : std::vector<BodyId>()) {
    const auto known = frames.find(id);
    prepared.emplace(id, known == frames.end() ? prepare_shading(world.body(id))
                                               : PreparedBody{known->second, {}, nullptr});
  }
  (void)prepare_shadows(world, prepared, nullptr);  // nobody stops it
  return prepared;
}

using Change = std::function<Result<Delta>(Document&, const Progress*)>;

// Does it now where it is quick, and beside the frames where it may take long.
void change(EditorState& state, Renderer& renderer, const std::string& title, bool quick,
            const Change& what) {
  state.say("");
  if (quick) return show_result(state, renderer, what(state.document, nullptr));
  const auto prepared = std::make_shared<PreparedBodies>();
  LongChange long_change;
  long_change.title = title;
  long_change.run = [what, prepared, frames = renderer.frames()](Document& document,
                                                                 const Progress& progress) {
    Result<Delta> delta = what(document, &progress);
    if (delta) *prepared = prepare(document.world(), *delta, frames);
    return delta;
  };
  long_change.then = [&, prepared](const Result<Delta>& delta) {
    show_result(state, renderer, delta, std::move(*prepared));
  };
  state.long_change = std::move(long_change);
}

bool is_of_stroke(const Command& command) {
  return std::holds_alternative<BeginStroke>(command) || std::holds_alternative<MoveStroke>(command) ||
         std::holds_alternative<EndStroke>(command) || std::holds_alternative<Recut>(command);
}

bool is_small(const Document& document) { return document.world().live_faces() <= kManyFaces; }

bool is_quick(const Document& document, const Command& command) {
  if (is_of_stroke(command)) return true;
  if (std::holds_alternative<AddMesh>(command) || !is_small(document)) return false;
  const size_t now = document.history().position();
  return now == 0 || !std::holds_alternative<Undo>(command) || document.remembers_way_to(now - 1);
}

Change apply_all(std::vector<Command> commands) {
  return [commands = std::move(commands)](Document& document, const Progress* progress) -> Result<Delta> {
    Delta all;
    for (const Command& command : commands) {
      Result<Delta> one = document.apply(command, progress);
      if (!one) return one;
      all.append(std::move(*one));
    }
    return all;
  };
}

}  // namespace

void change_world(EditorState& state, Renderer& renderer, const Command& command) {
  change(state, renderer, words(command), is_quick(state.document, command),
         [command](Document& d, const Progress* progress) { return d.apply(command, progress); });
}

void travel_to(EditorState& state, Renderer& renderer, size_t position) {
  const bool quick = is_small(state.document) && state.document.remembers_way_to(position);
  change(state, renderer, "Through the history", quick,
         [position](Document& d, const Progress* progress) { return d.travel(position, progress); });
}

void step_through_history(EditorState& state, Renderer& renderer, bool back) {
  cancel_stroke(state);
  change_world(state, renderer, back ? Command(Undo{}) : Command(Redo{}));
  ++state.undos;
}

namespace {

// A command for each piece that is chosen, one after the other: a piece may go by another body then. Whether
// some are left because one takes long.
template <typename Make>
bool change_chosen(EditorState& state, Renderer& renderer, Make command_for) {
  while (const auto piece = first_chosen(state.look.pieces)) {
    if (state.long_change) return true;
    state.look.pieces[*piece].selected = false;
    change_world(state, renderer, command_for(*piece));
  }
  return false;
}

}  // namespace

void hide_chosen(EditorState& state, Renderer& renderer) {
  state.requests.hide_chosen = change_chosen(state, renderer, [](const PieceId& piece) {
    return Command(HidePiece{piece, true});
  });
}

void delete_chosen(EditorState& state, Renderer& renderer) {
  state.requests.delete_chosen =
      change_chosen(state, renderer, [](const PieceId& piece) { return Command(DeletePiece{piece}); });
}

// Hidden pieces are bodies of their own, so that none goes by another name when one is shown.
void show_hidden(EditorState& state, Renderer& renderer) {
  std::vector<Command> commands;
  for (const PieceId& piece : hidden_pieces(state.look.pieces))
    commands.emplace_back(HidePiece{piece, false});
  change(state, renderer, "Show all pieces", is_small(state.document), apply_all(std::move(commands)));
}

void cut_again(EditorState& state, Renderer& renderer, const CutSettings& settings) {
  std::vector<Command> commands;
  const Command& last = state.document.history().last().commands.front();
  if (std::holds_alternative<Recut>(last)) commands.emplace_back(Undo{});
  commands.emplace_back(Recut{settings});
  change(state, renderer, "Cut again", true, apply_all(std::move(commands)));
}

void follow_step(EditorState& state, Renderer& renderer, const StepResult& step) {
  renderer.follow(state.document.world(), step.delta);
  if (state.look.ghost || state.look.show.face_numbers) renderer.catch_up(state.document.world());
  state.last_step = step.figures;
  state.note_figures(step.figures);
  state.history.note_step(step);
}

void show_failed_step(EditorState& state, Renderer& renderer, const Error& error) {
  cancel_stroke(state);
  renderer.resend(state.document.world());
  state.say(error.message, true);
}

bool close_rim_beside(EditorState& state, Renderer& renderer) {
  const size_t faces = state.document.world().live_faces();
  if (!state.document.next_closes_rim() || faces <= kManyFaces) return false;
  const auto step = std::make_shared<StepResult>();
  LongChange change;
  change.title = "Smoothing the rim";
  change.run = [step](Document& document, const Progress&) -> Result<Delta> {
    Result<StepResult> done = document.step(1);
    if (!done) return done.error();
    *step = std::move(*done);
    return Delta{};
  };
  change.then = [&state, &renderer, step, faces](const Result<Delta>& done) {
    if (!done) return show_failed_step(state, renderer, done.error());
    follow_step(state, renderer, *step);
    state.faces_before_step = faces;
    state.world_changed = true;
  };
  state.long_change = std::move(change);
  return true;
}

void show_world(const EditorState& state, const World& world, Renderer& renderer) {
  if (state.as_loaded) {
    renderer.show(*state.as_loaded, state.paints);
    renderer.resend(world);
  } else {
    renderer.show(world, state.paints);
  }
}

void show_change(EditorState& state, Renderer& renderer, const Delta& delta, PreparedBodies prepared) {
  const World& world = state.document.world();
  renderer.follow(world, delta, std::move(prepared));
  follow_world(world, delta, state.look.pieces);
  if (state.spread > 0) spread_pieces(world, state.spread, state.look.pieces);
  if (state.look.tree.body && !world.contains(*state.look.tree.body)) state.look.tree.body.reset();
  state.picture_old = state.world_changed = true;
}

}  // namespace kerf
