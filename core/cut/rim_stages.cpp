#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/cut/rim_stages_internal.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

bool may_split(RimState& rim, FaceId f) {
  const double least = kRimLeastEdge * rim.radius();
  return rim.mesh().data(f).halvings < 2 * Resolution::kMaxDepth &&
         longest_edge2(rim.mesh().triangle(f)) > least * least;
}

bool fails(RimState& rim, FaceId f) {
  return chord_fails(rim.region, f, rim.mesh().triangle(f), rim.distances_of(f), kRimChord * rim.radius(),
                     kRimGraze * rim.radius());
}

// Returns true if b is processed before a. Entries that compare equal are equal.
bool is_processed_later(const RimSnap& a, const RimSnap& b) {
  const auto key = [](const RimSnap& s) { return std::tie(s.share, s.vertex, s.other, s.face); };
  return key(b) < key(a);
}

void push(std::vector<RimSnap>& snaps, const RimSnap& snap) {
  KERF_ASSERT(snap.share < 1);
  snaps.push_back(snap);
  std::push_heap(snaps.begin(), snaps.end(), is_processed_later);
}

RimSnap pop(std::vector<RimSnap>& snaps) {
  std::pop_heap(snaps.begin(), snaps.end(), is_processed_later);
  const RimSnap nearest = snaps.back();
  snaps.pop_back();
  return nearest;
}

// Calls visit(snap) for the next faces_per_batch() entries, nearest first. Returns true if none is left.
template <typename Visit>
bool visit_nearest(std::vector<RimSnap>& snaps, Visit visit) {
  for (size_t i = 0; i < faces_per_batch() && !snaps.empty(); ++i) visit(pop(snaps));
  return snaps.empty();
}

// Returns the direction of steepest growth of the distance in the plane of the face; zero if there is none.
Vec3 in_plane_gradient(const RimState& rim, FaceId f, const Triangle& t, const Vec3& at) {
  const double step = kRimOn * rim.radius();
  const Vec3 u = glm::normalize(t[1] - t[0]), normal = glm::cross(u, t[2] - t[0]);
  if (!(glm::dot(normal, normal) > 0)) return Vec3(0);
  const Vec3 w = glm::cross(glm::normalize(normal), u);
  const auto slope = [&](const Vec3& d) {
    return rim.region.signed_distance(f, at + step * d) - rim.region.signed_distance(f, at - step * d);
  };
  const Vec3 gradient = slope(u) * u + slope(w) * w;
  const double length = glm::length(gradient);
  return length > 0 ? gradient / length : Vec3(0);
}

// Lists vertices nearer to the boundary than their edges are long; they may move straight onto it.
void add_moves_in_plane(RimState& rim, FaceId f, std::vector<RimSnap>& snaps) {
  const auto c = rim.mesh().corners(f);
  const auto d = rim.distances_of(f);
  const Triangle t = rim.mesh().triangle(f);
  for (int i = 0; i < 3; ++i) {
    const double edge = std::min(glm::length(t[(i + 1) % 3] - t[i]), glm::length(t[(i + 2) % 3] - t[i]));
    if (d[i] == 0 || !(std::abs(d[i]) < kRimSnap * edge)) continue;
    const Vec3 way = in_plane_gradient(rim, f, t, t[i]), beyond = t[i] - 2 * d[i] * way;
    if (!((rim.region.signed_distance(f, beyond) > 0) == (d[i] < 0))) continue;
    const Vec3 to = d[i] < 0 ? rim.region.crossing(f, t[i], beyond) : rim.region.crossing(f, beyond, t[i]);
    push(snaps, {c[i], VertexId(), f, to, std::abs(d[i]) / edge});
  }
}

void add_moves_along_edges(RimState& rim, FaceId f, std::vector<RimSnap>& snaps) {
  const auto c = rim.mesh().corners(f);
  const auto d = rim.distances_of(f);
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    const bool crosses = (d[i] < 0 && d[k] > 0) || (d[i] > 0 && d[k] < 0);
    if (!crosses) continue;
    const int in = d[i] < 0 ? i : k, out = d[i] < 0 ? k : i;
    const Vec3 a = rim.mesh().position(c[in]), b = rim.mesh().position(c[out]);
    const double snap = kRimSnap * rim.region.steepest() * glm::length(b - a);
    if (-d[in] > snap && d[out] > snap) continue;  // it crosses farther from both
    const Vec3 at = rim.region.crossing(f, a, b);
    const double share = glm::length(at - a) / glm::length(b - a);
    if (share < kRimSnap) push(snaps, {c[in], c[out], f, at, share});
    if (1 - share < kRimSnap) push(snaps, {c[out], c[in], f, at, 1 - share});
  }
}

