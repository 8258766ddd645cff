#include "core/mesh/one_to_four.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

int next(int i) { return (i + 1) % 3; }
int after_next(int i) { return (i + 2) % 3; }

int bisected_edges(const std::array<VertexId, 3>& midpoints) {
  return midpoints[0].valid() + midpoints[1].valid() + midpoints[2].valid();
}

bool has_corner(const Mesh& mesh, FaceId f, VertexId v) {
  const auto c = mesh.corners(f);
  return c[0] == v || c[1] == v || c[2] == v;
}

}  // namespace

OneToFour::Element OneToFour::element(const Mesh& mesh, FaceId f) const {
  KERF_ASSERT(mesh.is_live(f));
  const uint32_t index = mesh.data(f).element;
  if (index == FaceData::kNoElement) return {mesh.corners(f), {f, FaceId()}, 1};
  const Split& e = elements_[index];
  KERF_ASSERT(e.face_count == 2 && (e.faces[0] == f || e.faces[1] == f));
  return {e.corners, {e.faces[0], e.faces[1]}, 2};
}

Triangle OneToFour::triangle(const Mesh& mesh, FaceId f) const {
  const auto c = element(mesh, f).corners;
  return {mesh.position(c[0]), mesh.position(c[1]), mesh.position(c[2])};
}

bool OneToFour::can_split(const Mesh& mesh, FaceId f) const {
  const Triangle t = triangle(mesh, f);
  for (int i = 0; i < 3; ++i) {
    const Vec3 middle = 0.5 * t[i] + 0.5 * t[next(i)];
    if (middle == t[i] || middle == t[next(i)]) return false;
  }
  return true;
}

void OneToFour::split(Mesh& mesh, FaceId f, std::vector<Replacement>& out) {
  KERF_ASSERT(can_split(mesh, f) && pending_.empty() && changed_.empty());
  make_red(mesh, f, out);
  while (!pending_.empty()) {
    const FaceId next_face = pending_.back();
    pending_.pop_back();
    // The element may be red already because a finer neighbour demanded it.
    if (mesh.data(next_face).element != FaceData::kNoElement) make_red(mesh, next_face, out);
  }
  report_green(out);
}

void OneToFour::forget(Mesh& mesh, FaceId f) {
  const uint32_t index = mesh.data(f).element;
  if (index == FaceData::kNoElement) return;
  KERF_ASSERT(elements_[index].face_count == 2);
  for (int i = 0; i < 2; ++i) mesh.edit_data(elements_[index].faces[i]).element = FaceData::kNoElement;
  close_element(index);
}

size_t OneToFour::bytes() const { return ChangeOfParts<OneToFour>::bytes_of(*this); }

uint32_t OneToFour::open_element(const Mesh& mesh, FaceId f) {
  Split e;
  e.corners = mesh.corners(f);
  e.faces[0] = f;
  e.halvings = mesh.data(f).halvings;
  if (free_ == FaceData::kNoElement) {
    elements_.push_back(e);
    return elements_.size() - 1;
  }
  const uint32_t index = free_;
  free_ = elements_[index].faces[0].index;
  elements_.edit(index) = e;
  return index;
}

void OneToFour::close_element(uint32_t index) {
  Split& e = elements_.edit(index);
  KERF_ASSERT(e.face_count > 0);
  e.face_count = 0;
  e.faces[0] = FaceId(free_);
  free_ = index;
}

void OneToFour::make_red(Mesh& mesh, FaceId f, std::vector<Replacement>& out) {
  if (mesh.data(f).element == FaceData::kNoElement) mesh.edit_data(f).element = open_element(mesh, f);
  const uint32_t index = mesh.data(f).element;
  elements_.edit(index).wanted_red = true;
  refine_coarser_neighbours(mesh, index, out);
  for (int edge = 0; edge < 3; ++edge) {
    if (!elements_[index].midpoints[edge].valid()) bisect(mesh, index, edge);
  }
  finish_red(mesh, index, out);
}

// A neighbour of which the element's whole edge is only one half of an edge is coarser by one level, so that
// this recursion ends.
void OneToFour::refine_coarser_neighbours(Mesh& mesh, uint32_t index, std::vector<Replacement>& out) {
  for (int edge = 0; edge < 3; ++edge) {
    while (!elements_[index].midpoints[edge].valid() && refine_coarser_across(mesh, index, edge, out)) {
    }
  }
}

