#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/mesh/mesh.h"
#include "ui/gl/objects.h"
#include "ui/render/base_faces.h"

namespace kerf {

using FaceCorners = std::array<glm::vec3, 3>;  // in the body's float frame

// A face that is no more, with the corners that it had when it was last seen.
struct RemovedFace {
  FaceId face, base;
  FaceCorners corners{};
};

// What a body has lost.
//
// Its surface as loaded is drawn a little behind what is left of it, and so shows exactly where faces are
// gone, however they were split before. Of the faces themselves those are known that were loaded, and of the
// parts that those were split into those that were seen and are not tiny; at most kMost of these, so that
// memory stays bounded.
class RemovedFaces {
 public:
  static constexpr size_t kMost = 20'000;
  static constexpr float kSmallest = 0.006f;  // of a remembered part's longest edge, in the float frame

  // A part of a base face as it is now; it may be asked for again and again.
  void saw(FaceId f, const FaceCorners& corners);
  // The face of this slot is gone.
  void died(FaceId f, FaceId base);
  // The slot has a face, again perhaps.
  void came_back(FaceId f) { parts_.erase(f.index); }

  // The base faces and parts that are gone.
  std::vector<RemovedFace> list(const Mesh& mesh, const BaseFaces& bases) const;

  // Uploads the base faces that are no longer whole where the mesh changed since; O(base faces) then.
  void update(const Mesh& mesh, const BaseFaces& bases);
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
