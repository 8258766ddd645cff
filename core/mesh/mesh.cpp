#include "core/mesh/mesh.h"

#include <cassert>

#include "core/mesh/kernel.h"
#include "core/mesh/rings.h"
#include "core/mesh/weld.h"

namespace kerf {

Mesh::Mesh() : kernel_(std::make_unique<Kernel>()) {}
Mesh::~Mesh() = default;
Mesh::Mesh(Mesh&&) noexcept = default;
Mesh& Mesh::operator=(Mesh&&) noexcept = default;
Mesh::Mesh(const Mesh& other) : kernel_(std::make_unique<Kernel>(*other.kernel_)) {}
Mesh& Mesh::operator=(const Mesh& other) {
  if (this != &other) kernel_ = std::make_unique<Kernel>(*other.kernel_);
  return *this;
}

uint32_t Mesh::face_slots() const { return static_cast<uint32_t>(kernel_->half_edges.n_faces()); }
uint32_t Mesh::vertex_slots() const { return static_cast<uint32_t>(kernel_->half_edges.n_vertices()); }
uint32_t Mesh::live_faces() const { return kernel_->live_faces; }

bool Mesh::is_live(FaceId f) const { return !kernel_->half_edges.status(handle(f)).deleted(); }

Vec3 Mesh::position(VertexId v) const { return to_vec3(kernel_->half_edges.point(handle(v))); }

std::array<VertexId, 3> Mesh::corners(FaceId f) const {
  const HalfEdges& m = kernel_->half_edges;
  const HalfedgeHandle h = m.halfedge_handle(handle(f)), n = m.next_halfedge_handle(h);
  return {vertex_id(m.from_vertex_handle(h)), vertex_id(m.to_vertex_handle(h)),
          vertex_id(m.to_vertex_handle(n))};
}

Triangle Mesh::triangle(FaceId f) const {
  const auto c = corners(f);
  return {position(c[0]), position(c[1]), position(c[2])};
}

const double* Mesh::coordinates() const { return kernel_->half_edges.points()->data(); }

const FaceData& Mesh::data(FaceId f) const { return kernel_->faces[f.index]; }
FaceData& Mesh::data(FaceId f) { return kernel_->faces[f.index]; }

namespace {

// The half-edge of face f that starts at vertex `from`.
HalfedgeHandle half_edge_from(const HalfEdges& m, FaceId f, VertexId from) {
  HalfedgeHandle h = m.halfedge_handle(handle(f));
  for (int i = 0; i < 2 && m.from_vertex_handle(h) != handle(from); ++i) h = m.next_halfedge_handle(h);
  assert(m.from_vertex_handle(h) == handle(from));
  return h;
}

// Visits every half-edge that bounds a face on the edge of h, over its ring.
template <typename Visit>
void for_each_side(const Mesh::Kernel& k, HalfedgeHandle h, Visit visit) {
  HalfedgeHandle member = h;
  do {
    for (const HalfedgeHandle side : {member, k.half_edges.opposite_halfedge_handle(member)}) {
      if (k.half_edges.face_handle(side).is_valid()) visit(side);
    }
    member = next_in_ring(k, member);
  } while (member != h);
}

// The half-edge of a face from one position to another; invalid where the face has none.
HalfedgeHandle side_between(const HalfEdges& m, OpenMesh::FaceHandle face, const OpenMesh::Vec3d& from,
                            const OpenMesh::Vec3d& to) {
  if (!face.is_valid()) return HalfedgeHandle();
  HalfedgeHandle h = m.halfedge_handle(face);
  for (int i = 0; i < 3; ++i, h = m.next_halfedge_handle(h)) {
    const auto &a = m.point(m.from_vertex_handle(h)), &b = m.point(m.to_vertex_handle(h));
    if (a == from && b == to) return h;
    if (a == to && b == from) return m.opposite_halfedge_handle(h);
  }
  return HalfedgeHandle();
}

// The half-edge from one position to another in a face on the edge of `member`, of another edge than h.
HalfedgeHandle copy_beside(const HalfEdges& m, HalfedgeHandle member, HalfedgeHandle h) {
  const auto &from = m.point(m.from_vertex_handle(h)), &to = m.point(m.to_vertex_handle(h));
  for (const HalfedgeHandle side : {member, m.opposite_halfedge_handle(member)}) {
    const HalfedgeHandle copy = side_between(m, m.face_handle(side), from, to);
    if (copy.is_valid() && m.edge_handle(copy) != m.edge_handle(h)) return copy;
  }
  return HalfedgeHandle();
}

// Faces that lie on one another share all their edges, those that splitting makes inside them too. h is an
// edge that was just turned over: if a face on the rings of both its neighbour edges has the same edge
// already, they are linked. Both rings are searched at once, each both ways, until one ends: one may be long
// where the other is short, and copies of a face are split one after the other.
void link_to_copy(Mesh::Kernel& k, HalfedgeHandle h) {
  if (k.rings.empty()) return;
  const HalfEdges& m = k.half_edges;
  struct Search {
    HalfedgeHandle start, forward, backward;
  };
  std::array<Search, 2> searches;
  const std::array<HalfedgeHandle, 2> beside{m.next_halfedge_handle(h), m.prev_halfedge_handle(h)};
  for (size_t i = 0; i < 2; ++i)
    searches[i] = {beside[i], next_in_ring(k, beside[i]), previous_in_ring(k, beside[i])};
  for (;;) {
    for (Search& s : searches) {
      if (s.forward == s.start) return;
      for (const HalfedgeHandle member : {s.forward, s.backward}) {
        const HalfedgeHandle copy = copy_beside(m, member, h);
        if (copy.is_valid()) return join_ring(k, h, copy);
      }
      s.forward = next_in_ring(k, s.forward);
      s.backward = previous_in_ring(k, s.backward);
    }
  }
}

// One edge, bisected: where its two halves are, both in the direction of the half-edge that was split.
struct Halves {
  HalfedgeHandle near_from;
  HalfedgeHandle near_to;
};

FaceId new_face_data(Mesh::Kernel& k, FaceId parent, FaceId& next_new) {
  const FaceId added = next_new;
  next_new = FaceId(next_new.index + 1);
  k.faces.push_back(k.faces[parent.index]);
  ++k.live_faces;
  return added;
}

// Bisects the edge of h and its one or two faces, and appends what became of them: first the face of h.
Halves bisect(Mesh::Kernel& k, HalfedgeHandle h, const OpenMesh::Vec3d& at,
              std::vector<Mesh::FaceSplit>& out) {
  HalfEdges& m = k.half_edges;
  const EdgeHandle edge = m.edge_handle(h);
  const EdgeHandle new_edge(static_cast<int>(m.n_edges()));
  const HalfedgeHandle h0 = m.halfedge_handle(edge, 0), o0 = m.halfedge_handle(edge, 1);
  const VertexId tail = vertex_id(m.from_vertex_handle(h0)), head = vertex_id(m.to_vertex_handle(h0));
  const auto left = m.face_handle(h0), right = m.face_handle(o0);
  FaceId next_new(static_cast<uint32_t>(m.n_faces()));

  const auto middle = m.new_vertex(at);
  m.split(edge, middle);  // h0 now runs middle -> head, o0 head -> middle; the faces of both keep their slots

  const size_t first = out.size();
  const VertexId mid = vertex_id(middle);
  if (left.is_valid()) {
    out.push_back({face_id(left), new_face_data(k, face_id(left), next_new), mid, tail, head, head});
  }
  if (right.is_valid()) {
    out.push_back({face_id(right), new_face_data(k, face_id(right), next_new), mid, head, tail, head});
  }
  if (h != h0 && out.size() - first == 2) std::swap(out[first], out[first + 1]);
  if (!k.rings.empty()) add_lone_rings(k);  // the edges that were just made

  const HalfedgeHandle outward = m.halfedge_handle(new_edge, 0);  // middle -> tail
  if (h == h0) return {m.opposite_halfedge_handle(outward), h0};
  return {o0, outward};
}

// Where faces that lie on one another were bisected, their bisectors lie on one another.
void link_bisectors(Mesh::Kernel& k, std::span<const Mesh::FaceSplit> splits) {
  const HalfEdges& m = k.half_edges;
  std::vector<HalfedgeHandle> bisectors;  // from the midpoint to the corner opposite
  std::vector<Vec3> opposite;
  for (const Mesh::FaceSplit& s : splits) {
    const FaceId before_midpoint =
        s.kept_end == s.from ? s.kept : s.added;  // its sides: from, midpoint, opposite
    bisectors.push_back(half_edge_from(m, before_midpoint, s.midpoint));
    opposite.push_back(to_vec3(m.point(m.to_vertex_handle(bisectors.back()))));
  }
  const std::vector<uint32_t> first = weld_positions(opposite);
  for (uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) join_ring(k, bisectors[i], bisectors[first[i]]);
  }
}

}  // namespace

