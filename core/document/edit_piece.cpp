#include "core/document/edit_piece.h"

#include <algorithm>

#include "core/edit/body_edit.h"
#include "core/edit/detach.h"
#include "core/joints/joined_parts.h"
#include "core/mesh/looks.h"
#include "core/world/body_creation.h"

namespace kerf {

std::string piece_words(const PieceId& piece) {
  const std::string body = "body " + std::to_string(piece.body.slot + 1);
  return piece.label == 0 ? body : "piece " + std::to_string(piece.label) + " of " + body;
}

bool has_faces(const World& world, const PieceId& piece) {
  if (!world.contains(piece.body)) return false;
  const auto& pieces = world.body(piece.body).pieces;
  return piece.label < pieces.size() && pieces[piece.label].faces > 0;
}

Error no_such_piece(const PieceId& piece) {
  return bad_input("there is no piece " + std::to_string(piece.label) + " of body " +
                   std::to_string(piece.body.slot));
}

Result<Delta> edit_piece(World& world, const PieceId& piece, uint32_t generation,
                         std::vector<BodyId> Delta::*list, const std::function<bool(const Body&)>& differs,
                         const std::function<void(Body&)>& edit) {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta, change;
  if (!differs(world.body(piece.body))) return delta;
  const BodyId own = detach(world, piece, generation, delta);
  edit(world.body(own));
  change.*list = {own};
  delta.append(std::move(change));
  return delta;
}

namespace {

// The indices of the joints within the piece; bad input if one holds it to another piece.
Result<std::vector<uint32_t>> joints_within(const World& world, const PieceId& piece) {
  std::vector<uint32_t> within;
  for (const HeldJoint& held : held_joints(world)) {
    const bool first = held.parts[0].piece() == piece, second = held.parts[1].piece() == piece;
    if (first != second) {
      return bad_input(piece_words(piece) +
                       " is joined to a piece that moves separately: edit the mesh before they come apart");
    }
    if (first) within.push_back(held.joint);
  }
  return within;
}

std::vector<FaceId> carrying_faces(const Joints& joints, std::span<const uint32_t> within,
                                   const PieceCopy& copy) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < copy.loaded.size(); ++f) {
    const bool carries = std::any_of(within.begin(), within.end(), [&](uint32_t j) {
      return std::any_of(joints.all[j].sides.begin(), joints.all[j].sides.end(), [&](const JointSide& s) {
        return std::binary_search(s.faces.begin(), s.faces.end(), copy.loaded[f]);
      });
    });
    if (carries) faces.push_back(FaceId(f));
  }
  return faces;
}

std::vector<FaceId> warm_faces(const FaceHeat& heat, const Mesh& mesh) {
  std::vector<FaceId> faces;
  mesh.columns().for_each_set(heat.energy, [&](FaceId f) { faces.push_back(f); });
  mesh.columns().for_each_set(heat.hottest, [&](FaceId f) { faces.push_back(f); });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::function<bool(FaceId, FaceId)> seam_test(const Body& body, const PieceCopy& copy) {
  if (!body.looks || body.looks->uv_sets() == 0) return {};
  return [&](FaceId a, FaceId b) {
    const FaceId one = body.loaded_source(copy.faces[a.index]),
                 other = body.loaded_source(copy.faces[b.index]);
    return one.valid() && other.valid() && body.looks->has_seam(one, other);
  };
}

// Copies the joints; those within the piece are carried by its new faces.
Joints carried_on(const Joints& joints, std::span<const uint32_t> within, BodyId own, const PieceCopy& copy,
                  const Remeshed& remeshed) {
  Joints all = joints;
  for (const uint32_t j : within) {
    all.all[j].body = own;
    for (JointSide& side : all.all[j].sides) {
      std::vector<uint32_t> faces;
      for (uint32_t t = 0; t < remeshed.origins.size(); ++t) {
        if (std::binary_search(side.faces.begin(), side.faces.end(), copy.loaded[remeshed.origins[t].index]))
          faces.push_back(t);
      }
      side.faces = std::move(faces);
    }
  }
  return all;
}

// Returns true if each triangle has the corners of the face it stems from, in the same order.
bool is_unchanged(const Remeshed& remeshed, const Mesh& mesh) {
  if (remeshed.triangles.size() != mesh.live_faces()) return false;
  for (size_t t = 0; t < remeshed.triangles.size(); ++t) {
    const Triangle before = mesh.triangle(remeshed.origins[t]);
    const auto& [a, b, c] = remeshed.triangles[t];
    Triangle after{remeshed.positions[a], remeshed.positions[b], remeshed.positions[c]};
    std::rotate(after.begin(), std::find(after.begin(), after.end(), before[0]), after.end());
    if (after != before) return false;
  }
  return true;
}

void take_away(World& world, const PieceId& piece, std::span<const FaceId> faces, Delta& delta) {
  if (is_only_piece(world, piece)) {
    world.remove(piece.body);
    delta.destroyed = {piece.body};
    return;
  }
  BodyEdit(world.body(piece.body)).take_out(faces);
  delta.bodies.push_back({piece.body, {}, {faces.begin(), faces.end()}, {}, {}, {}});
}

}  // namespace

Result<Delta> remesh_piece(World& world, const PieceId& piece, uint32_t generation, const Remake& remake,
                           const Progress* progress) {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  const auto within = joints_within(world, piece);
  if (!within) return within.error();
  const Body& body = world.body(piece.body);
  ProgressShares shares(progress);
  const Progress working = shares.next(0.6), making = shares.next(0.4);
  const PieceCopy copy = copy_piece(body, piece.label);
  const TrackedFaces tracked{carrying_faces(world.joints(), *within, copy), warm_faces(body.heat, copy.mesh),
                             seam_test(body, copy)};
  auto remeshed = remake(copy.mesh, tracked, &working);
  if (!remeshed) return remeshed.error();
  if (remeshed->triangles.empty()) return failed(piece_words(piece) + " would have no faces left");
  Delta delta;
  if (is_unchanged(*remeshed, copy.mesh)) return delta;
  std::vector<MeshPart> parts;
  if (world.contains(body.loaded_as)) parts = world.body(body.loaded_as).named_parts;
  auto made = rebuilt_body(body, copy, *remeshed, parts, &making);
  if (!made) return made.error();

  const bool alone = is_only_piece(world, piece);
  const uint32_t number = body.number;
  if (alone) made->ejected = body.ejected;
  take_away(world, piece, copy.faces, delta);
  const BodyId own = world.add(std::move(*made), generation);
  if (alone) world.body(own).number = number;
  if (!within->empty()) world.set_joints(carried_on(world.joints(), *within, own, copy, *remeshed));
  delta.created = {own};
  delta.detached = {{piece.body, piece.label, own, false}};
  return delta;
}

}  // namespace kerf
