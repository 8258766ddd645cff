#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/mesh/mesh.h"
#include "ui/gl/objects.h"
#include "ui/render/bodies/base_faces.h"

namespace kerf {

using FaceCorners = std::array<glm::vec3, 3>;  // in the body's float frame

// A removed face with its last known corners.
struct RemovedFace {
  FaceId face, base;
  FaceCorners corners{};
};

// The faces that were removed from a body.
//
// The surface as loaded is drawn slightly behind the remaining surface, so that it is visible exactly where
// faces were removed, however they were split before. As individual faces, the base faces are known, and
// those parts of base faces that were seen and are not tiny; at most kMost of them, so that memory is
// bounded.
class RemovedFaces {
 public:
  static constexpr size_t kMost = 20'000;
  static constexpr float kSmallest =
      0.006f;  // longest edge below which parts are not recorded, in the float frame

  // Records the current corners of a part of a base face; may be called repeatedly.
  void saw(FaceId f, const FaceCorners& corners);
  // Reports that the face of a slot was removed.
  void died(FaceId f, FaceId base);
  // Reports that the slot has a face, perhaps again.
  void came_back(FaceId f) { parts_.erase(f.index); }

  // All removed base faces and recorded parts.
  std::vector<RemovedFace> list(const Mesh& mesh, const BaseFaces& bases) const;

  // Uploads the base faces that are incomplete, if forget() was called since. O(base faces) then.
  void update(const Mesh& mesh, const BaseFaces& bases);
  // Reports that the mesh has changed.
  void forget() { old_ = true; }
  // Draws them; attribute 0 is the position, 1 the index of the base face.
  void draw() const;

 private:
  std::unordered_map<uint32_t, FaceCorners> seen_;  // by slot; looked up, never walked
  std::map<uint32_t, RemovedFace> parts_;           // by slot
  gl::Buffer buffer_;
  gl::VertexArray layout_;
  GLsizei count_ = 0;
  bool old_ = true;
};

}  // namespace kerf
