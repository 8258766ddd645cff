#include "core/shadow/shadow_caster.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/base/hash.h"

namespace kerf {

namespace {

uint32_t bits(float x) { return std::bit_cast<uint32_t>(x); }

uint64_t hash_of(const glm::vec3& at, uint32_t piece) {
  return hash_combine(uint64_t{bits(at.x)} << 32 | bits(at.y), uint64_t{bits(at.z)} << 32 | piece);
}
uint64_t hash_of(uint32_t low, uint32_t high) { return mix64(uint64_t{low} << 32 | high); }

bool comes_before(const glm::vec3& a, const glm::vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

void sort_unique(std::vector<uint32_t>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

}  // namespace

ShadowCaster::ShadowCaster(const Mesh& mesh, const FloatFrame& frame) : frame_(frame) {
  add_all(mesh, nullptr);
}

Result<ShadowCaster> ShadowCaster::build(const Mesh& mesh, const FloatFrame& frame,
                                         const Progress* progress) {
  ShadowCaster caster(frame);
  if (!caster.add_all(mesh, progress)) return cancelled();
  return caster;
}

bool ShadowCaster::add_all(const Mesh& mesh, const Progress* progress) {
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
    const uint32_t piece = mesh.data(FaceId(f)).piece;
    const uint32_t first = find(a, piece), second = find(b, piece);
    put(f, {first, second, find(c, piece)});
  }
  return true;
}

ShadowCaster::Change ShadowCaster::update(const Mesh& mesh, std::span<const uint32_t> slots) {
  Change change;
  grow(mesh.face_slots());
  for (const uint32_t f : slots) {
    assert(f < face_slots());
    change.faces.push_back(f);
    append_edges(f, change.edges);
    take_away(f);
    change.faces.insert(change.faces.end(), copies_.begin(), copies_.end());
    add(mesh, f);
    change.faces.insert(change.faces.end(), copies_.begin(), copies_.end());
    append_edges(f, change.edges);
  }
  sort_unique(change.faces);
  sort_unique(change.edges);
  return change;
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
      hash_of(at, piece), next,
      [&](uint32_t v) { return vertices_[v].at == at && vertices_[v].piece == piece; },
      [&](uint32_t v) { return hash_of(vertices_[v].at, vertices_[v].piece); });
  if (found == next) vertices_.push_back({at, piece});
  return found;
}

uint32_t ShadowCaster::find_side_edge(uint32_t from, uint32_t to) {
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

void ShadowCaster::add(const Mesh& mesh, uint32_t face) {
  copies_.clear();
  if (!mesh.is_live(FaceId(face))) return;
  const Triangle t = mesh.triangle(FaceId(face));
  const uint32_t piece = mesh.data(FaceId(face)).piece;
  std::array<uint32_t, 3> c{};
  for (size_t i = 0; i < 3; ++i) c[i] = find_vertex(t[i], piece);
  put(face, c);
}

void ShadowCaster::put(uint32_t face, const std::array<uint32_t, 3>& c) {
  copies_.clear();
  if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return;
  for (uint32_t i = 0; i < 3; ++i) {
    corner_[3 * face + i] = c[i];
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
    corner_[3 * face + i] = kNone;
  }
  casts_[face] = 0;
  std::erase(copies_, face);
  let_lowest_cast();
}

void ShadowCaster::find_copies(uint32_t face) {
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
  uint32_t* link = &edge.first;
  while (*link != side) {
    assert(*link != kNone);
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

}  // namespace kerf
