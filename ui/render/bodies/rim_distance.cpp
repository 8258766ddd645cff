#include "ui/render/bodies/rim_distance.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace kerf {

namespace {

constexpr float kReach = 1.5f;  // widths; paths along edges are longer than straight lines

float distance_from_segment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 along = b - a;
  const float length2 = glm::dot(along, along);
  const float t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + t * along);
}

}  // namespace

// Ties are broken by vertex, so that the order does not depend on how the queue was filled.
bool RimDistance::Entry::operator<(const Entry& other) const {
  return std::tie(other.distance, other.vertex.index) < std::tie(distance, vertex.index);
}

class RimDistance::Search {
 public:
  Search(RimDistance& out, const Mesh& mesh, const BaseFaces& bases, const FloatFrame& frame)
      : out_(out), mesh_(mesh), bases_(bases), frame_(frame) {}

  // Returns true if a change at the vertex can affect distances: it or a neighbour has a rim side, or it is
  // on a rim. Most vertices of a newly shown mesh are far from all rims.
  bool matters(VertexId v) {
    if (v.index >= mesh_.vertex_slots()) return false;
    if (out_.near_.contains(v.index)) return true;
    bool known = false;
    for_each_neighbour(v, [&](VertexId next) { known = known || out_.near_.contains(next.index); });
    return known || is_on_rim(v);
  }

  // Returns the vertices that a change at `changed` can affect, with the next ones beyond them.
  std::vector<VertexId> reach(std::span<const VertexId> changed) {
    std::unordered_map<uint32_t, float> path;
    std::vector<VertexId> reached;
    const auto offer = [&](VertexId v, float length) {
      const auto [found, fresh] = path.try_emplace(v.index, length);
      if (fresh) reached.push_back(v);
      if (!fresh && found->second <= length) return;
      found->second = length;
      queue_.push({length, v});
    };
    for (const VertexId v : changed) {
      if (matters(v)) offer(v, 0);
    }
    while (!queue_.empty()) {
      const Entry nearest = queue_.top();
      queue_.pop();
      if (nearest.distance > path[nearest.vertex.index] || nearest.distance > kReach * out_.width_) continue;
      for_each_neighbour(nearest.vertex, [&](VertexId next) {
        offer(next, nearest.distance + glm::distance(at(nearest.vertex), at(next)));
      });
    }
    return reached;
  }

  // Recomputes the distances of the vertices; all others are right unless these come closer.
  void renew(std::span<const VertexId> vertices, std::vector<VertexId>& affected) {
    for (const VertexId v : vertices) out_.near_.erase(v.index);
    for (const VertexId v : vertices) {
      offer_rims(v);
      for_each_neighbour(v, [&](VertexId next) {
        const auto known = out_.near_.find(next.index);
        if (known != out_.near_.end() && known->second.distance <= out_.width_) offer(v, Near(known->second));
      });
    }
    while (!queue_.empty()) {
      const Entry nearest = queue_.top();
      queue_.pop();
      const Near known = out_.near_.at(nearest.vertex.index);
      if (nearest.distance > known.distance || known.distance > out_.width_) continue;
      for_each_neighbour(nearest.vertex, [&](VertexId next) {
        if (offer(next, known)) affected.push_back(next);
      });
    }
  }

 private:
  glm::vec3 at(VertexId v) const { return frame_.to_float(mesh_.position(v)); }

  template <typename Visit>
  void for_each_neighbour(VertexId v, const Visit& visit) {
    mesh_.star(v, star_);
    for (const FaceId f : star_.faces) {
      for (const VertexId corner : mesh_.corners(f)) {
        if (corner != v) visit(corner);
      }
    }
  }

  bool is_rim(FaceId f, VertexId from, VertexId to) {
    sides_.clear();
    mesh_.append_edge_sides(f, from, to, sides_);
    return sides_.empty() && !bases_.was_open(mesh_.data(f).base, at(from), at(to));
  }

  template <typename Visit>
  void for_each_rim(VertexId v, const Visit& visit) {
    mesh_.star(v, star_);
    for (const FaceId f : star_.faces) {
      const std::array<VertexId, 3> c = mesh_.corners(f);
      for (size_t i = 0; i < 3; ++i) {
        const VertexId from = c[i], to = c[(i + 1) % 3];
        if ((from == v || to == v) && is_rim(f, from, to)) visit(from, to);
      }
    }
  }

  bool is_on_rim(VertexId v) {
    bool on = false;
    for_each_rim(v, [&](VertexId, VertexId) { on = true; });
    return on;
  }

  void offer_rims(VertexId v) {
    for_each_rim(v, [&](VertexId from, VertexId to) { offer(v, {kFar, at(from), at(to)}); });
  }

  // Returns true if the side is the nearest known at the vertex.
  bool offer(VertexId v, const Near& side) {
    const float distance =
        distance_from_segment(at(v), side.from, side.to) + out_.behind_ * glm::distance(side.from, side.to);
    Near& known = out_.near_[v.index];
    if (!(distance < known.distance)) return false;
    known = {distance, side.from, side.to};
    queue_.push({distance, v});
    return true;
  }

  RimDistance& out_;
  const Mesh& mesh_;
  const BaseFaces& bases_;
  const FloatFrame& frame_;
  std::priority_queue<Entry> queue_;
  Mesh::Star star_;
  std::vector<Mesh::Side> sides_;
};

void RimDistance::update(const Mesh& mesh, const BaseFaces& bases, const FloatFrame& frame,
                         std::span<const VertexId> changed, std::vector<VertexId>& affected) {
  Search search(*this, mesh, bases, frame);
  const std::vector<VertexId> reached = search.reach(changed);
  affected.insert(affected.end(), reached.begin(), reached.end());
  search.renew(reached, affected);
}

}  // namespace kerf
