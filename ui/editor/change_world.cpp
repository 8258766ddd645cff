#include "ui/editor/change_world.h"

#include "ui/editor/piece_set.h"
#include "ui/editor/viewport_input.h"

namespace kerf {

namespace {

void show_result(EditorState& state, Renderer& renderer, const Result<Delta>& delta) {
  if (delta) {
    show_change(state, renderer, *delta);
    return;
  }
  // What waited may have been cut, or taken back, before the command failed.
  Delta all;
  all.anew = true;
  show_change(state, renderer, all);
  state.say(delta.error().message, true);
}

}  // namespace

void change_world(EditorState& state, Renderer& renderer, const Command& command) {
  state.say("");
  show_result(state, renderer, state.document.apply(command));
}

void travel_to(EditorState& state, Renderer& renderer, size_t position) {
  state.say("");
  show_result(state, renderer, state.document.travel(position));
}

void step_through_history(EditorState& state, Renderer& renderer, bool back) {
  cancel_stroke(state);
  change_world(state, renderer, back ? Command(Undo{}) : Command(Redo{}));
  ++state.undos;
}

namespace {

// A command for each piece that is chosen, one after the other: a piece may go by another body then.
template <typename Make>
void change_chosen(EditorState& state, Renderer& renderer, Make command_for) {
  while (const auto key = first_chosen(state.look.pieces)) {
    state.look.pieces[*key].selected = false;
    change_world(state, renderer, command_for(PieceRef{key->first.slot, key->second}));
  }
}

}  // namespace

void hide_chosen(EditorState& state, Renderer& renderer) {
  change_chosen(state, renderer, [](const PieceRef& piece) { return Command(HidePiece{piece, true}); });
}

void delete_chosen(EditorState& state, Renderer& renderer) {
  change_chosen(state, renderer, [](const PieceRef& piece) { return Command(DeletePiece{piece}); });
}

void show_hidden(EditorState& state, Renderer& renderer) {
  for (size_t left = hidden_pieces(state.look.pieces); left > 0; --left) {
    const auto key = first_hidden(state.look.pieces);
    if (!key) return;
    change_world(state, renderer, HidePiece{{key->first.slot, key->second}, false});
  }
}

void show_world(const EditorState& state, const World& world, Renderer& renderer) {
  if (state.as_loaded) {
    renderer.show(*state.as_loaded, state.paints);
    renderer.resend(world);
  } else {
    renderer.show(world, state.paints);
  }
}

void show_change(EditorState& state, Renderer& renderer, const Delta& delta) {
  const World& world = state.document.world();
  if (delta.anew) {
    renderer.resend(world);
  } else {
    renderer.follow(delta);
  }
  follow_world(world, state.look.pieces);
  if (state.spread > 0) spread_pieces(world, state.spread, state.look.pieces);
  if (state.look.tree.body && !world.contains(*state.look.tree.body)) state.look.tree.body.reset();
  state.picture_old = state.world_changed = true;
}

}  // namespace kerf
