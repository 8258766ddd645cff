#include "core/mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/half_edges_internal.h"
#include "core/mesh/weld.h"

namespace kerf {

void FaceColumns::Column::set(FaceId f, uint64_t cell) {
  const uint64_t before = get(f);
  if (before == cell) return;
  cells.grow_to(f.index + 1);
  filled.grow_to(f.index / kBlock + 1);
  cells.edit(f.index) = cell;
  if (before == 0) ++filled.edit(f.index / kBlock);
  if (cell == 0) --filled.edit(f.index / kBlock);
}

void FaceColumns::Column::share_sum(FaceId a, FaceId b, double share) {
  if (get(a) == 0 && get(b) == 0) return;
  const double sum = from_cell<double>(get(a)) + from_cell<double>(get(b)), first = share * sum;
  set(a, to_cell(first));
  set(b, to_cell(sum - first));
}

uint32_t FaceColumns::attach(Rule rule) {
  columns_.push_back({rule, {}, {}});
  return static_cast<uint32_t>(columns_.size() - 1);
}

void FaceColumns::record_split(FaceId kept, FaceId added, double share) {
  for (Column& column : columns_) {
    if (column.rule == Rule::kCopy) {
      column.set(added, column.get(kept));
    } else {
      column.share_sum(kept, added, share);
    }
  }
}

void FaceColumns::record_flipped(FaceId a, FaceId b, double share) {
  for (Column& column : columns_) {
    if (column.rule == Rule::kShareByArea) column.share_sum(a, b, share);
  }
}

void FaceColumns::record_removed(FaceId f) {
  for (Column& column : columns_) column.set(f, 0);
}

FaceColumns FaceColumns::extract(std::span<const FaceId> faces) const {
  FaceColumns extracted;
  for (const Column& column : columns_) {
    Column& own = extracted.columns_.emplace_back(Column{column.rule, {}, {}});
    for (uint32_t f = 0; f < faces.size(); ++f) own.set(FaceId(f), column.get(faces[f]));
  }
  return extracted;
}

bool FaceColumns::blank() const {
  return std::all_of(columns_.begin(), columns_.end(), [](const Column& c) { return c.cells.empty(); });
}

size_t FaceColumns::bytes() const {
  size_t bytes = 0;
  for (const Column& column : columns_) bytes += ChangeOfParts<Column>::bytes_of(column);
  return bytes;
}

// Undo ------------------------------------------------------------------------------------------------------

void FaceColumns::Change::begin(FaceColumns& columns) {
  changes_.resize(columns.columns_.size());
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].begin(columns.columns_[i]);
}

void FaceColumns::Change::end(FaceColumns& columns) {
  KERF_ASSERT(changes_.size() == columns.columns_.size() && "a column was attached within a command");
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].end(columns.columns_[i]);
}

bool FaceColumns::Change::any() const {
  return std::any_of(changes_.begin(), changes_.end(), [](const auto& change) { return change.any(); });
}

void FaceColumns::Change::exchange(FaceColumns& columns) {
  KERF_ASSERT(changes_.size() == columns.columns_.size());
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].exchange(columns.columns_[i]);
}

void FaceColumns::Change::restore(FaceColumns& columns) const {
  KERF_ASSERT(changes_.size() == columns.columns_.size());
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].restore(columns.columns_[i]);
}

size_t FaceColumns::Change::bytes() const {
  size_t bytes = 0;
  for (const auto& change : changes_) bytes += change.bytes();
  return bytes;
}

void VertexColours::set(VertexId v, const VertexColour& colour) {
  assert(v.valid());
  while (cells_.size() <= v.index) cells_.push_back(VertexColour());
  cells_.edit(v.index) = colour;
}

