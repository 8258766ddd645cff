#include "tests/support/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/measures.h"

namespace kerf::test {

namespace {

constexpr int kCellsAlong = 60;

std::vector<Triangle> live_triangles(const Mesh& mesh) {
  std::vector<Triangle> all;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) all.push_back(mesh.triangle(FaceId(f)));
  }
  return all;
}

}  // namespace

SurfaceDistance::SurfaceDistance(const Mesh& mesh) : faces_(live_triangles(mesh)) {
  low_ = faces_[0][0];
  Vec3 high = low_;
  for (const Triangle& t : faces_) {
    for (const Vec3& p : t) {
      low_ = glm::min(low_, p);
      high = glm::max(high, p);
    }
  }
  const Vec3 extent = high - low_;
  size_ = std::max({extent.x, extent.y, extent.z}) / kCellsAlong;
  for (int k = 0; k < 3; ++k) count_[k] = static_cast<int>(extent[k] / size_) + 1;
  cells_.resize(static_cast<size_t>(count_[0]) * count_[1] * count_[2]);
  for (uint32_t f = 0; f < faces_.size(); ++f) {
    const Triangle& t = faces_[f];
    const auto first = cell_of(glm::min(glm::min(t[0], t[1]), t[2]));
    const auto last = cell_of(glm::max(glm::max(t[0], t[1]), t[2]));
    for (int x = first[0]; x <= last[0]; ++x) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int z = first[2]; z <= last[2]; ++z)
          cells_[(static_cast<size_t>(x) * count_[1] + y) * count_[2] + z].push_back(f);
      }
    }
  }
}

std::array<int, 3> SurfaceDistance::cell_of(const Vec3& p) const {
  std::array<int, 3> cell;
  for (int k = 0; k < 3; ++k)
    cell[k] = static_cast<int>(std::clamp((p[k] - low_[k]) / size_, 0.0, count_[k] - 1.0));
  return cell;
}

// In shells of cells around that of the point; a face beyond the shell at distance n is n cells away.
double SurfaceDistance::from(const Vec3& p) const {
  const auto c = cell_of(p);
  double least = std::numeric_limits<double>::infinity();
  const int most = std::max({count_[0], count_[1], count_[2]});
  for (int n = 0; n <= most && least > (n - 1) * size_ * std::abs((n - 1) * size_); ++n) {
    for (int x = std::max(0, c[0] - n); x <= std::min(count_[0] - 1, c[0] + n); ++x) {
      for (int y = std::max(0, c[1] - n); y <= std::min(count_[1] - 1, c[1] + n); ++y) {
        const bool side = std::abs(x - c[0]) == n || std::abs(y - c[1]) == n;
        for (int z = c[2] - n; z <= c[2] + n; z += side || n == 0 ? 1 : 2 * n) {
          if (z < 0 || z >= count_[2]) continue;
          for (const uint32_t f : cells_[(static_cast<size_t>(x) * count_[1] + y) * count_[2] + z])
            least = std::min(least, squared_distance(p, faces_[f]));
        }
      }
    }
  }
  return std::sqrt(least);
}

double SurfaceDistance::of(const Mesh& other, int points_a_face, Random& random) const {
  double most = 0;
  for (const Triangle& t : live_triangles(other)) {
    for (const Vec3& corner : t) most = std::max(most, from(corner));
    for (int i = 0; i < points_a_face; ++i) {
      double a = random.unit(), b = random.unit();
      if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
      }
      most = std::max(most, from(t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0])));
    }
  }
  return most;
}

}  // namespace kerf::test
