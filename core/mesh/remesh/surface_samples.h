#pragma once

#include <span>
#include <vector>

#include "core/mesh/remesh/flat_surface.h"
#include "core/mesh/remesh/followed_faces.h"

namespace kerf {

// Bounds the distance of the surface that was from the surface that is, at samples: vertices, edge midpoints
// and face centroids. Looking at removed vertices alone, as OpenMesh's ModHausdorffT does, left points
// between them up to five times as far away.
class SurfaceSamples {
 public:
  // Takes samples of the surface as it is. O(faces).
  explicit SurfaceSamples(const FlatSurface& surface);

  // The greatest distance at which a sample is near, in the frame of the surface.
  void set_most(double most) { most2_ = most * most; }

  // Whether the samples on the faces `before`, and a vertex `gone`, are near enough to any of the changed
  // faces.
  bool are_near(std::span<const uint32_t> before, const Vec3& gone,
                std::span<const FollowedFaces::Changed> changed) const;
  // Hands on what lies on `before`, and a vertex that is gone, to the nearest of the changed faces.
  // Precondition: there are changed faces.
  void hand_on(std::span<const uint32_t> before, const Vec3& gone,
               std::span<const FollowedFaces::Changed> changed);

 private:
  void add(uint32_t face, const Vec3& p);

  double most2_ = 0;
  std::vector<Vec3> points_;
  std::vector<uint32_t> next_;   // by sample: the next one on the same face
  std::vector<uint32_t> first_;  // by face
};

}  // namespace kerf
