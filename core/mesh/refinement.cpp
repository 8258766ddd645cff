#include "core/mesh/refinement.h"

#include <limits>
#include <unordered_map>
#include <utility>

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

// The rank of an edge in the order by length; the same for an edge in all faces and sheets.
struct EdgeRank {
  double length2 = -1;
  Vec3 low{0}, high{0};

  EdgeRank() = default;
  EdgeRank(const Vec3& a, const Vec3& b) : length2(glm::dot(b - a, b - a)), low(a), high(b) {
    if (lexicographic_less(high, low)) std::swap(low, high);
  }
  bool operator<(const EdgeRank& other) const {
    if (length2 != other.length2) return length2 < other.length2;
    if (low != other.low) return lexicographic_less(low, other.low);
    return lexicographic_less(high, other.high);
  }
};

struct LongestEdge {
  VertexId from, to;
  EdgeRank rank;
};

LongestEdge longest_edge(const Mesh& mesh, FaceId f) {
  const auto c = mesh.corners(f);
  const Triangle t = mesh.triangle(f);
  LongestEdge longest;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    const EdgeRank rank(t[i], t[next]);
    if (longest.rank < rank) longest = {c[i], c[next], rank};
  }
  return longest;
}

// Follows a propagation path from its first face to its end, and bisects on the way back.
class Propagation {
 public:
  Propagation(Mesh& mesh, OneToFour& greens, std::vector<Replacement>& out)
      : mesh_(mesh), greens_(greens), out_(out) {}

  bool bisect(FaceId f) {
    KERF_ASSERT(mesh_.is_live(f));
    path_.clear();
    sides_.clear();
    first_ = indexed_ = out_.size();
    step_onto(f);
    while (!path_.empty()) {
      Step& step = path_.back();
      while (step.visited < sides_.size() && !(step.edge.rank < rank_at(sides_[step.visited])))
        ++step.visited;
      if (step.visited < sides_.size()) {
        step_onto(sides_[step.visited].face);
        continue;
      }
      const Vec3 &a = step.edge.rank.low, &b = step.edge.rank.high, middle = 0.5 * a + 0.5 * b;
      if (middle == a || middle == b) return false;
      split(step);
      sides_.resize(step.first_side);
      path_.pop_back();
    }
    return true;
  }

 private:
  // A face of the path, its longest edge, and the first index of the other faces on that edge in `sides_`,
  // which extend to the next step or to its end. Those before index `visited` have no longer edge, so that
  // each face of a ring is examined once.
  struct Step {
    FaceId face;
    LongestEdge edge;
    size_t first_side, visited;
  };

  void step_onto(FaceId f) {
    const Step step{f, longest_edge(mesh_, f), sides_.size(), sides_.size()};
    mesh_.append_edge_sides(f, step.edge.from, step.edge.to, sides_);
    path_.push_back(step);
  }

  // Returns the rank of the longest edge of the face examined next. If that face was bisected further along
  // the path in the meantime, one of its parts has the side, usually one of the latest.
  EdgeRank rank_at(Mesh::Side& side) {
    if (!has(side.face, side)) side.face = latest_part_with(side);
    KERF_ASSERT(side.face.valid());
    return longest_edge(mesh_, side.face).rank;
  }

  bool has(FaceId f, const Mesh::Side& side) const { return mesh_.has_side(f, side.from, side.to); }

  FaceId latest_part_with(const Mesh::Side& side) {
    constexpr size_t kLatest = 8;
    for (size_t i = out_.size(); i > first_ && i + kLatest > out_.size(); --i) {
      for (const FaceId f : {out_[i - 1].added[0], out_[i - 1].added[1]}) {
        if (has(f, side)) return f;
      }
    }
    return part_with(side, side.face);
  }

  // Returns the part of a face that has the side, given the slot of a part; invalid if none has it.
  FaceId part_with(const Mesh::Side& side, FaceId f) {
    if (has(f, side)) return f;
    index_splits();
    const auto latest = latest_.find(f.index);
    for (size_t i = latest == latest_.end() ? 0 : latest->second; i > 0; i = before_[i - 1]) {
      const FaceId found = part_with(side, out_[first_ + i - 1].added[1]);
      if (found.valid()) return found;
    }
    return FaceId();
  }

  // Numbers the splits since the path began, so that each part is found at once even in a ring of many faces.
  void index_splits() {
    if (indexed_ == first_) {
      latest_.clear();
      before_.clear();
    }
    for (; indexed_ < out_.size(); ++indexed_) {
      size_t& latest = latest_[out_[indexed_].removed[0].index];
      before_.push_back(std::exchange(latest, indexed_ - first_ + 1));
    }
  }

  void split(const Step& step) {
    greens_.forget(mesh_, step.face);
    for (size_t i = step.first_side; i < sides_.size(); ++i) greens_.forget(mesh_, sides_[i].face);
    splits_.clear();
    mesh_.split_edge(step.face, step.edge.from, step.edge.to, splits_);
    for (const Mesh::FaceSplit& s : splits_) {
      FaceData& kept = mesh_.edit_data(s.kept);
      if (kept.halvings < std::numeric_limits<uint8_t>::max()) ++kept.halvings;
      mesh_.edit_data(s.added).halvings = kept.halvings;
      out_.push_back({{s.kept, FaceId()}, {s.kept, s.added, FaceId(), FaceId()}, 1, 2});
    }
  }

  Mesh& mesh_;
  OneToFour& greens_;
  std::vector<Replacement>& out_;
  std::vector<Step> path_;
  std::vector<Mesh::Side> sides_;
  std::vector<Mesh::FaceSplit> splits_;
  size_t first_ = 0, indexed_ = 0;  // in out_: the start of the path, and the end of the numbered splits
  std::unordered_map<uint32_t, size_t> latest_;  // by slot: the number of its latest split; never iterated
  std::vector<size_t> before_;  // by split, from 1: the previous split of the same slot; 0 if none
};

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
    // The element may be red already because a finer neighbour required it.
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

// Ends, because a neighbour is one level coarser if the element's edge is half of an edge of it.
void OneToFour::refine_coarser_neighbours(Mesh& mesh, uint32_t index, std::vector<Replacement>& out) {
  for (int edge = 0; edge < 3; ++edge) {
    while (!elements_[index].midpoints[edge].valid() && refine_coarser_across(mesh, index, edge, out)) {
    }
  }
}

// Splits the coarser neighbours on an edge of the element. Returns true if there were any; as splitting one
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
  for (const Mesh::FaceSplit& s : splits) record_split(mesh, s);
}

void OneToFour::record_split(Mesh& mesh, const Mesh::FaceSplit& s) {
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
  r.removed = {e.faces[0], e.faces[1]};
  r.removed_count = e.faces_in_tree;
  for (const FaceId f : e.faces) {
    int corner = 0;
    while (corner < 3 && !has_corner(mesh, f, e.corners[corner])) ++corner;
    KERF_ASSERT(!r.added[corner].valid());
    r.added[corner] = f;  // the faces at the corners, then the middle one
    FaceData& data = mesh.edit_data(f);
    data.element = FaceData::kNoElement;
    data.halvings = static_cast<uint8_t>(e.halvings + 2);
  }
  r.added_count = 4;
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

bool bisect_longest_edge(Mesh& mesh, OneToFour& greens, FaceId f, std::vector<Replacement>& out) {
  return Propagation(mesh, greens, out).bisect(f);
}

}  // namespace kerf