void Mesh::append_neighbours(FaceId f, std::vector<FaceId>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  HalfedgeHandle h = m.halfedge_handle(handle(f));
  for (int i = 0; i < 3; ++i, h = m.next_halfedge_handle(h)) {
    for_each_side(*kernel_, h, [&](HalfedgeHandle side) {
      if (m.face_handle(side) != handle(f)) out.push_back(face_id(m.face_handle(side)));
    });
  }
}

void Mesh::append_nearest_neighbours(FaceId f, std::vector<FaceId>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  // A member of a ring has one face or two, which are beside each other.
  const auto append_one = [&](HalfedgeHandle member) {
    const auto face = m.face_handle(member);
    out.push_back(face_id(face.is_valid() ? face : m.face_handle(m.opposite_halfedge_handle(member))));
  };
  HalfedgeHandle h = m.halfedge_handle(handle(f));
  for (int i = 0; i < 3; ++i, h = m.next_halfedge_handle(h)) {
    const auto across = m.face_handle(m.opposite_halfedge_handle(h));
    if (across.is_valid()) out.push_back(face_id(across));
    const HalfedgeHandle next = next_in_ring(*kernel_, h), previous = previous_in_ring(*kernel_, h);
    if (next != h) append_one(next);
    if (previous != next) append_one(previous);
  }
}

