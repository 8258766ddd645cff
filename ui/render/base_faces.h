#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/float_frame.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The faces of a body as it was loaded, remembered for their smooth normals: a face that was split off one
// takes its corner normals from where its corners lie in it, so that cutting never changes how a surface
// shades.
//
// The normal at a corner is the mean, weighted by angle, of the faces around that position whose planes turn
// less than 35 degrees from its own. O(n log n) once; positions are compared to the bit.
class BaseFaces {
 public:
  BaseFaces() = default;
  // The mesh as loaded: no face split or removed yet. Faces that are not are shaded flat.
  BaseFaces(const Mesh& mesh, const FloatFrame& frame);

  // Unit normals at three points of the plane of `base`, which are given in the body's float frame; also for
  // a base that is not remembered.
  std::array<glm::vec3, 3> normals_at(FaceId base, const std::array<glm::vec3, 3>& points) const;

  // Slots of faces as loaded; the corners of one in the float frame, null where it was no face.
  uint32_t count() const { return static_cast<uint32_t>(bases_.size()); }
  const std::array<glm::vec3, 3>* corners(FaceId base) const {
    return bases_[base.index].known ? &bases_[base.index].corners : nullptr;
  }

 private:
  struct Base {
    std::array<glm::vec3, 3> corners{};
    std::array<uint32_t, 3> normals{};  // packed
    bool known = false;
  };
  std::vector<Base> bases_;  // by face slot as loaded
};

// A unit vector as the GPU's INT_2_10_10_10_REV and back.
uint32_t pack_normal(const glm::vec3& n);
glm::vec3 unpack_normal(uint32_t packed);

}  // namespace kerf
