#include "core/document/extract.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>

#include "core/base/assert.h"
#include "core/edit/body_edit.h"
#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "core/joints/joined_parts.h"
#include "core/mesh/face_batches.h"
#include "core/mesh/looks.h"
#include "core/mesh/measures.h"
#include "core/mesh/soup_topology.h"
#include "core/mesh/weld.h"
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

// Returns the UVs of the faces of a piece, by set.
std::vector<std::vector<FaceUvs>> uv_sets_of(const Body& body, const PieceCopy& copy) {
  std::vector<std::vector<FaceUvs>> sets(body.looks ? body.looks->uv_sets() : 0);
  for (size_t set = 0; set < sets.size(); ++set) {
    for (uint32_t f = 0; f < copy.faces.size(); ++f) {
      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
      FaceUvs& uvs = sets[set].emplace_back();
      uvs.fill(glm::dvec2(kNone));
      const FaceId source = body.loaded_source(copy.faces[f]);
      if (!source.valid() || !body.looks->has_uvs(set, source)) continue;
      const Triangle corners = copy.mesh.triangle(FaceId(f));
      for (size_t i = 0; i < 3; ++i)
        uvs[i] = body.looks->uv(set, {source, body.looks->barycentrics(source, corners[i])});
    }
  }
  return sets;
}

// Copies the joints; the new faces of the piece carry those within it.
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

