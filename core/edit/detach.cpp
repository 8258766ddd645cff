#include "core/edit/detach.h"

#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/edit/body_edit.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh.h"

namespace kerf {

BodyDelta move_components(BodyId id, Body& body, const std::map<uint32_t, uint32_t>& label_of) {
  KERF_ASSERT(is_settled(body));
  BodyDelta delta;
  delta.body = id;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const FaceId base = body.loaded_base(FaceId(f));
    const auto label = label_of.find(body.components.of(base));
    if (label == label_of.end()) continue;
    const uint32_t own = body.mesh.data(FaceId(f)).piece;
    const bool is_at_home = body.components.at_home(base, own) != LoadedComponents::kNone;
    KERF_ASSERT(is_at_home || own != label->second);
    if (!is_at_home) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const AreaMoments moments = area_moments(t, triangle_area(t), body.middle());
    while (body.pieces.size() <= label->second) {
      delta.new_pieces.push_back(body.pieces.size());
      body.pieces.push_back({});
    }
    body.edit_piece_of(FaceId(f)).moments -= moments;
    body.mesh.edit_data(FaceId(f)).piece = label->second;
    body.edit_piece_of(FaceId(f)).moments += moments;
    delta.relabelled.push_back(FaceId(f));
  }
  for (const auto& [component, label] : label_of) {
    KERF_ASSERT(component < body.components.left.size() && label < body.pieces.size());
    const FaceCounts counts = body.components.left[component];
    Piece &from = body.pieces.edit(body.components.home[component]), &to = body.pieces.edit(label);
    KERF_ASSERT(from.faces >= counts.faces);
    from.faces -= counts.faces;
    from.area -= counts.area;
    to.faces += counts.faces;
    to.area += counts.area;
    body.components.home.edit(component) = label;
  }
  return delta;
}

namespace {

struct Enclosed {
  double volume = 0;  // m^3, signed
  FaceId lowest;
};

// Returns by component the volume that its faces at home enclose.
std::vector<Enclosed> components_of(const Body& body) {
  std::vector<Enclosed> all(body.components.left.size());
  const Vec3 o = body.middle();
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f)) continue;
    const uint32_t component = body.components.at_home(body.loaded_base(f), body.mesh.data(f).piece);
    if (component == LoadedComponents::kNone) continue;
    const Triangle t = body.mesh.triangle(f);
    all[component].volume += volume_under(t, o);
    if (!all[component].lowest.valid()) all[component].lowest = f;
  }
  return all;
}

bool is_cavity(const Body& body, const std::vector<Enclosed>& components, FaceId f) {
  const uint32_t component = body.components.at_home(body.loaded_base(f), body.mesh.data(f).piece);
  return component != LoadedComponents::kNone && components[component].volume < 0;
}

// Returns the remaining loaded components of faces that were copied out.
LoadedComponents components_of(const Mesh& copy, const Body& body, std::span<const FaceId> faces) {
  KERF_ASSERT(copy.live_faces() == faces.size());
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
  copy.is_copy = body.is_copy;
  copy.loaded_faces = loaded_faces_of(copy.mesh, body, faces);
  return copy;
}

}  // namespace

bool cavities_requested(const Body& body) { return body.separation.cavities_requested; }

std::optional<uint32_t> group_around(const Body& body, FaceId face,
                                     const std::function<std::optional<uint32_t>(FaceId)>& group_of) {
  const Triangle t = body.mesh.triangle(face);
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(normal);
  // Any direction serves, because faces of cavities do not count.
  const Vec3 direction = length > 0 ? -normal / length : Vec3(0, 0, 1);
  std::vector<RayHit> hits;
  body.tree.crossings(body.mesh, {(t[0] + t[1] + t[2]) / 3.0, direction},
                      {0, std::numeric_limits<double>::max()}, hits);
  std::map<uint32_t, int> left;
  for (const RayHit& hit : hits) {
    const std::optional<uint32_t> group = group_of(hit.face);
    if (!group) continue;
    const Triangle other = body.mesh.triangle(hit.face);
    left[*group] += glm::dot(glm::cross(other[1] - other[0], other[2] - other[0]), direction) > 0 ? 1 : -1;
  }
  for (const RayHit& hit : hits) {
    const std::optional<uint32_t> group = group_of(hit.face);
    if (group && left[*group] > 0) return group;
  }
  return std::nullopt;
}

void assign_cavities(BodyId id, Body& body, Delta& delta) {
  if (!cavities_requested(body)) return;
  KERF_ASSERT(is_settled(body));
  body.separation.cavities_requested = false;
  if (body.components.left.empty()) return;
  const std::vector<Enclosed> components = components_of(body);
  const auto piece_of = [&](FaceId f) -> std::optional<uint32_t> {
    if (is_cavity(body, components, f)) return std::nullopt;
    return body.mesh.data(f).piece;
  };
  std::map<uint32_t, uint32_t> label_of;
  for (uint32_t c = 0; c < components.size(); ++c) {
    if (!(components[c].volume < 0)) continue;
    const uint32_t home = body.components.home[c];
    const uint32_t label = group_around(body, components[c].lowest, piece_of).value_or(home);
    if (label != home) label_of[c] = label;
  }
  if (label_of.empty()) return;
  Delta step;
  step.bodies.push_back(move_components(id, body, label_of));
  delta.append(std::move(step));
}

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
  KERF_ASSERT(!going.empty() && going.size() < body.mesh.live_faces());
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
  copy.is_copy = true;
  Delta step;
  step.created = {world.add(std::move(copy), generation)};
  delta.append(step);
  return step.created.front();
}

}  // namespace kerf
