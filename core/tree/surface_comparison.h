#pragma once

#include <array>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/tree/aabb_tree.h"

namespace kerf {

// A mesh and the tree over it, which must outlive this object.
struct Surface {
  const Mesh& mesh;
  const AabbTree& tree;
};

// Returns points of a surface, spread evenly over its area; over its faces if it has no area. The points lie
// at equal steps of the cumulated area in the order of the faces and at those of a sequence of low
// discrepancy within each face (M. Roberts: The unreasonable effectiveness of quasirandom sequences, 2018),
// so they depend on the mesh alone. Precondition: the mesh has faces. O(face slots + count).
std::vector<Vec3> sample_surface(const Mesh& mesh, size_t count);

// Returns the distance of a point from a surface [m]. `closed`: the surface is closed and consistently
// oriented; the distance is then negative for points inside, i.e. those with a positive winding number,
// counted along a ray. Precondition: the surface has faces. O(log n) in general.
double signed_distance(const Surface& surface, bool closed, const Vec3& at);

// A rotation about the origin and then a translation [m].
struct RigidMotion {
  glm::dquat rotation{1, 0, 0, 0};
  Vec3 translation{0};

  Vec3 apply(const Vec3& p) const { return rotation * p + translation; }
};

enum class Alignment {
  kNone,
  kCentre,  // translates the centroid of one surface to that of the other
  kIcp,     // minimises the squared distances
};

// Returns the motion that aligns surface `a` with surface `b`.
//
// Method of kIcp: iterated nearest points with tangent planes (Y. Chen, G. Medioni: Object modelling by
// registration of multiple range images, 1991), as damped Gauss-Newton steps on the distances of 5000 samples
// of `a`. It starts from the best of six motions: none, equal centroids, and equal centroids and principal
// axes in their four orientations. It finds a local minimum, the overall one in general if the surfaces
// differ little. Fails with cancelled() when stopped; `progress` may be null. Precondition: both surfaces
// have faces.
Result<RigidMotion> align_surfaces(const Surface& a, const Surface& b, Alignment alignment,
                                   const Progress* progress);

// Distances of one surface from another [m].
struct SurfaceComparison {
  static constexpr size_t kSamples = 100'000;
  static constexpr size_t kBins = 20;

  // Distances with a sign: positive outside the other surface, negative inside.
  struct Signed {
    double min = 0, max = 0;  // of samples and vertices
    double mean = 0;          // of samples
    // Numbers of samples in bins of equal width from min to max.
    std::array<size_t, kBins> histogram{};
  };

  double max = 0;                   // of samples and vertices
  double mean = 0, rms = 0;         // of samples
  double p95 = 0;                   // 95 % of the samples are at most this far away
  std::optional<Signed> signed_by;  // if the other surface is closed
};

// Measures the distances of kSamples samples of `a` (see sample_surface) and of its vertices, moved by
// `motion`, from the nearest points of `b`. A point is inside `b` if the winding number of `b` along a ray
// from it is positive. `closed`: `b` is closed and consistently oriented. Fails with cancelled() when
// stopped; `progress` may be null. Precondition: both surfaces have faces. Multithreaded; O(log n) per point.
Result<SurfaceComparison> compare_surfaces(const Surface& a, const Surface& b, bool closed,
                                           const RigidMotion& motion, const Progress* progress);

}  // namespace kerf