// Returns true if each triangle has the corners of the face from which it derives, in the same order.
bool is_unchanged(const Remeshed& remeshed, const Mesh& mesh) {
  KERF_ASSERT(remeshed.origins.size() == remeshed.triangles.size());
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

// The vertices of some faces, ascending, as a bit set with constant-time rank (G. Jacobson: Space-efficient
// static trees and graphs, 1989).
class VertexSet {
 public:
  VertexSet(const Mesh& mesh, std::span<const FaceId> faces) : words_(mesh.vertex_slots() / 64 + 1) {
    for_each_corners(mesh, faces, [&](FaceId, const std::array<VertexId, 3>& corners) {
      for (const VertexId v : corners) words_[v.index / 64].bits |= uint64_t{1} << v.index % 64;
    });
    for (Word& word : words_) {
      word.before = count_;
      count_ += static_cast<uint32_t>(std::popcount(word.bits));
    }
  }

  uint32_t count() const { return count_; }
  // The number of vertices of the set less than v. Precondition: the set contains v.
  uint32_t rank(VertexId v) const {
    const Word& word = words_[v.index / 64];
    const uint64_t bit = uint64_t{1} << v.index % 64;
    KERF_ASSERT((word.bits & bit) != 0);
    return word.before + static_cast<uint32_t>(std::popcount(word.bits & (bit - 1)));
  }
  template <typename Visit>
  void for_each(Visit visit) const {
    for (uint32_t w = 0; w < words_.size(); ++w) {
      for (uint64_t bits = words_[w].bits; bits != 0; bits &= bits - 1)
        visit(VertexId(64 * w + static_cast<uint32_t>(std::countr_zero(bits))));
    }
  }

 private:
  struct Word {
    uint64_t bits = 0;
    uint32_t before = 0;  // vertices in the preceding words
  };
  std::vector<Word> words_;
  uint32_t count_ = 0;
};

Triangle triangle_of(const Extract& e, const std::array<uint32_t, 3>& t) {
  return {e.positions[t[0]], e.positions[t[1]], e.positions[t[2]]};
}

bool has_equal_corners(const std::array<uint32_t, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Measures the boundary and the volume. Triangles with equal corners bound nothing: two of their sides are
// one edge in both directions.
void measure_closure(Extract& out) {
  std::span<const std::array<uint32_t, 3>> triangles = out.triangles;
  std::vector<std::array<uint32_t, 3>> proper;
  if (std::ranges::any_of(triangles, has_equal_corners)) {
    std::ranges::remove_copy_if(triangles, std::back_inserter(proper), has_equal_corners);
    triangles = proper;
  }
  const SoupEdges edges = group_sides(triangles, out.positions.size());
  for (uint32_t e = 0; e < edges.count(); ++e) out.boundary_edges += edges.sides_of(e).size() == 1;
  if (out.boundary_edges > 0) return;
  const EnclosedVolume enclosed = enclosed_volume(out.positions, triangles, edges, out.centroid);
  if (enclosed.closed) out.volume = enclosed.volume;
}

void measure(Extract& out) {
  KERF_ASSERT(!out.triangles.empty() && !out.positions.empty());
  const SurfaceMeasures measures = measure_surface(out.positions, out.triangles);
  out.area = measures.area;
  out.centroid = measures.centroid;
  measure_closure(out);
}

MassProperties solid_of(const Extract& e, double density) {
  VolumeMoments moments;
  for (const auto& t : e.triangles) moments += volume_moments(triangle_of(e, t), e.centroid);
  return solid_mass(moments, e.centroid, density);
}

MassProperties shell_of(const Extract& e, const Sheet& sheet) {
  AreaMoments moments;
  for (const auto& t : e.triangles) {
    const Triangle corners = triangle_of(e, t);
    moments += area_moments(corners, triangle_area(corners), e.centroid);
  }
  return shell_mass(e.area, moments, e.centroid, sheet.thickness, sheet.density);
}

// Turns an extract of a solid body into a solid if its faces enclose a volume.
void fill(Extract& out) {
  if (!out.volume || !(*out.volume > 0)) return;
  out.solid = true;
  out.centroid = solid_of(out, 1).centre;
}

// Returns true if the faces of a component are closed and enclose a negative volume.
bool bounds_cavity(const Body& body, std::span<const FaceId> component) {
  const Vec3 apex = body.mesh.triangle(component.front())[0];
  double volume = 0;
  for (const FaceId f : component) volume += volume_under(body.mesh.triangle(f), apex);
  if (!(volume < 0)) return false;
  const Extract e = extract_faces(body, component);
  return e.volume && *e.volume < 0;
}

// Moves the faces of cavities to the components around them, and sorts all components by their lowest faces.
// `component`: index in `components` by face slot. O(n log n + cavities * crossings of a ray).
void join_cavities(const Body& body, const std::vector<uint32_t>& component,
                   std::vector<std::vector<FaceId>>& components) {
  std::vector<bool> cavities(components.size());
  for (size_t c = 0; c < components.size(); ++c) cavities[c] = bounds_cavity(body, components[c]);
  const auto solid_of_face = [&](FaceId f) -> std::optional<uint32_t> {
    if (cavities[component[f.index]]) return std::nullopt;
    return component[f.index];
  };
  for (size_t c = 0; c < components.size(); ++c) {
    if (!cavities[c]) continue;
    const auto around = group_around(body, components[c].front(), solid_of_face);
    if (!around) continue;
    std::vector<FaceId>& faces = components[*around];
    faces.insert(faces.end(), components[c].begin(), components[c].end());
    components[c].clear();
  }
  std::erase_if(components, [](const auto& faces) { return faces.empty(); });
  for (std::vector<FaceId>& faces : components) std::sort(faces.begin(), faces.end());
  std::ranges::sort(components, {}, [](const auto& faces) { return faces.front().index; });
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
                             seam_test(body, copy), uv_sets_of(body, copy)};
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

Extract extract_faces(const Body& body, std::span<const FaceId> faces) {
  Extract out;
  if (faces.empty()) return out;
  KERF_ASSERT(std::is_sorted(faces.begin(), faces.end()));
  const VertexSet vertices(body.mesh, faces);
  std::vector<Vec3> positions;
  positions.reserve(vertices.count());
  vertices.for_each([&](VertexId v) { positions.push_back(body.mesh.position(v)); });
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> number(positions.size());  // of the merged position
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (first[i] == i) out.positions.push_back(body.placement.to_world(positions[i]));
    number[i] = first[i] == i ? static_cast<uint32_t>(out.positions.size() - 1) : number[first[i]];
  }
  const auto number_of = [&](VertexId v) { return number[vertices.rank(v)]; };
  if (!body.mesh.colours().blank()) {
    out.colours.reserve(out.positions.size());
    vertices.for_each([&](VertexId v) {
      if (number_of(v) == out.colours.size()) out.colours.push_back(body.mesh.colours().get(v));
    });
  }
  out.triangles.reserve(faces.size());
  for_each_corners(body.mesh, faces, [&](FaceId f, const std::array<VertexId, 3>& c) {
    out.triangles.push_back({number_of(c[0]), number_of(c[1]), number_of(c[2])});
    if (!body.material_names.empty()) out.materials.push_back(body.mesh.data(f).material);
  });
  measure(out);
  if (body.solid) fill(out);
  return out;
}

MassProperties mass_of(const Extract& extract, const Sheet& sheet) {
  return extract.solid ? solid_of(extract, sheet.density) : shell_of(extract, sheet);
}

std::vector<std::vector<FaceId>> faces_by_piece(const Body& body, bool every_component) {
  std::vector<std::vector<FaceId>> groups;
  std::vector<uint32_t> component;
  if (every_component) {
    groups.resize(label_components(body.mesh, component));
  } else {
    groups.resize(body.pieces.size());
  }
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    groups[every_component ? component[f] : body.mesh.data(FaceId(f)).piece].push_back(FaceId(f));
  }
  if (every_component && body.solid) join_cavities(body, component, groups);
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

}  // namespace kerf