namespace {

double half_cross(const Vec3& u, const Vec3& v) { return 0.5 * glm::length(glm::cross(u, v)); }

Vec3 times_power_of_two(const Vec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace

double triangle_area(const Triangle& t) {
  constexpr double kMinPlain = 0x1p-511;  // m^2; the squares in the length of smaller ones lose digits
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  const double area = half_cross(u, v);
  if (area >= kMinPlain && std::isfinite(area)) return area;
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max({longest, std::abs(u[k]), std::abs(v[k])});
  if (!(longest > 0) || !std::isfinite(longest)) return area;
  const int exponent = std::ilogb(longest);
  return std::ldexp(half_cross(times_power_of_two(u, -exponent), times_power_of_two(v, -exponent)),
                    2 * exponent);
}

double longest_edge2(const Triangle& t) {
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i];
    longest = std::max(longest, glm::dot(edge, edge));
  }
  return longest;
}

double largest_cosine(const Triangle& t) {
  double largest = -1;
  for (int i = 0; i < 3; ++i) {
    const Vec3 u = t[(i + 1) % 3] - t[i], w = t[(i + 2) % 3] - t[i];
    const double lengths = std::sqrt(glm::dot(u, u)) * std::sqrt(glm::dot(w, w));
    largest = std::max(largest, lengths > 0 ? std::min(1.0, glm::dot(u, w) / lengths) : 1.0);
  }
  return largest;
}

Mesh::Mesh() : kernel_(std::make_unique<Kernel>()) {}
Mesh::~Mesh() = default;
Mesh::Mesh(Mesh&&) noexcept = default;
Mesh& Mesh::operator=(Mesh&&) noexcept = default;
Mesh::Mesh(const Mesh& other) : kernel_(std::make_unique<Kernel>(*other.kernel_)) {}
Mesh& Mesh::operator=(const Mesh& other) {
  if (this != &other) kernel_ = std::make_unique<Kernel>(*other.kernel_);
  return *this;
}

uint32_t Mesh::face_slots() const { return kernel_->half_edges.faces(); }
uint32_t Mesh::vertex_slots() const { return kernel_->half_edges.vertices(); }
uint32_t Mesh::edge_slots() const { return kernel_->half_edges.edges(); }
uint32_t Mesh::live_faces() const { return kernel_->live_faces; }

bool Mesh::is_live(FaceId f) const { return f.index < face_slots() && kernel_->half_edges.first(f).valid(); }

Vec3 Mesh::position(VertexId v) const { return kernel_->half_edges.position(v); }

std::array<VertexId, 3> Mesh::corners(FaceId f) const {
  assert(is_live(f));
  const HalfEdges& m = kernel_->half_edges;
  const HalfEdgeId h = m.first(f), n = m.next(h);
  return {m.from(h), m.to(h), m.to(n)};
}

bool Mesh::has_side(FaceId f, VertexId from, VertexId to) const {
  const auto c = corners(f);
  return (c[0] == from && c[1] == to) || (c[1] == from && c[2] == to) || (c[2] == from && c[0] == to);
}

Triangle Mesh::triangle(FaceId f) const {
  const auto c = corners(f);
  return {position(c[0]), position(c[1]), position(c[2])};
}

Positions Mesh::positions() const { return Positions(kernel_->half_edges.position_chunks()); }

const FaceData& Mesh::data(FaceId f) const { return kernel_->faces[f.index]; }
FaceData& Mesh::edit_data(FaceId f) { return kernel_->faces.edit(f.index); }

const FaceColumns& Mesh::columns() const { return kernel_->columns; }
FaceColumns& Mesh::columns() { return kernel_->columns; }

const VertexColours& Mesh::colours() const { return kernel_->colours; }
VertexColours& Mesh::colours() { return kernel_->colours; }

namespace {

HalfEdgeId half_edge_from(const HalfEdges& m, FaceId f, VertexId from) {
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 2 && m.from(h) != from; ++i) h = m.next(h);
  KERF_ASSERT(m.from(h) == from);
  return h;
}

