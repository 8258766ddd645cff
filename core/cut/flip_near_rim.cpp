#include <algorithm>
#include <cmath>

#include "core/base/tolerances.h"
#include "core/cut/rim_state.h"

namespace kerf {

namespace {

Vec3 area_vector(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

// Whether two faces of one base lie in one plane, as far as doubles can tell.
bool in_one_plane(const Triangle& s, const Triangle& t) {
  const Vec3 n = area_vector(s), m = area_vector(t);
  return glm::dot(n, m) >= kCoplanar * std::sqrt(glm::dot(n, n)) * std::sqrt(glm::dot(m, m));
}

// The edge of a face that turning it would gain most on, in its plane.
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

  bool pays() const { return gain_ > kLeastFlipGain; }

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

bool choose_beside_rim(RimState& rim) {
  return visit_next(rim, rim.faces, [&](FaceId f) {
    if (rim.mesh().is_live(f) && on_rim(rim, f)) rim.work.waiting.push_back(f);
  });
}

bool flip_near_rim(RimState& rim) {
  return visit_next(rim, rim.work.waiting,
                    [&](FaceId f) { rim.work.flipped = flip_around(rim, f) || rim.work.flipped; });
}

}  // namespace kerf
