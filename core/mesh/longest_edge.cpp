#include "core/mesh/longest_edge.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/assert.h"

namespace kerf {

namespace {

// The rank of an edge in the order by length; the same for an edge in all faces and sheets.
struct EdgeRank {
  double length2 = -1;
  Vec3 low{0}, high{0};

  EdgeRank() = default;
  EdgeRank(const Vec3& a, const Vec3& b) : length2(glm::dot(b - a, b - a)), low(a), high(b) {
    if (precedes(high, low)) std::swap(low, high);
  }
  bool operator<(const EdgeRank& other) const {
    if (length2 != other.length2) return length2 < other.length2;
    if (low != other.low) return precedes(low, other.low);
    return precedes(high, other.high);
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
      while (step.looked_at < sides_.size() && !(step.edge.rank < rank_at(sides_[step.looked_at])))
        ++step.looked_at;
      if (step.looked_at < sides_.size()) {
        step_onto(sides_[step.looked_at].face);
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
  // A face of the path, its longest edge, and where the other faces on that edge begin in `sides_`; those of
  // the last step reach to its end. Those before index `looked_at` have no longer edge, so that each face of
  // a ring is examined once.
  struct Step {
    FaceId face;
    LongestEdge edge;
    size_t first_side, looked_at;
  };

  void step_onto(FaceId f) {
    const Step step{f, longest_edge(mesh_, f), sides_.size(), sides_.size()};
    mesh_.append_edge_sides(f, step.edge.from, step.edge.to, sides_);
    path_.push_back(step);
  }

  // The rank of the longest edge of the face examined next. If that face was bisected further along the path
  // in the meantime, one of its parts has the edge, as a rule one of the latest.
  EdgeRank rank_at(Mesh::Side& side) {
    if (!has(side.face, side)) side.face = latest_part_with(side);
    KERF_ASSERT(side.face.valid());
    return longest_edge(mesh_, side.face).rank;
  }

  bool has(FaceId f, const Mesh::Side& side) const { return mesh_.has_side(f, side.from, side.to); }

  FaceId latest_part_with(const Mesh::Side& side) {
    constexpr size_t kLatest = 8;
    for (size_t i = out_.size(); i > first_ && i + kLatest > out_.size(); --i) {
      for (const FaceId f : {out_[i - 1].born[0], out_[i - 1].born[1]}) {
        if (has(f, side)) return f;
      }
    }
    return part_with(side, side.face);
  }

  // The part of a face, whose slot one of them has, that has the side; none if no part has it.
  FaceId part_with(const Mesh::Side& side, FaceId f) {
    if (has(f, side)) return f;
    index_splits();
    const auto latest = latest_.find(f.index);
    for (size_t i = latest == latest_.end() ? 0 : latest->second; i > 0; i = before_[i - 1]) {
      const FaceId found = part_with(side, out_[first_ + i - 1].born[1]);
      if (found.valid()) return found;
    }
    return FaceId();
  }

  // Numbers what was split since the path began, so that in a ring of many faces each part is found at once.
  void index_splits() {
    if (indexed_ == first_) {
      latest_.clear();
      before_.clear();
    }
    for (; indexed_ < out_.size(); ++indexed_) {
      size_t& latest = latest_[out_[indexed_].gone[0].index];
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
  size_t first_ = 0, indexed_ = 0;  // of out_: since the path began, and up to where they are numbered
  std::unordered_map<uint32_t, size_t> latest_;  // by slot: the number of its latest split; never iterated
  std::vector<size_t> before_;  // by number, from 1: that of the split of the slot before it; 0 if none
};

}  // namespace

bool bisect_longest_edge(Mesh& mesh, OneToFour& greens, FaceId f, std::vector<Replacement>& out) {
  return Propagation(mesh, greens, out).bisect(f);
}

}  // namespace kerf