// Calls visit(side) for every half-edge with a face on the edge of h, over its ring.
template <typename Visit>
void for_each_side(const Mesh::Kernel& k, HalfEdgeId h, Visit visit) {
  HalfEdgeId member = h;
  do {
    for (const HalfEdgeId side : {member, opposite(member)}) {
      if (k.half_edges.face(side).valid()) visit(side);
    }
    member = next_in_ring(k, member);
  } while (member != h);
}

// Returns the half-edge of a face between two positions; invalid if the face has none.
HalfEdgeId side_between(const HalfEdges& m, FaceId face, const Vec3& from, const Vec3& to) {
  if (!face.valid()) return HalfEdgeId();
  HalfEdgeId h = m.first(face);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    const auto &a = m.position(m.from(h)), &b = m.position(m.to(h));
    if (a == from && b == to) return h;
    if (a == to && b == from) return opposite(h);
  }
  return HalfEdgeId();
}

// Finds a coincident copy of h in a face on the edge of `member`; invalid if there is none.
HalfEdgeId copy_beside(const HalfEdges& m, HalfEdgeId member, HalfEdgeId h) {
  const auto &from = m.position(m.from(h)), &to = m.position(m.to(h));
  for (const HalfEdgeId side : {member, opposite(member)}) {
    const HalfEdgeId copy = side_between(m, m.face(side), from, to);
    if (copy.valid() && edge_of(copy) != edge_of(h)) return copy;
  }
  return HalfEdgeId();
}

// Coincident faces share all their edges, including those that splits create inside them. h is an edge that
// was just flipped: if a face on the rings of both its neighbouring edges already has the same edge, the two
// are linked. Searches both rings at once, each in both directions, until one ends: one ring may be much
// longer than the other, and copies of a face are split one after the other.
void link_to_copy(Mesh::Kernel& k, HalfEdgeId h) {
  if (k.rings.empty()) return;
  const HalfEdges& m = k.half_edges;
  struct Search {
    HalfEdgeId start, forward, backward;
  };
  std::array<Search, 2> searches;
  const std::array<HalfEdgeId, 2> beside{m.next(h), m.previous(h)};
  for (size_t i = 0; i < 2; ++i)
    searches[i] = {beside[i], next_in_ring(k, beside[i]), previous_in_ring(k, beside[i])};
  for (;;) {
    for (Search& s : searches) {
      if (s.forward == s.start) return;
      for (const HalfEdgeId member : {s.forward, s.backward}) {
        const HalfEdgeId copy = copy_beside(m, member, h);
        if (copy.valid()) return join_ring(k, h, copy);
      }
      s.forward = next_in_ring(k, s.forward);
      s.backward = previous_in_ring(k, s.backward);
    }
  }
}

// The two halves of a bisected edge, both in the direction of the half-edge that was split.
struct Halves {
  HalfEdgeId near_from;
  HalfEdgeId near_to;
};

// Adds a new face with a copy of the data of its parent.
FaceId copy_of_face(Mesh::Kernel& k, FaceId parent) {
  k.faces.push_back(FaceData(k.faces[parent.index]));
  ++k.live_faces;
  return FaceId(k.faces.size() - 1);
}

void colour_middle(Mesh::Kernel& k, VertexId middle, VertexId tail, VertexId head) {
  const HalfEdges& m = k.half_edges;
  const double whole = glm::distance(m.position(tail), m.position(head));
  const double share = whole > 0 ? glm::distance(m.position(tail), m.position(middle)) / whole : 0.5;
  k.colours.set(middle, mix(k.colours.get(tail), k.colours.get(head), std::min(share, 1.0)));
}