// Returns true if a move keeps the old rim: a vertex at an edge of one face may only slide along that edge
// and hardly change its line. If the stroke itself removed the other side, there is no line to keep.
bool keeps_old_rim(RimState& rim, const Mesh& mesh, const Mesh::Star& star, const RimSnap& s) {
  if (rim.distance(s.vertex, s.face) < 0 && std::none_of(star.rim.begin(), star.rim.end(), [&](VertexId v) {
        return rim.distance(v, s.face) > 0;
      })) {
    return true;
  }
  if (star.rim.empty()) return true;
  if (!s.other.valid()) return false;
  if (star.rim.size() != 2) return false;
  const VertexId back = star.rim[0] == s.other ? star.rim[1] : star.rim[0];
  if (star.rim[0] != s.other && star.rim[1] != s.other) return false;
  const Vec3 at = mesh.position(s.vertex);
  return glm::length(at - nearest_on_segment(at, mesh.position(back), s.to)) <= kRimOn * rim.radius();
}

Triangle with_corner_moved(const Mesh& mesh, FaceId f, VertexId v, const Vec3& to) {
  Triangle t = mesh.triangle(f);
  const auto c = mesh.corners(f);
  for (int i = 0; i < 3; ++i) {
    if (c[i] == v) t[i] = to;
  }
  return t;
}

bool turns_too_far(const Triangle& before, const Triangle& after) {
  const Vec3 n = glm::cross(before[1] - before[0], before[2] - before[0]);
  const Vec3 m = glm::cross(after[1] - after[0], after[2] - after[0]);
  return !(glm::dot(n, m) >= kRimLargestTurn * std::sqrt(glm::dot(n, n)) * std::sqrt(glm::dot(m, m))) ||
         !(glm::dot(m, m) > 0);
}

// Without the snap, the smallest angle at the vertex would be about the share of the edge that is cut off.
bool keeps_faces_well(const Mesh& mesh, const Mesh::Star& star, const RimSnap& s) {
  double worst = -1;
  for (const FaceId f : star.faces) {
    const Triangle after = with_corner_moved(mesh, f, s.vertex, s.to);
    if (turns_too_far(mesh.triangle(f), after)) return false;
    worst = std::max(worst, largest_cosine(after));
  }
  return worst <= kRimGoodAngle || 1 - worst * worst >= 0.25 * s.share * s.share;
}

// Returns a face around the vertex that could no longer be cut along one chord; invalid if all could.
FaceId without_chord(RimState& rim, const Mesh::Star& star, const RimSnap& s) {
  const double chord = kRimMovedChord * rim.radius(), graze = 2 * kRimGraze * rim.radius();
  for (const FaceId f : star.faces) {
    if (!rim.region.is_near(f)) continue;
    auto d = rim.distances_of(f);
    const auto c = rim.mesh().corners(f);
    for (int i = 0; i < 3; ++i) {
      if (c[i] == s.vertex) d[i] = 0;
    }
    if (chord_fails(rim.region, f, with_corner_moved(rim.mesh(), f, s.vertex, s.to), d, chord, graze))
      return f;
  }
  return FaceId();
}

void move(RimState& rim, const RimSnap& s, Mesh::Star& star) {
  if (rim.distance(s.vertex, s.face) == 0) return;
  if (s.other.valid() && rim.distance(s.other, s.face) == 0) return;
  rim.mesh().star(s.vertex, star);
  if (!star.alone || !keeps_old_rim(rim, rim.mesh(), star, s)) return;
  if (!keeps_faces_well(rim.mesh(), star, s)) return;
  if (const FaceId f = without_chord(rim, star, s); f.valid()) {
    if (s.share < kRimSliver) rim.work.in_the_way.push_back(f);
    return;
  }
  rim.step.edit.move_vertex(s.vertex, s.to, star);
  rim.record_on_boundary(s.vertex);
}

