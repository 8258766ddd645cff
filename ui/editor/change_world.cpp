#include "ui/editor/change_world.h"

#include <algorithm>

#include "core/document/command_words.h"
#include "ui/editor/piece_set.h"
#include "ui/editor/viewport_input.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces = 40'000;  // that are copied in a part of a frame

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

// The piece that a command takes out of its body, where it is one that does.
const PieceRef* piece_of(const Command& command) {
  if (const auto* c = std::get_if<MovePiece>(&command)) return &c->piece;
  if (const auto* c = std::get_if<HidePiece>(&command)) return &c->piece;
  if (const auto* c = std::get_if<DeletePiece>(&command)) return &c->piece;
  if (const auto* c = std::get_if<RenamePiece>(&command)) return &c->piece;
  return nullptr;
}

// Of a piece or of what stands beside it, the faces of the smaller side are copied.
bool copies_many_faces(const World& world, const PieceRef& ref) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (id.slot != ref.body || ref.label >= body.pieces.size()) continue;
    const size_t own = body.pieces[ref.label].faces, all = body.mesh.live_faces();
    return std::min(own, all - own) > kManyFaces;
  }
  return false;
}

bool takes_long(const World& world, const Command& command) {
  if (std::holds_alternative<AddMesh>(command)) return true;
  const PieceRef* piece = piece_of(command);
  return piece && copies_many_faces(world, *piece);
}

void go_back_by_replay(EditorState& state, Renderer& renderer, size_t position) {
  const size_t steps = state.document.history().position() - position;
  LongChange change;
  change.title = "Going back by replay, " + std::to_string(steps) + (steps == 1 ? " step" : " steps");
  change.can_stop = true;
  change.run = [position](Document& document, const Progress& progress) {
    return document.travel(position, &progress);
  };
  change.then = [&](const Result<Delta>& delta) { show_result(state, renderer, delta); };
  state.long_change = std::move(change);
}

}  // namespace

void change_world(EditorState& state, Renderer& renderer, const Command& command) {
  state.say("");
  const size_t now = state.document.history().position();
  if (std::holds_alternative<Undo>(command) && now > 0 && !state.document.remembers_way_to(now - 1))
    return go_back_by_replay(state, renderer, now - 1);
  if (!takes_long(state.document.world(), command))
    return show_result(state, renderer, state.document.apply(command));
  LongChange change;
  change.title = words(command);
  change.can_stop = piece_of(command) == nullptr;
  change.run = [command](Document& document, const Progress& progress) {
    return document.apply(command, &progress);
  };
  change.then = [&](const Result<Delta>& delta) { show_result(state, renderer, delta); };
  state.long_change = std::move(change);
}

void travel_to(EditorState& state, Renderer& renderer, size_t position) {
  state.say("");
  if (!state.document.remembers_way_to(position)) return go_back_by_replay(state, renderer, position);
  show_result(state, renderer, state.document.travel(position));
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
  while (const auto key = first_chosen(state.look.pieces)) {
    if (state.long_change) return true;
    state.look.pieces[*key].selected = false;
    change_world(state, renderer, command_for(PieceRef{key->first.slot, key->second}));
  }
  return false;
}

}  // namespace

void hide_chosen(EditorState& state, Renderer& renderer) {
  state.requests.hide_chosen = change_chosen(state, renderer, [](const PieceRef& piece) {
    return Command(HidePiece{piece, true});
  });
}

void delete_chosen(EditorState& state, Renderer& renderer) {
  state.requests.delete_chosen =
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