// Bisects the edge of h and its one or two faces, and appends these splits, first that of the face of h.
Halves bisect(Mesh::Kernel& k, HalfEdgeId h, const Vec3& at, std::vector<Mesh::FaceSplit>& out) {
  HalfEdges& m = k.half_edges;
  const EdgeId edge = edge_of(h), new_edge(m.edges());
  const HalfEdgeId h0 = half_edge(edge, 0), o0 = half_edge(edge, 1);
  const VertexId tail = m.from(h0), head = m.to(h0);
  const FaceId left = m.face(h0), right = m.face(o0);
  const VertexId middle = m.split(edge, at);  // h0 now runs middle -> head, o0 head -> middle
  if (!k.colours.blank()) colour_middle(k, middle, tail, head);

  const size_t first = out.size();
  if (left.valid()) out.push_back({left, copy_of_face(k, left), middle, tail, head, head});
  if (right.valid()) out.push_back({right, copy_of_face(k, right), middle, head, tail, head});
  if (h != h0 && out.size() - first == 2) std::swap(out[first], out[first + 1]);
  if (!k.rings.empty()) add_isolated_rings(k);  // for the new edges

  const HalfEdgeId outward = half_edge(new_edge, 0);  // middle -> tail
  if (h == h0) return {opposite(outward), h0};
  return {o0, outward};
}

// Returns the area of the first face as a fraction of both; one half if both have none.
double area_share(const Mesh& mesh, FaceId a, FaceId b) {
  const double first = triangle_area(mesh.triangle(a)), second = triangle_area(mesh.triangle(b));
  const double share = first / (first + second);
  return share >= 0 ? share : 0.5;
}

// Links the bisectors of coincident faces, which coincide as well.
void link_bisectors(Mesh::Kernel& k, std::span<const Mesh::FaceSplit> splits) {
  const HalfEdges& m = k.half_edges;
  std::vector<HalfEdgeId> bisectors;  // from the midpoint to the opposite corner
  std::vector<Vec3> ends;
  for (const Mesh::FaceSplit& s : splits) {
    const FaceId before_midpoint =
        s.kept_end == s.from ? s.kept : s.added;  // its sides: from, midpoint, opposite
    bisectors.push_back(half_edge_from(m, before_midpoint, s.midpoint));
    ends.push_back(m.position(m.to(bisectors.back())));
  }
  const std::vector<uint32_t> first = weld_positions(ends);
  for (uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) join_ring(k, bisectors[i], bisectors[first[i]]);
  }
}

// Bisects all edges of a ring and links their halves and the bisectors.
void bisect_ring(Mesh::Kernel& k, HalfEdgeId start, const Vec3& at, std::vector<Mesh::FaceSplit>& out) {
  const size_t first = out.size();
  std::vector<HalfEdgeId> members{start}, near_from, near_to;
  for (HalfEdgeId h = next_in_ring(k, start); h != start; h = next_in_ring(k, h)) members.push_back(h);
  for (const HalfEdgeId h : members) {
    const Halves halves = bisect(k, h, at, out);
    near_from.push_back(halves.near_from);
    near_to.push_back(halves.near_to);
  }
  link_ring(k, near_from);
  link_ring(k, near_to);
  link_bisectors(k, {out.data() + first, out.size() - first});
}

}  // namespace

void Mesh::append_neighbours(FaceId f, std::vector<FaceId>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    for_each_side(*kernel_, h, [&](HalfEdgeId side) {
      if (m.face(side) != f) out.push_back(m.face(side));
    });
  }
}

void Mesh::append_nearest_neighbours(FaceId f, std::vector<FaceId>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  // A member of a ring has one face or two, which are neighbours.
  const auto append_one = [&](HalfEdgeId member) {
    const auto face = m.face(member);
    out.push_back(face.valid() ? face : m.face(opposite(member)));
  };
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    const auto across = m.face(opposite(h));
    if (across.valid()) out.push_back(across);
    const HalfEdgeId next = next_in_ring(*kernel_, h), previous = previous_in_ring(*kernel_, h);
    if (next != h) append_one(next);
    if (previous != next) append_one(previous);
  }
}

void Mesh::append_edge_sides(FaceId f, VertexId from, VertexId to, std::vector<Side>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  const HalfEdgeId h = half_edge_from(m, f, from);
  KERF_ASSERT(m.to(h) == to);
  (void)to;
  for_each_side(*kernel_, h, [&](HalfEdgeId side) {
    if (side == h) return;
    out.push_back({m.face(side), m.from(side), m.to(side)});
  });
}

