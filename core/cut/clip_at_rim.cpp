#include "core/base/tolerances.h"
#include "core/cut/rim_state.h"

namespace kerf {

namespace {

struct Crossing {
  VertexId from, to;  // as the face walks the edge
  bool from_inside = false;
  double length2 = -1;
  bool found() const { return length2 >= 0; }
};

// The longest of the face's edges across the boundary.
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
  const VertexId in = edge.from_inside ? edge.from : edge.to, out = edge.from_inside ? edge.to : edge.from;
  const Vec3 a = rim.mesh().position(in), b = rim.mesh().position(out), at = rim.region.crossing(f, a, b);
  const double on_boundary = kRimOn * rim.radius();
  if (glm::length(at - a) <= on_boundary) return rim.note_on_boundary(in);
  if (glm::length(at - b) <= on_boundary) return rim.note_on_boundary(out);
  std::vector<Mesh::FaceSplit> splits;
  rim.step.edit.split_edge_at(f, edge.from, edge.to, at, splits);
  for (const Mesh::FaceSplit& s : splits) {
    rim.note_on_boundary(s.midpoint);
    if (!rim.region.is_near(s.kept)) continue;
    rim.region.inherit({&s.added, 1}, {&s.kept, 1});
    rim.faces.push_back(s.added);
  }
}

}  // namespace

bool clip_at_rim(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) {
    for (Crossing edge = longest_crossing(rim, f); edge.found(); edge = longest_crossing(rim, f))
      split_at(rim, f, edge);
  });
}

bool choose_within_rim(RimState& rim) {
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

}  // namespace kerf
