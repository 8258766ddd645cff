#include "core/document/piece_commands.h"

#include "core/world/detach.h"
#include "core/world/load_body.h"

namespace kerf {

namespace {

struct Found {
  BodyId body;
  uint32_t label;
};

Result<Found> find(const World& world, const PieceRef& ref) {
  for (const BodyId id : world.ids()) {
    const auto& pieces = world.body(id).pieces;
    if (id.slot == ref.body && ref.label < pieces.size() && pieces[ref.label].faces > 0)
      return Found{id, ref.label};
  }
  return bad_input("there is no piece " + std::to_string(ref.label) + " of body " + std::to_string(ref.body));
}

bool same(const Placement& a, const Placement& b) {
  return a.position == b.position && a.orientation == b.orientation;
}

// Lets the command edit the body that the piece is, where `differs` says that there is something to do.
template <typename Differs, typename Edit>
Result<Delta> edit_piece(World& world, const PieceRef& ref, Differs differs, Edit edit) {
  const Result<Found> found = find(world, ref);
  if (!found) return found.error();
  Delta delta;
  if (!differs(world.body(found->body))) return delta;
  const BodyId own = detach(world, found->body, found->label, delta);
  edit(own);
  delta.anew = true;
  return delta;
}

Result<Delta> run(World& world, const AddMesh& c, const Progress* progress) {
  Result<Body> body = load_body(c.name, c.file, progress);
  if (!body) return body.error();
  world.add(std::move(*body));
  Delta delta;
  delta.anew = true;
  return delta;
}

Result<Delta> run(World& world, const MovePiece& c) {
  return edit_piece(
      world, c.piece, [&](const Body& b) { return !same(b.placement, c.to); },
      [&](BodyId own) { world.body(own).placement = c.to; });
}

Result<Delta> run(World& world, const HidePiece& c) {
  return edit_piece(
      world, c.piece, [&](const Body& b) { return b.hidden != c.hidden; },
      [&](BodyId own) { world.body(own).hidden = c.hidden; });
}

Result<Delta> run(World& world, const DeletePiece& c) {
  return edit_piece(
      world, c.piece, [](const Body&) { return true; }, [&](BodyId own) { world.remove(own); });
}

Result<Delta> run(World& world, const RenamePiece& c) {
  return edit_piece(
      world, c.piece, [&](const Body& b) { return b.name != c.name; },
      [&](BodyId own) { world.body(own).name = c.name; });
}

}  // namespace

Result<Delta> run_at_once(World& world, const Command& command, const Progress* progress) {
  if (const auto* c = std::get_if<AddMesh>(&command)) return run(world, *c, progress);
  if (const auto* c = std::get_if<MovePiece>(&command)) return run(world, *c);
  if (const auto* c = std::get_if<HidePiece>(&command)) return run(world, *c);
  if (const auto* c = std::get_if<DeletePiece>(&command)) return run(world, *c);
  if (const auto* c = std::get_if<RenamePiece>(&command)) return run(world, *c);
  return Delta{};
}

}  // namespace kerf
