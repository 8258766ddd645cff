#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh.h"

namespace kerf::test {

// Finds how far points are from the triangles of a mesh, by a grid of cells.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const Mesh& mesh);

  // The distance of a point from the nearest face, m.
  double from(const Vec3& p) const;
  // The largest distance of the vertices of another mesh, and of so many random points a face.
  double of(const Mesh& other, int points_a_face, Random& random) const;

 private:
  std::array<int, 3> cell_of(const Vec3& p) const;

  std::vector<Triangle> faces_;
  Vec3 low_{0};
  double size_ = 1;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<std::vector<uint32_t>> cells_;
};

}  // namespace kerf::test
