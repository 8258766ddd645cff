#include "core/shadow/shadow_volume.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <utility>

#include "core/base/assert.h"
#include "core/base/random.h"

namespace kerf {

namespace {

uint32_t bits(float x) { return std::bit_cast<uint32_t>(x); }

// Omits the piece, so that a vertex whose piece changes keeps its place in the table.
uint64_t hash_of(const glm::vec3& at) {
  return hash_combine(uint64_t{bits(at.x)} << 32 | bits(at.y), bits(at.z));
}
uint64_t hash_of(uint32_t low, uint32_t high) { return mix64(uint64_t{low} << 32 | high); }

uint32_t label_of(const Mesh& mesh, uint32_t face, ShadowCaster::Labels labels) {
  return face < labels.size() ? labels[face] : mesh.data(FaceId(face)).piece;
}

bool comes_before(const glm::vec3& a, const glm::vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Sorts numbers below `count` and removes repeats; large lists by one bit per number.
void sort_unique(std::vector<uint32_t>& all, size_t count) {
  if (all.size() < count / 64) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return;
  }
  std::vector<uint64_t> there(count / 64 + 1);
  for (const uint32_t i : all) there[i / 64] |= uint64_t{1} << i % 64;
  all.clear();
  for (size_t word = 0; word < there.size(); ++word) {
    for (uint64_t left = there[word]; left != 0; left &= left - 1)
      all.push_back(static_cast<uint32_t>(64 * word) + static_cast<uint32_t>(std::countr_zero(left)));
  }
}

}  // namespace

ShadowCaster::ShadowCaster(const Mesh& mesh, const FloatFrame& frame, Labels labels) : frame_(frame) {
  add_all(mesh, labels, nullptr);
}

Result<ShadowCaster> ShadowCaster::build(const Mesh& mesh, const FloatFrame& frame,
                                         const Progress* progress) {
  ShadowCaster caster(frame);
  if (!caster.add_all(mesh, {}, progress)) return cancelled();
  return caster;
}

bool ShadowCaster::add_all(const Mesh& mesh, Labels labels, const Progress* progress) {
  KERF_ASSERT(face_slots() == 0 && edge_slots() == 0);
  const uint32_t faces = mesh.face_slots();
  vertices_.reserve(mesh.vertex_slots());
  edges_.reserve(faces + faces / 2);
  vertex_table_.reserve(mesh.vertex_slots());
  edge_table_.reserve(faces + faces / 2);
  grow(faces);
  std::vector<uint32_t> known(mesh.vertex_slots(), kNone);  // by vertex of the mesh: the vertex found last
  const auto find = [&](VertexId v, uint32_t piece) {
    uint32_t& last = known[v.index];
    if (last == kNone || vertices_[last].piece != piece) last = find_vertex(mesh.position(v), piece);
    return last;
  };
  Pace pace(progress, faces);
  for (uint32_t f = 0; f < faces; ++f) {
    if (!pace.step()) return false;
    if (!mesh.is_live(FaceId(f))) continue;
    const auto [a, b, c] = mesh.corners(FaceId(f));
    const uint32_t piece = label_of(mesh, f, labels);
    const uint32_t first = find(a, piece), second = find(b, piece);
    put(f, {first, second, find(c, piece)});
  }
  return true;
}

ShadowCaster::Change ShadowCaster::update(const Mesh& mesh, std::span<const uint32_t> slots,
                                          std::span<const uint32_t> relabelled, Labels labels) {
  Change change;
  std::vector<uint32_t> each(slots.begin(), slots.end()), unmoved(relabelled.begin(), relabelled.end()),
      others;
  uint32_t slots_end = mesh.face_slots();
  for (const auto* all : {&each, &unmoved}) {
    for (const uint32_t f : *all) slots_end = std::max(slots_end, f + 1);
  }
  grow(slots_end);
  sort_unique(each, face_slots());
  sort_unique(unmoved, face_slots());
  std::vector<Relabelled> faces;
  for (const uint32_t f : each) {
    if (stands_still(mesh, f)) {
      record_label(f, label_of(mesh, f, labels), faces);
    } else {
      others.push_back(f);
    }
  }
  for (const uint32_t f : unmoved) {
    const bool label_alone =
        there(f) && mesh.is_live(FaceId(f)) && !std::binary_search(each.begin(), each.end(), f);
    if (label_alone) record_label(f, label_of(mesh, f, labels), faces);
  }
  const std::vector<uint32_t> torn = relabel(faces, change);
  others.insert(others.end(), torn.begin(), torn.end());
  for (const uint32_t f : others) {
    assert(f < face_slots());
    change.faces.push_back(f);
    append_edges(f, change.edges);
    take_away(f);
    change.faces.insert(change.faces.end(), copies_.begin(), copies_.end());
    add(mesh, f, labels);
    change.faces.insert(change.faces.end(), copies_.begin(), copies_.end());
    append_edges(f, change.edges);
  }
  sort_unique(change.faces, face_slots());
  sort_unique(change.edges, edge_slots());
  return change;
}

// Returns true if the face is live, was added and has its corners of the mesh.
bool ShadowCaster::stands_still(const Mesh& mesh, uint32_t face) const {
  if (!there(face) || !mesh.is_live(FaceId(face))) return false;
  const Triangle t = mesh.triangle(FaceId(face));
  for (uint32_t i = 0; i < 3; ++i) {
    if (vertices_[corner_[3 * face + i]].at != frame_.to_float(t[i]) + 0.0f) return false;
  }
  return true;
}

// Appends the face to `out` if its label changes.
void ShadowCaster::record_label(uint32_t face, uint32_t label, std::vector<Relabelled>& out) const {
  assert(there(face));
  const uint32_t from = vertices_[corner_[3 * face]].piece;
  if (from != label) out.push_back({face, from, label});
}

// Relabels the vertices of faces that are only relabelled if no other face uses them; `uses` temporarily
// excludes those faces. Returns the faces to remove and add instead: those at a vertex that keeps its label
// or gets another one.
std::vector<uint32_t> ShadowCaster::relabel(std::span<const Relabelled> faces, Change& change) {
  std::vector<uint32_t> others;
  const auto for_each_corner = [&](const Relabelled& r, const auto& visit) {
    for (uint32_t i = 0; i < 3; ++i) visit(corner_[3 * r.face + i]);
  };
  for (const Relabelled& r : faces) for_each_corner(r, [&](uint32_t v) { --vertices_[v].uses; });
  for (const Relabelled& r : faces) {
    for_each_corner(r, [&](uint32_t v) {
      if (vertices_[v].uses == 0 && vertices_[v].piece == r.from) rename_vertex(v, r.to);
    });
  }
  for (const Relabelled& r : faces) for_each_corner(r, [&](uint32_t v) { ++vertices_[v].uses; });
  for (const Relabelled& r : faces) {
    bool all = true;
    for_each_corner(r, [&](uint32_t v) { all = all && vertices_[v].piece == r.to; });
    if (!all) {
      others.push_back(r.face);
      continue;
    }
    change.faces.push_back(r.face);
    append_edges(r.face, change.edges);
  }
  return others;
}

// No-op if faces of that piece use another vertex at the same position. An unused one takes over the old
// label, so that no two vertices have the same position and label.
void ShadowCaster::rename_vertex(uint32_t vertex, uint32_t piece) {
  Vertex& renamed = vertices_[vertex];
  const uint32_t other = known_vertex(renamed.at, piece);
  if (other != kNone && vertices_[other].uses > 0) return;
  if (other != kNone) vertices_[other].piece = renamed.piece;
  renamed.piece = piece;
}

std::array<glm::vec3, 3> ShadowCaster::corners(uint32_t face) const {
  assert(casts(face));
  const uint32_t* c = &corner_[3 * face];
  return {vertices_[c[0]].at, vertices_[c[1]].at, vertices_[c[2]].at};
}

ShadowCaster::Ends ShadowCaster::ends(uint32_t edge) const {
  assert(edge < edge_slots());
  const Vertex &low = vertices_[edges_[edge].low], &high = vertices_[edges_[edge].high];
  return {low.at, high.at, low.piece};
}

void ShadowCaster::grow(uint32_t faces) {
  if (faces <= face_slots()) return;
  corner_.resize(3 * size_t{faces}, kNone);
  sides_.resize(3 * size_t{faces}, {kNone, kNone});
  casts_.resize(faces, 0);
}

uint32_t ShadowCaster::find_vertex(const Vec3& p, uint32_t piece) {
  const glm::vec3 at = frame_.to_float(p) + 0.0f;  // -0.0 becomes +0.0
  const auto next = static_cast<uint32_t>(vertices_.size());
  const uint32_t found = vertex_table_.find_or_add(
      hash_of(at), next, [&](uint32_t v) { return vertices_[v].at == at && vertices_[v].piece == piece; },
      [&](uint32_t v) { return hash_of(vertices_[v].at); });
  if (found == next) vertices_.push_back({at, piece, 0});
  return found;
}

uint32_t ShadowCaster::known_vertex(const glm::vec3& at, uint32_t piece) const {
  return vertex_table_.find(hash_of(at),
                            [&](uint32_t v) { return vertices_[v].at == at && vertices_[v].piece == piece; });
}

uint32_t ShadowCaster::find_side_edge(uint32_t from, uint32_t to) {
  assert(from != to);
  const bool reversed = comes_before(vertices_[to].at, vertices_[from].at);
  const uint32_t low = reversed ? to : from, high = reversed ? from : to;
  const auto next = static_cast<uint32_t>(edges_.size());
  const uint32_t found = edge_table_.find_or_add(
      hash_of(low, high), next, [&](uint32_t e) { return edges_[e].low == low && edges_[e].high == high; },
      [&](uint32_t e) { return hash_of(edges_[e].low, edges_[e].high); });
  if (found == next) edges_.push_back({low, high, kNone, 0});
  return 2 * found + (reversed ? 1 : 0);
}

std::array<uint32_t, 3> ShadowCaster::sorted_corners(uint32_t face) const {
  std::array<uint32_t, 3> c{corner_[3 * face], corner_[3 * face + 1], corner_[3 * face + 2]};
  std::sort(c.begin(), c.end());
  return c;
}

void ShadowCaster::add(const Mesh& mesh, uint32_t face, Labels labels) {
  copies_.clear();
  if (!mesh.is_live(FaceId(face))) return;
  const Triangle t = mesh.triangle(FaceId(face));
  const uint32_t piece = label_of(mesh, face, labels);
  std::array<uint32_t, 3> c{};
  for (size_t i = 0; i < 3; ++i) c[i] = find_vertex(t[i], piece);
  put(face, c);
}

void ShadowCaster::put(uint32_t face, const std::array<uint32_t, 3>& c) {
  assert(face < face_slots() && !there(face));
  copies_.clear();
  if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return;
  for (uint32_t i = 0; i < 3; ++i) {
    corner_[3 * face + i] = c[i];
    ++vertices_[c[i]].uses;
    link(3 * face + i, find_side_edge(c[i], c[(i + 1) % 3]));
  }
  find_copies(face);
  let_lowest_cast();
}

void ShadowCaster::take_away(uint32_t face) {
  copies_.clear();
  if (!there(face)) return;
  find_copies(face);
  for (uint32_t i = 0; i < 3; ++i) {
    unlink(3 * face + i);
    assert(vertices_[corner_[3 * face + i]].uses > 0);
    --vertices_[corner_[3 * face + i]].uses;
    corner_[3 * face + i] = kNone;
  }
  casts_[face] = 0;
  std::erase(copies_, face);
  let_lowest_cast();
}

void ShadowCaster::find_copies(uint32_t face) {
  assert(there(face));
  uint32_t shortest = sides_[3 * face].edge >> 1;
  for (uint32_t i = 1; i < 3; ++i) {
    const uint32_t e = sides_[3 * face + i].edge >> 1;
    if (edges_[e].faces < edges_[shortest].faces) shortest = e;
  }
  if (edges_[shortest].faces == 1) return copies_.push_back(face);
  const std::array<uint32_t, 3> wanted = sorted_corners(face);
  for_each_face_on(shortest, [&](uint32_t f, int) {
    if (sorted_corners(f) == wanted) copies_.push_back(f);
  });
}

void ShadowCaster::let_lowest_cast() {
  if (copies_.empty()) return;
  const uint32_t lowest = *std::min_element(copies_.begin(), copies_.end());
  for (const uint32_t f : copies_) casts_[f] = f == lowest;
}

void ShadowCaster::append_edges(uint32_t face, std::vector<uint32_t>& out) const {
  if (!there(face)) return;
  for (uint32_t i = 0; i < 3; ++i) out.push_back(sides_[3 * face + i].edge >> 1);
}

void ShadowCaster::link(uint32_t side, uint32_t edge_and_way) {
  Edge& edge = edges_[edge_and_way >> 1];
  sides_[side] = {edge_and_way, edge.first};
  edge.first = side;
  ++edge.faces;
}

void ShadowCaster::unlink(uint32_t side) {
  Edge& edge = edges_[sides_[side].edge >> 1];
  KERF_ASSERT(edge.faces > 0);
  uint32_t* link = &edge.first;
  while (*link != side) {
    KERF_ASSERT(*link != kNone);
    link = &sides_[*link].next;
  }
  *link = sides_[side].next;
  --edge.faces;
}

size_t ShadowCaster::bytes() const {
  return vertices_.capacity() * sizeof(Vertex) + edges_.capacity() * sizeof(Edge) +
         corner_.capacity() * sizeof(uint32_t) + sides_.capacity() * sizeof(Side) + casts_.capacity() +
         vertex_table_.bytes() + edge_table_.bytes();
}

int light_side(const std::array<glm::vec3, 3>& triangle, const LightPoint& light) {
  const Vec3 a(triangle[0]), b(triangle[1]), c(triangle[2]);
  const double side = glm::dot(glm::cross(b - a, c - a), light.xyz - a * light.w);
  return (side > 0) - (side < 0);
}

int8_t ShadowVolume::facing(const ShadowCaster& caster, uint32_t face) const {
  if (!caster.casts(face)) return 0;
  const LightPoint* light = &light_.light;
  if (!light_.pieces.empty()) {
    const uint32_t piece = caster.piece(face);
    if (piece < light_.pieces.size()) {
      if (!light_.pieces[piece]) return 0;
      light = &*light_.pieces[piece];
    }
  }
  return static_cast<int8_t>(light_side(caster.corners(face), *light));
}

int ShadowVolume::multiplicity(const ShadowCaster& caster, uint32_t edge) const {
  if (method_ == ShadowMethod::kRobust) {
    int sum = 0;
    caster.for_each_face_on(edge, [&](uint32_t face, int along) { sum += signs_[face] * along; });
    return sum;
  }
  // An edge shared by two polygons of a volume is not in its silhouette, whatever their orientation.
  int facing_sides = 0, facing_faces = 0, averted_sides = 0, averted_faces = 0;
  caster.for_each_face_on(edge, [&](uint32_t face, int along) {
    const int sign = signs_[face];
    (sign > 0 ? facing_sides : averted_sides) += sign * along;
    (sign > 0 ? facing_faces : averted_faces) += std::abs(sign);
  });
  const bool two = method_ == ShadowMethod::kPaperTwoVolumes;
  return (facing_faces == 1 ? facing_sides : 0) + (two && averted_faces == 1 ? averted_sides : 0);
}

void ShadowVolume::put(uint32_t edge, int multiplicity) {
  assert(edge < place_.size());
  uint32_t& place = place_[edge];
  if (multiplicity == 0) {
    if (place == kNone) return;
    assert(place < silhouette_.size() && silhouette_[place].edge == edge);
    touched_.places.push_back(place);
    silhouette_[place] = silhouette_.back();
    place_[silhouette_[place].edge] = place;
    silhouette_.pop_back();
    place = kNone;
    return;
  }
  if (place == kNone) {
    place = static_cast<uint32_t>(silhouette_.size());
    silhouette_.emplace_back();
  }
  silhouette_[place] = {edge, multiplicity};
  touched_.places.push_back(place);
}

void ShadowVolume::rebuild(const ShadowCaster& caster, LightOnBody light) {
  light_ = std::move(light);
  KERF_ASSERT(light_.light.w == 1 || (light_.light.w == 0 && light_.light.xyz != Vec3(0)));
  const uint32_t faces = caster.face_slots(), edges = caster.edge_slots();
  signs_.resize(faces);
  for (uint32_t f = 0; f < faces; ++f) signs_[f] = facing(caster, f);
  place_.assign(edges, kNone);
  silhouette_.clear();
  for (uint32_t e = 0; e < edges; ++e) {
    const int m = multiplicity(caster, e);
    if (m == 0) continue;
    place_[e] = static_cast<uint32_t>(silhouette_.size());
    silhouette_.push_back({e, m});
  }
  touched_ = {};
  effort_.faces += faces;
  effort_.edges += edges;
}

void ShadowVolume::follow(const ShadowCaster& caster, const ShadowCaster::Change& change) {
  KERF_ASSERT(signs_.size() <= caster.face_slots() && place_.size() <= caster.edge_slots());
  signs_.resize(caster.face_slots(), 0);
  place_.resize(caster.edge_slots(), kNone);
  for (const uint32_t f : change.faces) signs_[f] = facing(caster, f);
  for (const uint32_t e : change.edges) put(e, multiplicity(caster, e));
  effort_.faces += change.faces.size();
  effort_.edges += change.edges.size();
  if (!touched_.all) touched_.faces.insert(touched_.faces.end(), change.faces.begin(), change.faces.end());
}

ShadowVolume::Touched ShadowVolume::take_touched() {
  Touched touched = std::move(touched_);
  touched_ = {};
  touched_.all = false;
  return touched;
}

size_t ShadowVolume::bytes() const {
  return signs_.capacity() + silhouette_.capacity() * sizeof(SilhouetteEdge) +
         place_.capacity() * sizeof(uint32_t);
}

}  // namespace kerf
