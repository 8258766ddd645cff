#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/float_frame.h"
#include "core/shadow/light.h"
#include "core/world/world.h"

namespace kerf {

// Shadows by tracing rays: the reference that shadow volumes are measured by. It sees what the GPU draws,
// bodies with their corners rounded to the floats of their frame, exact duplicates of a triangle left out,
// and decides everything else in double.
class ShadowRays {
 public:
  // Where the faces of a piece are drawn: moved by so much in the axes of the world (m), or not at all.
  using PieceOffset = std::function<std::optional<Vec3>(uint32_t piece)>;

  // Adds the faces of a body as they are now, which are copied. O(n log n).
  void add(const Body& body, const FloatFrame& frame, const PieceOffset& offset_of);

  // What a ray of unit direction meets first, farther along it than `nearest` (m).
  struct Seen {
    uint32_t body = 0;  // in the order of add()
    uint32_t face = 0;  // slot
    double length = 0;  // m, from the ray's origin
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  std::optional<Seen> look(const Pose& ray, double nearest) const;

  // How many surfaces keep the light from a point of the face that a ray sees: those between, and the face
  // itself where the side that is seen is averted. The face is left out by its slot, not by a distance.
  int occluders(const Pose& ray, const Seen& seen, const Light& light) const;
  // The same for a point of the world that lies on no face.
  int occluders(const Vec3& point, const Light& light) const;

 private:
  struct Copy {
    Mesh mesh;
    AabbTree tree;
    std::vector<uint32_t> slots;  // of the body, by face of the copy
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
