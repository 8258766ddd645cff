#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"

namespace kerf {

// Shadows by ray tracing: the reference implementation against which shadow volumes are tested. It uses the
// geometry drawn by the GPU, i.e. corners rounded to the floats of a FloatFrame and no duplicate triangles,
// and computes everything else in double.
class ShadowRays {
 public:
  // Returns the display transform of a piece: a point p of the world is drawn at to_world(p); nullopt if the
  // piece is hidden.
  using PieceTransform = std::function<std::optional<Placement>(uint32_t piece)>;

  // Adds a copy of the body's current faces. `labels` as for ShadowCaster. O(n log n).
  void add(const Body& body, const FloatFrame& frame, const PieceTransform& transform_of,
           std::span<const uint32_t> labels = {});

  // A hit of a ray on a face.
  struct Seen {
    uint32_t body = 0;  // in the order of add()
    uint32_t face = 0;  // slot
    double length = 0;  // m, from the ray's origin
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  // Returns the ray's first hit at `nearest` metres or more, if any. Precondition: the direction is a unit
  // vector.
  std::optional<Seen> look(const Pose& ray, double nearest) const;

  // Returns the number of surfaces that occlude the light at the hit `seen` of `ray`: those between the point
  // and the light, and the face itself if the ray hits its unlit side. The face is excluded from the former
  // by its slot, not by a distance. Precondition: look(ray, ...) returned `seen`.
  int occluders(const Pose& ray, const Seen& seen, const Light& light) const;
  // Returns the number of surfaces between the light and a world point (m) that lies on no face.
  int occluders(const Vec3& point, const Light& light) const;

 private:
  struct Copy {
    Mesh mesh;
    AabbTree tree;
    std::vector<uint32_t> slots;  // by face of the copy: its slot in the body, ascending
    FloatFrame frame;
    Placement placement;
  };
  Pose to_copy(const Copy& copy, const Pose& ray) const;
  LightPoint on_copy(const Copy& copy, const Light& light) const;
  static int side_of(const Copy& copy, FaceId face, const LightPoint& light);
  int count_between(const Vec3& point, const Light& light, const Seen* but) const;

  std::vector<Copy> copies_;
  mutable std::vector<RayHit> hits_;
};

}  // namespace kerf