void Mesh::append_edge_sides(FaceId f, VertexId from, VertexId to, std::vector<Side>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  const HalfedgeHandle h = half_edge_from(m, f, from);
  assert(m.to_vertex_handle(h) == handle(to));
  (void)to;
  for_each_side(*kernel_, h, [&](HalfedgeHandle side) {
    if (side == h) return;
    out.push_back({face_id(m.face_handle(side)), vertex_id(m.from_vertex_handle(side)),
                   vertex_id(m.to_vertex_handle(side))});
  });
}

void Mesh::star(VertexId v, Star& out) const {
  const HalfEdges& m = kernel_->half_edges;
  out.faces.clear();
  out.rim.clear();
  out.alone = true;
  for (auto h = m.cvoh_iter(handle(v)); h.is_valid(); ++h) {
    const auto left = m.face_handle(*h), right = m.face_handle(m.opposite_halfedge_handle(*h));
    if (left.is_valid()) out.faces.push_back(face_id(left));
    if (left.is_valid() != right.is_valid()) out.rim.push_back(vertex_id(m.to_vertex_handle(*h)));
    if (next_in_ring(*kernel_, *h) != *h) out.alone = false;
  }
}

void Mesh::move_vertex(VertexId v, const Vec3& to) { kernel_->half_edges.set_point(handle(v), to_point(to)); }

void Mesh::split_edge(FaceId f, VertexId from, VertexId to, std::vector<FaceSplit>& out) {
  split_edge_at(f, from, to, 0.5 * position(from) + 0.5 * position(to), out);
}