void Mesh::append_open_sides_of(FaceId f, std::vector<Side>& out) const {
  assert(is_live(f));
  const HalfEdges& m = kernel_->half_edges;
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    if (!m.face(opposite(h)).valid() && next_in_ring(*kernel_, h) == h)
      out.push_back({f, m.from(h), m.to(h)});
  }
}

void Mesh::append_open_sides_in(uint32_t first, uint32_t end, std::vector<Side>& out) const {
  const HalfEdges& m = kernel_->half_edges;
  for (uint32_t e = first; e < std::min(end, edge_slots()); ++e) {
    for (uint32_t side = 0; side < 2; ++side) {
      const HalfEdgeId h = half_edge(EdgeId(e), side);
      if (!m.face(h).valid() || m.face(opposite(h)).valid()) continue;
      if (next_in_ring(*kernel_, h) == h) out.push_back({m.face(h), m.from(h), m.to(h)});
    }
  }
}

void Mesh::star(VertexId v, Star& out) const {
  const HalfEdges& m = kernel_->half_edges;
  out.faces.clear();
  out.rim.clear();
  out.alone = true;
  m.for_each_outgoing(v, [&](HalfEdgeId h) {
    const FaceId left = m.face(h), right = m.face(opposite(h));
    if (left.valid()) out.faces.push_back(left);
    if (left.valid() != right.valid()) out.rim.push_back(m.to(h));
    if (next_in_ring(*kernel_, h) != h) out.alone = false;
  });
}

void Mesh::move_vertex(VertexId v, const Vec3& to) { kernel_->half_edges.set_position(v, to); }

void Mesh::split_edge(FaceId f, VertexId from, VertexId to, std::vector<FaceSplit>& out) {
  split_edge_at(f, from, to, 0.5 * position(from) + 0.5 * position(to), out);
}

void Mesh::split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at, std::vector<FaceSplit>& out) {
  Kernel& k = *kernel_;
  HalfEdges& m = k.half_edges;
  const HalfEdgeId start = half_edge_from(m, f, from);
  KERF_ASSERT(m.to(start) == to);
  (void)to;

  const size_t first = out.size();
  if (next_in_ring(k, start) == start) {
    bisect(k, start, at, out);
  } else {
    bisect_ring(k, start, at, out);
  }
  if (k.columns.blank()) return;
  for (size_t i = first; i < out.size(); ++i)
    k.columns.record_split(out[i].kept, out[i].added, area_share(*this, out[i].kept, out[i].added));
}

void Mesh::flip_edge(FaceId f, VertexId from, VertexId to) {
  HalfEdges& m = kernel_->half_edges;
  const HalfEdgeId a0 = half_edge_from(m, f, from), b0 = opposite(a0);
  KERF_ASSERT(m.to(a0) == to);
  const HalfEdgeId a1 = m.next(a0), a2 = m.next(a1);
  const HalfEdgeId b1 = m.next(b0), b2 = m.next(b1);
  const auto fa = m.face(a0), fb = m.face(b0);
  KERF_ASSERT(fa.valid() && fb.valid());
  leave_ring(*kernel_, edge_of(a0));

  if (m.outgoing(from) == a0) m.set_outgoing(from, b1);
  if (m.outgoing(to) == b0) m.set_outgoing(to, a1);
  m.set_to(a0, m.to(a1));
  m.set_to(b0, m.to(b1));
  m.close(fa, a0, a2, b1);
  m.close(fb, b0, b2, a1);
  link_to_copy(*kernel_, a0);
  if (!kernel_->columns.blank()) kernel_->columns.record_flipped(fa, fb, area_share(*this, fa, fb));
}

