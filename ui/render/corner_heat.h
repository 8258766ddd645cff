#pragma once

#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// How fine the mesh is around the corners of a face, in halvings since the base faces: what glows falls off
// evenly over the faces instead of from one to the next.
class CornerHeat {
 public:
  // Faces that were halved less often never glow, and nothing is looked up for them.
  static constexpr uint32_t kLeastSmall = 4;

  // At the corners of a face, in the order of Mesh::triangle; zero for a dead one. Half-way between the least
  // and the mean of the faces that share the corner by position and hang together there, so that the glow is
  // thin. Constant time.
  std::array<float, 3> of(const Mesh& mesh, FaceId f);

  // The live faces that share a corner with f, itself included; none for one that never glows.
  const std::vector<FaceId>& faces_around(const Mesh& mesh, FaceId f);

 private:
  void find_fan(const Mesh& mesh, FaceId f, const Vec3& corner);

  std::vector<FaceId> fan_, around_, neighbours_;
};

}  // namespace kerf