// Splits the coarser neighbours on an edge of the element. Returns whether there were any; as splitting one
// may change the others, the caller repeats the call until there are none.
bool OneToFour::refine_coarser_across(Mesh& mesh, uint32_t index, int edge, std::vector<Replacement>& out) {
  const VertexId from = elements_[index].corners[edge], to = elements_[index].corners[next(edge)];
  std::vector<Mesh::Side> across;
  mesh.append_edge_sides(face_at(mesh, elements_[index], from, to), from, to, across);
  bool found = false;
  for (const Mesh::Side& side : across) {
    const uint32_t other = mesh.data(side.face).element;
    const bool coarser = other != FaceData::kNoElement && mesh.has_side(side.face, side.from, side.to) &&
                         edge_of(elements_[other], side.from, side.to) == 3;
    if (!coarser) continue;
    make_red(mesh, side.face, out);
    found = true;
  }
  return found;
}

void OneToFour::bisect(Mesh& mesh, uint32_t index, int edge) {
  const Split& e = elements_[index];
  const VertexId from = e.corners[edge], to = e.corners[next(edge)];
  std::vector<Mesh::FaceSplit> splits;
  mesh.split_edge(face_at(mesh, e, from, to), from, to, splits);
  for (const Mesh::FaceSplit& s : splits) note_split(mesh, s);
}

void OneToFour::note_split(Mesh& mesh, const Mesh::FaceSplit& s) {
  uint32_t index = mesh.data(s.kept).element;
  if (index == FaceData::kNoElement) {
    index = open_element(mesh, s.kept);
    const auto now = mesh.corners(s.kept);
    for (const VertexId v : now) {
      if (v != s.midpoint && v != s.kept_end) elements_.edit(index).corners = {s.from, s.to, v};
    }
    mesh.edit_data(s.kept).element = mesh.edit_data(s.added).element = index;
  }
  Split& e = elements_.edit(index);
  const int edge = edge_of(e, s.from, s.to);
  KERF_ASSERT(edge < 3 && !e.midpoints[edge].valid());
  e.midpoints[edge] = s.midpoint;
  KERF_ASSERT(e.face_count < e.faces.size());
  e.faces[e.face_count++] = s.added;
  const int bisected = bisected_edges(e.midpoints);
  if (bisected == 1) {
    e.first_edge = static_cast<uint8_t>(edge);
    for (const FaceId f : {s.kept, s.added})
      mesh.edit_data(f).halvings = static_cast<uint8_t>(e.halvings + 1);
    changed_.push_back(index);
  } else if (!e.wanted_red) {
    e.wanted_red = true;
    pending_.push_back(s.kept);
  }
}

void OneToFour::finish_red(Mesh& mesh, uint32_t index, std::vector<Replacement>& out) {
  const Split e = elements_[index];
  KERF_ASSERT(bisected_edges(e.midpoints) == 3 && e.face_count == 4);
  const VertexId middle = e.midpoints[e.first_edge], opposite = e.corners[after_next(e.first_edge)];
  mesh.flip_edge(face_at(mesh, e, middle, opposite), middle, opposite);

  Replacement r;
  r.gone = {e.faces[0], e.faces[1]};
  r.gone_count = e.faces_in_tree;
  for (const FaceId f : e.faces) {
    int corner = 0;
    while (corner < 3 && !has_corner(mesh, f, e.corners[corner])) ++corner;
    KERF_ASSERT(!r.born[corner].valid());
    r.born[corner] = f;  // the face at each corner, then the one in the middle
    FaceData& data = mesh.edit_data(f);
    data.element = FaceData::kNoElement;
    data.halvings = static_cast<uint8_t>(e.halvings + 2);
  }
  r.born_count = 4;
  out.push_back(r);
  close_element(index);
}

void OneToFour::report_green(std::vector<Replacement>& out) {
  for (const uint32_t index : changed_) {
    const Split& e = elements_[index];
    if (e.face_count != 2 || e.faces_in_tree != 1) continue;  // red in the meantime, or closed
    elements_.edit(index).faces_in_tree = 2;
    out.push_back({{e.faces[0], FaceId()}, {e.faces[0], e.faces[1], FaceId(), FaceId()}, 1, 2});
  }
  changed_.clear();
}

int OneToFour::edge_of(const Split& e, VertexId from, VertexId to) {
  int edge = 0;
  while (edge < 3 && !(e.corners[edge] == from && e.corners[next(edge)] == to)) ++edge;
  return edge;
}

FaceId OneToFour::face_at(const Mesh& mesh, const Split& e, VertexId from, VertexId to) const {
  for (int i = 0; i < e.face_count; ++i) {
    const auto c = mesh.corners(e.faces[i]);
    for (int k = 0; k < 3; ++k) {
      if (c[k] == from && c[next(k)] == to) return e.faces[i];
    }
  }
  KERF_ASSERT(false && "no face of the element walks this edge");
  return FaceId();
}

}  // namespace kerf
