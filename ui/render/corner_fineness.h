#pragma once

#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// How hot the corners of faces appear when they are coloured by refinement level. The unit is the number of
// halvings since the base face: small faces are warm, and a rim that was cut through them is hottest. Values
// at corners make the glow vary smoothly across faces.
class CornerFineness {
 public:
  // Faces that were halved less often do not glow and cost nothing.
  static constexpr uint32_t kLeastSmall = 4;

  // The fineness at the corners of a face, in the order of Mesh::triangle; zero for a dead face. A corner on
  // a rim is slightly hotter than the finest face there. Any other corner gets a value below the midpoint
  // between the minimum and the mean of the faces that are connected around it, so that the glow is a thin
  // line along the rim. Constant time.
  std::array<float, 3> of(const Mesh& mesh, FaceId f);

  // The live faces that share a corner with f, including f; none for a face that does not glow.
  const std::vector<FaceId>& faces_around(const Mesh& mesh, FaceId f);

 private:
  void find_fan(const Mesh& mesh, FaceId f, const Vec3& corner);
  bool fan_ends(const Mesh& mesh, const Vec3& corner);

  std::vector<FaceId> fan_, around_, neighbours_;
  std::vector<Vec3> spokes_;
};

}  // namespace kerf