void Mesh::split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at, std::vector<FaceSplit>& out) {
  Kernel& k = *kernel_;
  HalfEdges& m = k.half_edges;
  const HalfedgeHandle start = half_edge_from(m, f, from);
  assert(m.to_vertex_handle(start) == handle(to));
  (void)to;

  const size_t first = out.size();
  std::vector<HalfedgeHandle> members{start};
  for (HalfedgeHandle h = next_in_ring(k, start); h != start; h = next_in_ring(k, h)) members.push_back(h);
  std::vector<HalfedgeHandle> near_from, near_to;
  for (const HalfedgeHandle h : members) {
    const Halves halves = bisect(k, h, to_point(at), out);
    near_from.push_back(halves.near_from);
    near_to.push_back(halves.near_to);
  }
  if (members.size() == 1) return;
  link_ring(k, near_from);
  link_ring(k, near_to);
  link_bisectors(k, {out.data() + first, out.size() - first});
}

void Mesh::flip_edge(FaceId f, VertexId from, VertexId to) {
  HalfEdges& m = kernel_->half_edges;
  const HalfedgeHandle a0 = half_edge_from(m, f, from), b0 = m.opposite_halfedge_handle(a0);
  assert(m.to_vertex_handle(a0) == handle(to));
  const HalfedgeHandle a1 = m.next_halfedge_handle(a0), a2 = m.next_halfedge_handle(a1);
  const HalfedgeHandle b1 = m.next_halfedge_handle(b0), b2 = m.next_halfedge_handle(b1);
  const auto fa = m.face_handle(a0), fb = m.face_handle(b0);
  assert(fa.is_valid() && fb.is_valid());
  leave_ring(*kernel_, m.edge_handle(a0));

  if (m.halfedge_handle(handle(from)) == a0) m.set_halfedge_handle(handle(from), b1);
  if (m.halfedge_handle(handle(to)) == b0) m.set_halfedge_handle(handle(to), a1);
  m.set_vertex_handle(a0, m.to_vertex_handle(a1));
  m.set_vertex_handle(b0, m.to_vertex_handle(b1));
  const auto close = [&](HalfedgeHandle x, HalfedgeHandle y, HalfedgeHandle z, OpenMesh::FaceHandle face) {
    m.set_next_halfedge_handle(x, y);
    m.set_next_halfedge_handle(y, z);
    m.set_next_halfedge_handle(z, x);
    for (const HalfedgeHandle h : {x, y, z}) m.set_face_handle(h, face);
    m.set_halfedge_handle(face, x);
  };
  close(a0, a2, b1, fa);
  close(b0, b2, a1, fb);
  link_to_copy(*kernel_, a0);
}

bool Mesh::can_flip_edge(FaceId f, VertexId from, VertexId to) const {
  const HalfEdges& m = kernel_->half_edges;
  const HalfedgeHandle h = half_edge_from(m, f, from), o = m.opposite_halfedge_handle(h);
  assert(m.to_vertex_handle(h) == handle(to));
  (void)to;
  if (!m.face_handle(o).is_valid() || next_in_ring(*kernel_, h) != h) return false;
  const auto left = m.to_vertex_handle(m.next_halfedge_handle(h));
  const auto right = m.to_vertex_handle(m.next_halfedge_handle(o));
  return left != right && !m.find_halfedge(left, right).is_valid();
}

void Mesh::remove_face(FaceId f) {
  HalfEdges& m = kernel_->half_edges;
  assert(is_live(f));
  HalfedgeHandle h = m.halfedge_handle(handle(f));
  for (int i = 0; i < 3; ++i, h = m.next_halfedge_handle(h)) {
    if (!m.face_handle(m.opposite_halfedge_handle(h)).is_valid()) leave_ring(*kernel_, m.edge_handle(h));
  }
  m.delete_face(handle(f), true);
  --kernel_->live_faces;
}

void Mesh::reserve_more(uint32_t faces) {
  HalfEdges& m = kernel_->half_edges;
  m.reserve(m.n_vertices() + faces, m.n_edges() + 2 * size_t{faces}, m.n_faces() + faces);
  kernel_->faces.reserve(m.n_faces() + faces);
  if (!kernel_->rings.empty()) kernel_->rings.reserve(m.n_edges() + 2 * size_t{faces});
}

}  // namespace kerf