void add_very_near(RimState& rim, FaceId f, std::vector<RimSnap>& near) {
  const auto c = rim.mesh().corners(f);
  const auto d = rim.distances_of(f);
  const Triangle t = rim.mesh().triangle(f);
  for (int i = 0; i < 3; ++i) {
    const double off = std::abs(d[i]) / rim.radius();
    if (d[i] != 0 && off < kRimNear) push(near, {c[i], VertexId(), f, t[i], off});
  }
}

struct Crossing {
  VertexId from, to;  // in the direction of the face
  bool from_inside = false;
  double length2 = -1;
  bool found() const { return length2 >= 0; }
};

// Returns the longest of the face's edges across the boundary.
Crossing longest_crossing(RimState& rim, FaceId f) {
  const auto c = rim.mesh().corners(f);
  const auto d = rim.distances_of(f);
  const Triangle t = rim.mesh().triangle(f);
  Crossing longest;
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    if (!((d[i] < 0 && d[k] > 0) || (d[i] > 0 && d[k] < 0))) continue;
    const double length2 = glm::dot(t[k] - t[i], t[k] - t[i]);
    if (length2 > longest.length2) longest = {c[i], c[k], d[i] < 0, length2};
  }
  return longest;
}

// Splits the face's edge, and all faces on it, where it crosses the boundary.
void split_at(RimState& rim, FaceId f, const Crossing& edge) {
  KERF_ASSERT(edge.found());
  const VertexId in = edge.from_inside ? edge.from : edge.to, out = edge.from_inside ? edge.to : edge.from;
  const Vec3 a = rim.mesh().position(in), b = rim.mesh().position(out), at = rim.region.crossing(f, a, b);
  const double on_boundary = kRimOn * rim.radius();
  if (glm::length(at - a) <= on_boundary) return rim.record_on_boundary(in);
  if (glm::length(at - b) <= on_boundary) return rim.record_on_boundary(out);
  std::vector<Mesh::FaceSplit> splits;
  rim.step.edit.split_edge_at(f, edge.from, edge.to, at, splits);
  for (const Mesh::FaceSplit& s : splits) {
    rim.record_on_boundary(s.midpoint);
    if (!rim.region.is_near(s.kept)) continue;
    rim.region.inherit({&s.added, 1}, {&s.kept, 1});
    rim.faces.push_back(s.added);
  }
}

Vec3 area_vector(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

// Returns true if two faces of one base face lie in one plane, within the precision of doubles.
bool in_one_plane(const Triangle& s, const Triangle& t) {
  const Vec3 n = area_vector(s), m = area_vector(t);
  return glm::dot(n, m) >= kCoplanar * std::sqrt(glm::dot(n, n)) * std::sqrt(glm::dot(m, m));
}

// The edge of a face whose flip gains most, in the face's plane.
class Flip {
 public:
  Flip(const Mesh& mesh, FaceId f, int edge) : face_(f) {
    const auto c = mesh.corners(f);
    from_ = c[edge];
    to_ = c[(edge + 1) % 3];
    const Vec3 apex = mesh.position(c[(edge + 2) % 3]);
    std::vector<Mesh::Side> sides;
    mesh.append_edge_sides(f, from_, to_, sides);
    if (sides.size() != 1 || !mesh.can_flip_edge(f, from_, to_)) return;
    const FaceId other = sides[0].face;
    if (mesh.data(other).base != mesh.data(f).base) return;
    Vec3 below{0};
    for (const VertexId v : mesh.corners(other)) {
      if (v != from_ && v != to_) below = mesh.position(v);
    }
    const Vec3 a = mesh.position(from_), b = mesh.position(to_);
    const std::array<Triangle, 2> before{mesh.triangle(f), mesh.triangle(other)},
        after{Triangle{apex, a, below}, Triangle{below, b, apex}};
    const Vec3 n = area_vector(before[0]);
    if (!in_one_plane(before[0], before[1])) return;
    for (const Triangle& t : after) {
      if (!(glm::dot(area_vector(t), n) > 0)) return;
    }
    gain_ = worst(before) - worst(after);
  }

  bool pays() const { return gain_ > kMinFlipGain; }

  void make(BodyEdit& edit) const { edit.flip_edge(face_, from_, to_); }

 private:
  static double worst(const std::array<Triangle, 2>& t) {
    return std::max(largest_cosine(t[0]), largest_cosine(t[1]));
  }

  FaceId face_;
  VertexId from_, to_;
  double gain_ = 0;
};

bool flip_around(RimState& rim, FaceId f) {
  for (int edge = 0; edge < 3; ++edge) {
    const Flip flip(rim.mesh(), f, edge);
    if (!flip.pays()) continue;
    flip.make(rim.step.edit);
    return true;
  }
  return false;
}

bool on_rim(RimState& rim, FaceId f) {
  const auto d = rim.distances_of(f);
  return d[0] == 0 || d[1] == 0 || d[2] == 0;
}

}  // namespace