bool Mesh::can_flip_edge(FaceId f, VertexId from, VertexId to) const {
  const HalfEdges& m = kernel_->half_edges;
  const HalfEdgeId h = half_edge_from(m, f, from), o = opposite(h);
  KERF_ASSERT(m.to(h) == to);
  (void)to;
  if (!m.face(o).valid() || next_in_ring(*kernel_, h) != h) return false;
  const auto left = m.to(m.next(h));
  const auto right = m.to(m.next(o));
  bool joined = left == right;
  m.for_each_outgoing(left, [&](HalfEdgeId out) { joined |= m.to(out) == right; });
  return !joined;
}

void Mesh::remove_face(FaceId f) {
  HalfEdges& m = kernel_->half_edges;
  assert(is_live(f));
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    if (!m.face(opposite(h)).valid()) leave_ring(*kernel_, edge_of(h));
  }
  m.remove(f);
  --kernel_->live_faces;
  if (!kernel_->columns.blank()) kernel_->columns.record_removed(f);
}

size_t Mesh::bytes() const { return ChangeOfParts<Kernel>::bytes_of(*kernel_); }

Mesh::Change::Change() : parts_(std::make_unique<Parts>()) {}
Mesh::Change::~Change() = default;
Mesh::Change::Change(Change&&) noexcept = default;
Mesh::Change& Mesh::Change::operator=(Change&&) noexcept = default;
void Mesh::Change::begin(Mesh& mesh) { parts_->begin(*mesh.kernel_); }
void Mesh::Change::end(Mesh& mesh) { parts_->end(*mesh.kernel_); }
bool Mesh::Change::any() const { return parts_->any(); }
void Mesh::Change::exchange(Mesh& mesh) { parts_->exchange(*mesh.kernel_); }
void Mesh::Change::restore(Mesh& mesh) const { parts_->restore(*mesh.kernel_); }
size_t Mesh::Change::bytes() const { return parts_->bytes(); }
void Mesh::Change::append_faces(const Mesh& mesh, std::vector<FaceId>& out) const {
  parts_->part<HalfEdges>().append_faces(mesh.kernel_->half_edges, out);
}

void append_sheet_sides_of(const Mesh& mesh, FaceId f, std::vector<SheetSide>& out) {
  KERF_ASSERT(mesh.is_live(f));
  const HalfEdges& m = mesh.kernel().half_edges;
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    if (m.face(opposite(h)).valid()) continue;
    out.push_back({{f, m.from(h), m.to(h)}, next_in_ring(mesh.kernel(), h) != h});
  }
}

void append_sheet_sides_in(const Mesh& mesh, uint32_t first, uint32_t end, std::vector<SheetSide>& out) {
  const HalfEdges& m = mesh.kernel().half_edges;
  for (uint32_t e = first; e < std::min(end, mesh.edge_slots()); ++e) {
    for (uint32_t side = 0; side < 2; ++side) {
      const HalfEdgeId h = half_edge(EdgeId(e), side);
      if (!m.face(h).valid() || m.face(opposite(h)).valid()) continue;
      out.push_back({{m.face(h), m.from(h), m.to(h)}, next_in_ring(mesh.kernel(), h) != h});
    }
  }
}

std::array<SheetEdge, 3> sheet_edges_of(const Mesh& mesh, FaceId f) {
  KERF_ASSERT(mesh.is_live(f));
  const HalfEdges& m = mesh.kernel().half_edges;
  std::array<SheetEdge, 3> edges;
  HalfEdgeId h = m.first(f);
  for (SheetEdge& edge : edges) {
    edge = {m.from(h), m.to(h), m.face(opposite(h)), next_in_ring(mesh.kernel(), h) != h};
    h = m.next(h);
  }
  return edges;
}

void append_sheet_neighbours(const Mesh& mesh, FaceId f, std::vector<FaceId>& out) {
  const HalfEdges& m = mesh.kernel().half_edges;
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    if (m.face(opposite(h)).valid()) out.push_back(m.face(opposite(h)));
  }
}

}  // namespace kerf
