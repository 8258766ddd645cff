#include "core/document/piece_commands.h"

#include "core/graph/detach.h"
#include "core/world/load_body.h"

namespace kerf {

namespace {

bool has_faces(const World& world, const PieceId& piece) {
  if (!world.contains(piece.body)) return false;
  const auto& pieces = world.body(piece.body).pieces;
  return piece.label < pieces.size() && pieces[piece.label].faces > 0;
}

bool same(const Placement& a, const Placement& b) {
  return a.position == b.position && a.orientation == b.orientation;
}

// Lets the command edit the body that the piece is, where `differs` says that there is something to do. The
// edit returns what it changed.
template <typename Differs, typename Edit>
Result<Delta> edit_piece(World& world, const PieceId& piece, uint32_t generation, Differs differs,
                         Edit edit) {
  if (!has_faces(world, piece))
    return bad_input("there is no piece " + std::to_string(piece.label) + " of body " +
                     std::to_string(piece.body.slot));
  Delta delta;
  if (!differs(world.body(piece.body))) return delta;
  const BodyId own = detach(world, piece, generation, delta);
  delta.append(edit(own));
  return delta;
}

Result<Delta> run(World& world, const AddMesh& c, uint32_t generation, const Progress* progress) {
  Result<Body> body = load_body(c.name, c.file, progress);
  if (!body) return body.error();
  Delta delta;
  delta.came = {world.add(std::move(*body), generation)};
  return delta;
}

Result<Delta> run(World& world, const MovePiece& c, uint32_t generation) {
  return edit_piece(
      world, c.piece, generation, [&](const Body& b) { return !same(b.placement, c.to); },
      [&](BodyId own) {
        world.body(own).placement = c.to;
        Delta change;
        change.moved = {own};
        return change;
      });
}

Result<Delta> run(World& world, const HidePiece& c, uint32_t generation) {
  return edit_piece(
      world, c.piece, generation, [&](const Body& b) { return b.hidden != c.hidden; },
      [&](BodyId own) {
        world.body(own).hidden = c.hidden;
        Delta change;
        change.hid_or_showed = {own};
        return change;
      });
}

Result<Delta> run(World& world, const DeletePiece& c, uint32_t generation) {
  return edit_piece(
      world, c.piece, generation, [](const Body&) { return true; },
      [&](BodyId own) {
        world.remove(own);
        Delta change;
        change.went = {own};
        return change;
      });
}

Result<Delta> run(World& world, const RenamePiece& c, uint32_t generation) {
  return edit_piece(
      world, c.piece, generation, [&](const Body& b) { return b.name != c.name; },
      [&](BodyId own) {
        world.body(own).name = c.name;
        Delta change;
        change.renamed = {own};
        return change;
      });
}

}  // namespace

Command with_whole_id(const World& world, Command command) {
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.piece; }) {
          if (c.piece.body.generation != BodyId::kUnknownGeneration) return;
          for (const BodyId id : world.ids()) {
            if (world.body(id).number == c.piece.body.slot) return void(c.piece.body = id);
          }
        }
      },
      command);
  return command;
}

Result<Delta> run_at_once(World& world, const Command& command, uint32_t generation,
                          const Progress* progress) {
  if (const auto* c = std::get_if<AddMesh>(&command)) return run(world, *c, generation, progress);
  if (const auto* c = std::get_if<MovePiece>(&command)) return run(world, *c, generation);
  if (const auto* c = std::get_if<HidePiece>(&command)) return run(world, *c, generation);
  if (const auto* c = std::get_if<DeletePiece>(&command)) return run(world, *c, generation);
  if (const auto* c = std::get_if<RenamePiece>(&command)) return run(world, *c, generation);
  return Delta{};
}

}  // namespace kerf
