#pragma once

#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// How hot the corners of a face look, in halvings since the base faces: small faces are warm, and hottest is
// a rim that was cut through them. What glows falls off evenly over the faces instead of from one to the
// next.
class CornerHeat {
 public:
  // Faces that were halved less often never glow, and nothing is looked up for them.
  static constexpr uint32_t kLeastSmall = 4;

  // At the corners of a face, in the order of Mesh::triangle; zero for a dead one. At a corner on a rim a
  // little more than the finest face there has; at others half-way between the least and the mean of the
  // faces that share the corner by position and hang together there, and less, so that the glow is a thin
  // line along the rim. Constant time.
  std::array<float, 3> of(const Mesh& mesh, FaceId f);

  // The live faces that share a corner with f, itself included; none for one that never glows.
  const std::vector<FaceId>& faces_around(const Mesh& mesh, FaceId f);

 private:
  void find_fan(const Mesh& mesh, FaceId f, const Vec3& corner);
  bool fan_ends(const Mesh& mesh, const Vec3& corner);

  std::vector<FaceId> fan_, around_, neighbours_;
  std::vector<Vec3> spokes_;
};

}  // namespace kerf
