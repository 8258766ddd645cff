#include "core/edit/detach.h"

#include <vector>

#include "core/base/assert.h"
#include "core/edit/body_edit.h"
#include "core/mesh/mesh.h"

namespace kerf {

namespace {

// Returns the remaining loaded components of faces that were copied out.
LoadedComponents components_of(const Mesh& copy, const Body& body, std::span<const FaceId> faces) {
  LoadedComponents own;
  if (body.components.left.empty()) return own;
  own.left = body.components.left;
  own.home = body.components.home;
  own.joined = body.components.joined;
  own.of_base.resize(faces.size());
  for (uint32_t f = 0; f < faces.size(); ++f) {
    const FaceId base = body.loaded_base(faces[f]);
    own.of_base[copy.data(FaceId(f)).base.index] = body.components.of_base[base.index];
  }
  return own;
}

// Returns the loaded faces of the base faces of copied faces.
std::vector<FaceId> loaded_faces_of(const Mesh& copy, const Body& body, std::span<const FaceId> faces) {
  std::vector<FaceId> loaded(faces.size());
  for (uint32_t f = 0; f < faces.size(); ++f)
    loaded[copy.data(FaceId(f)).base.index] = body.loaded_face(body.loaded_base(faces[f]));
  return loaded;
}

// Makes the base faces of the copy the adjacent faces of its walls.
void keep_walls(Body& copy) {
  copy.mesh.columns().for_each_set(copy.walls.beside_of,
                                   [&](FaceId f) { copy.walls.set(copy.mesh, f, copy.mesh.data(f).base); });
}

// Names the body after the piece if that has a custom name, so that pieces cut off later are named after it.
// Returns true if it has.
bool name_after(Body& body, uint32_t label) {
  const auto given = body.piece_names.find(label);
  if (given == body.piece_names.end()) return false;
  body.name = given->second;
  body.named = label;
  body.piece_names.clear();
  return true;
}

Body copy_out(const Body& body, std::span<const FaceId> faces, uint32_t label, bool of_piece) {
  Body copy;
  copy.name = body.name;
  copy.named = body.named;
  copy.piece_names = body.piece_names;
  copy.placement = body.placement;
  copy.hidden = body.hidden;
  copy.motion = body.motion;
  copy.sheet = body.sheet;
  copy.pinned = body.pinned;
  copy.solid = body.solid;
  copy.cut_material = body.cut_material;
  copy.mesh = extract_mesh(body.mesh, faces);
  copy.heat = body.heat;
  copy.walls = body.walls;
  copy.tree = AabbTree(copy.mesh);
  for (uint32_t p = 0; p < body.pieces.size(); ++p)
    copy.pieces.push_back((p == label) == of_piece ? body.pieces[p] : Piece{});
  copy.enclosed = body.enclosed;
  copy.components = components_of(copy.mesh, body, faces);
  keep_walls(copy);
  copy.material_names = body.material_names;
  copy.looks = body.looks;
  copy.loaded = body.loaded;
  copy.loaded_as = body.loaded_as;
  copy.loaded_faces = loaded_faces_of(copy.mesh, body, faces);
  return copy;
}

}  // namespace

bool is_only_piece(const World& world, const PieceId& piece) {
  const Records<Piece>& pieces = world.body(piece.body).pieces;
  for (uint32_t p = 0; p < pieces.size(); ++p) {
    if (p != piece.label && pieces[p].faces > 0) return false;
  }
  return true;
}

BodyId detach(World& world, const PieceId& piece, uint32_t generation, Delta& delta) {
  const Body& body = world.body(piece.body);
  KERF_ASSERT(piece.label < body.pieces.size() && body.pieces[piece.label].faces > 0);
  if (is_only_piece(world, piece)) return piece.body;
  const bool piece_goes = 2 * body.pieces[piece.label].faces <= body.mesh.live_faces();
  const std::vector<FaceId> going = body.faces_of(piece.label, piece_goes);
  const BodyId own = world.add(copy_out(body, going, piece.label, piece_goes), generation);
  BodyEdit(world.body(piece.body)).take_out(going);
  const bool renamed = name_after(world.body(piece_goes ? own : piece.body), piece.label);
  if (!piece_goes) world.exchange_bodies(piece.body, own);
  Delta step;
  step.created = {piece_goes ? own : piece.body};
  step.detached = {{piece.body, piece.label, own, !piece_goes}};
  if (renamed && !piece_goes) step.renamed = {own};
  step.bodies.push_back({piece_goes ? piece.body : own, {}, going, {}, {}, {}});
  delta.append(std::move(step));
  return own;
}

BodyId duplicate(World& world, const PieceId& piece, uint32_t generation, Delta& delta) {
  const Body& body = world.body(piece.body);
  KERF_ASSERT(piece.label < body.pieces.size() && body.pieces[piece.label].faces > 0);
  const std::vector<FaceId> faces = body.faces_of(piece.label);
  Body copy = copy_out(body, faces, piece.label, true);
  copy.name = body.name_of(piece.label) + " copy";
  copy.named = piece.label;
  copy.piece_names.clear();
  Delta step;
  step.created = {world.add(std::move(copy), generation)};
  delta.append(step);
  return step.created.front();
}

}  // namespace kerf
