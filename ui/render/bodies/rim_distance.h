#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/mesh.h"
#include "ui/render/bodies/base_faces.h"

namespace kerf {

// The distance of the vertices of a mesh from the nearest rim of a cut.
//
// A side of a live face lies on a rim if no other face shares it and it is not on the boundary of the mesh
// as loaded. Near a rim every vertex stores its nearest side; it is propagated from vertex to vertex in the
// order of distance (E. W. Dijkstra: A note on two problems in connexion with graphs, 1959), and the
// distance of a vertex is the straight line to that side. On surfaces that are nearly flat within the width
// this is the distance along the surface, and it hardly depends on how the surface is split.
//
// All lengths are in the float frame of the body.
class RimDistance {
 public:
  static constexpr float kFar = 60000;  // of vertices far from all rims; fits a half float

  static constexpr float kBehind = 0.15f;

  // Distances are known up to `width`, and to the next vertices beyond it. They are measured from behind
  // the rim, by the fraction `behind` of the length of its side: a coarse rim is a rough estimate of a
  // smooth one.
  explicit RimDistance(float width, float behind = kBehind) : width_(width), behind_(behind) {}

  float width() const { return width_; }

  // The distance of a vertex; kFar if no rim is near.
  float of(VertexId v) const {
    const auto found = near_.find(v.index);
    return found == near_.end() ? kFar : found->second.distance;
  }
  // Returns true if the mesh has a rim.
  bool any() const { return !near_.empty(); }

  // Follows a change of the mesh. `changed` are the vertices of all faces that were added, removed or got
  // new corners; vertices missing in the mesh are skipped. Appends the vertices whose distance may have
  // changed to `affected`. The cost depends on the number of vertices within the width of the change.
  void update(const Mesh& mesh, const BaseFaces& bases, const FloatFrame& frame,
              std::span<const VertexId> changed, std::vector<VertexId>& affected);

 private:
  struct Near {
    float distance = kFar;
    glm::vec3 from{0}, to{0};  // nearest side of a rim
  };
  struct Entry {
    float distance;
    VertexId vertex;
    bool operator<(const Entry& other) const;
  };
  class Search;

  float width_, behind_;
  std::unordered_map<uint32_t, Near> near_;  // by vertex; only for lookup, never iterated
};

}  // namespace kerf
