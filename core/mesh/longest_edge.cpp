#include "core/mesh/longest_edge.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace kerf {

namespace {

bool less(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// An edge in the order that decides which is the longest; equal for the same edge in whichever face and
// sheet.
struct EdgeRank {
  double length2 = -1;
  Vec3 low{0}, high{0};

  EdgeRank() = default;
  EdgeRank(const Vec3& a, const Vec3& b) : length2(glm::dot(b - a, b - a)), low(a), high(b) {
    if (less(high, low)) std::swap(low, high);
  }
  bool operator<(const EdgeRank& other) const {
    if (length2 != other.length2) return length2 < other.length2;
    if (low != other.low) return less(low, other.low);
    return less(high, other.high);
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

// One walk along a propagation path, from its first face to the end and back.
class Propagation {
 public:
  Propagation(Mesh& mesh, OneToFour& greens, std::vector<Replacement>& out)
      : mesh_(mesh), greens_(greens), out_(out) {}

  bool bisect(FaceId f) {
    path_.assign(1, f);
    while (!path_.empty()) {
      const LongestEdge edge = longest_edge(mesh_, path_.back());
      if (const FaceId further = with_longer_edge(edge); further.valid()) {
        path_.push_back(further);
        continue;
      }
      const Vec3 &a = edge.rank.low, &b = edge.rank.high, middle = 0.5 * a + 0.5 * b;
      if (middle == a || middle == b) return false;
      split(edge);
      path_.pop_back();
    }
    return true;
  }

 private:
  // A face on the edge that has a longer one; none at the end of the path. Remembers the others.
  FaceId with_longer_edge(const LongestEdge& edge) {
    sides_.clear();
    mesh_.append_edge_sides(path_.back(), edge.from, edge.to, sides_);
    for (const Mesh::Side& side : sides_) {
      if (edge.rank < longest_edge(mesh_, side.face).rank) return side.face;
    }
    return FaceId();
  }

  void split(const LongestEdge& edge) {
    greens_.forget(mesh_, path_.back());
    for (const Mesh::Side& side : sides_) greens_.forget(mesh_, side.face);
    splits_.clear();
    mesh_.split_edge(path_.back(), edge.from, edge.to, splits_);
    for (const Mesh::FaceSplit& s : splits_) {
      FaceData& kept = mesh_.data(s.kept);
      if (kept.halvings < std::numeric_limits<uint8_t>::max()) ++kept.halvings;
      mesh_.data(s.added).halvings = kept.halvings;
      out_.push_back({{s.kept, FaceId()}, {s.kept, s.added, FaceId(), FaceId()}, 1, 2});
    }
  }

  Mesh& mesh_;
  OneToFour& greens_;
  std::vector<Replacement>& out_;
  std::vector<FaceId> path_;
  std::vector<Mesh::Side> sides_;
  std::vector<Mesh::FaceSplit> splits_;
};

}  // namespace

bool bisect_longest_edge(Mesh& mesh, OneToFour& greens, FaceId f, std::vector<Replacement>& out) {
  return Propagation(mesh, greens, out).bisect(f);
}

}  // namespace kerf