// The beam may be near one half of a green pair only, and the faces that replace it may span both halves.
void split_near_rim(RimState& rim, FaceId f, std::vector<FaceId>& parts) {
  for (const Replacement& r : split_by_scheme(rim.step, rim.settings.resolution.scheme, f)) {
    const std::span<const FaceId> removed(r.removed.data(), r.removed_count),
        added(r.added.data(), r.added_count);
    const auto is_near = [&](FaceId g) { return rim.region.is_near(g); };
    if (std::none_of(removed.begin(), removed.end(), is_near)) continue;
    std::remove_copy_if(added.begin(), added.end(), std::back_inserter(rim.faces), is_near);
    parts.insert(parts.end(), added.begin(), added.end());
    rim.region.inherit(added, removed);
  }
}

Status refine_rim(RimState& rim) {
  std::vector<FaceId>& waiting = rim.work.waiting;
  for (size_t tests = 0; tests < faces_per_batch() && !waiting.empty(); ++tests) {
    if (rim.mesh().live_faces() > rim.settings.max_faces) return too_many_faces(rim.settings);
    const FaceId f = waiting.back();
    waiting.pop_back();
    if (may_split(rim, f) && fails(rim, f)) split_near_rim(rim, f, waiting);
  }
  return Done{};
}

bool list_moves_in_plane(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) { add_moves_in_plane(rim, f, rim.work.snaps); });
}

bool list_moves_along_edges(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) { add_moves_along_edges(rim, f, rim.work.snaps); });
}

bool move_onto_rim(RimState& rim) {
  Mesh::Star star;
  return visit_nearest(rim.work.snaps, [&](const RimSnap& s) { move(rim, s, star); });
}

bool split_in_the_way(RimState& rim) {
  std::vector<FaceId>& faces = rim.work.in_the_way;
  if (rim.work.next == 0) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  const bool over = visit_next(rim, faces, [&](FaceId f) { split_near_rim(rim, f, rim.work.waiting); });
  if (over) faces.clear();
  return over;
}

bool list_near_rim(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) { add_very_near(rim, f, rim.work.snaps); });
}

bool settle_on_rim(RimState& rim) {
  Mesh::Star star;
  return visit_nearest(rim.work.snaps, [&](const RimSnap& s) {
    if (rim.distance(s.vertex, s.face) == 0) return;
    rim.mesh().star(s.vertex, star);
    if (star.alone && !without_chord(rim, star, s).valid()) rim.record_on_boundary(s.vertex);
  });
}

bool clip_at_rim(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) {
    for (Crossing edge = longest_crossing(rim, f); edge.found(); edge = longest_crossing(rim, f))
      split_at(rim, f, edge);
  });
}

bool select_within_rim(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) {
    if (rim.inside(f)) rim.work.waiting.push_back(f);
  });
}

bool remove_within_rim(RimState& rim) {
  std::vector<FaceId> going;
  const bool over = visit_next(rim, rim.work.waiting, [&](FaceId f) { going.push_back(f); });
  rim.work.removed |= !going.empty();
  remove_faces(rim.step, going);
  if (over) rim.work.waiting.clear();
  return over;
}

bool select_beside_rim(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) {
    if (rim.mesh().is_live(f) && on_rim(rim, f)) rim.work.waiting.push_back(f);
  });
}

bool flip_near_rim(RimState& rim) {
  return visit_next(rim, rim.work.waiting,
                    [&](FaceId f) { rim.work.flipped = flip_around(rim, f) || rim.work.flipped; });
}

}  // namespace kerf
