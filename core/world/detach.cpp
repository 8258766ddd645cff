#include "core/world/detach.h"

#include <vector>

#include "core/mesh/extract_mesh.h"

namespace kerf {

namespace {

// The faces of a piece, or all but those, ascending.
std::vector<FaceId> faces_of(const Body& body, uint32_t label, bool of_piece) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const FaceId face(f);
    if (body.mesh.is_live(face) && (body.mesh.data(face).piece == label) == of_piece) faces.push_back(face);
  }
  return faces;
}

// What is left of the parts as loaded, for faces that were copied out.
LoadedComponents components_of(const Mesh& copy, const Body& body, std::span<const FaceId> faces) {
  LoadedComponents own;
  if (body.components.left.empty()) return own;
  own.left = body.components.left;
  own.of_base.resize(faces.size());
  for (uint32_t f = 0; f < faces.size(); ++f) {
    const FaceId base = body.mesh.data(faces[f]).base;
    own.of_base[copy.data(FaceId(f)).base.index] = body.components.of_base[base.index];
  }
  return own;
}

Body copy_out(const Body& body, std::span<const FaceId> faces, uint32_t label, bool of_piece) {
  Body copy;
  copy.name = body.name;
  copy.placement = body.placement;
  copy.hidden = body.hidden;
  copy.mesh = extract_mesh(body.mesh, faces);
  copy.tree = AabbTree(copy.mesh);
  for (uint32_t p = 0; p < body.pieces.size(); ++p)
    copy.pieces.push_back((p == label) == of_piece ? body.pieces[p] : Piece{});
  copy.components = components_of(copy.mesh, body, faces);
  copy.material_names = body.material_names;
  copy.loaded = body.loaded;
  return copy;
}

void take_out(Body& body, std::span<const FaceId> faces) {
  for (const FaceId f : faces) {
    body.refinement.forget(body.mesh, f);
    body.pieces.edit(body.mesh.data(f).piece) = Piece{};
    body.mesh.remove_face(f);
    body.tree.remove(f);
  }
}

}  // namespace

bool stands_alone(const Body& body, uint32_t label) {
  for (uint32_t p = 0; p < body.pieces.size(); ++p) {
    if (p != label && body.pieces[p].faces > 0) return false;
  }
  return true;
}

BodyId detach(World& world, BodyId id, uint32_t label, Delta& delta) {
  if (stands_alone(world.body(id), label)) return id;
  const size_t faces = world.body(id).pieces[label].faces;
  const bool piece_goes = 2 * faces <= world.body(id).mesh.live_faces();
  std::vector<FaceId> going = faces_of(world.body(id), label, piece_goes);
  const BodyId fresh = world.add(copy_out(world.body(id), going, label, piece_goes));
  take_out(world.body(id), going);
  const BodyId own = piece_goes ? fresh : id;
  world.body(own).name += " piece " + std::to_string(label);
  delta.anew = true;
  return own;
}

}  // namespace kerf
