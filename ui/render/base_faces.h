#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/base/float_frame.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The faces of a body as it was loaded, remembered for their smooth normals: a face that was split off one
// takes its corner normals from where its corners lie in it, so that cutting never changes how a surface
// shades.
//
// The normal at a corner is the mean, weighted by angle, of the faces around that position whose planes turn
// less than 35 degrees from its own. Expected linear time once; positions are compared to the bit. About 20
// bytes a face where the surface is smooth, 60 where every edge is sharp.
class BaseFaces {
 public:
  BaseFaces() = default;
  // The mesh as loaded: no face split or removed yet. Faces that are not are shaded flat.
  BaseFaces(const Mesh& mesh, const FloatFrame& frame);
  // The same, or that it was stopped. `progress` may be null.
  static Result<BaseFaces> build(const Mesh& mesh, const FloatFrame& frame, const Progress* progress);

  // Unit normals at three points of the plane of `base`, which are given in the body's float frame; also for
  // a base that is not remembered.
  std::array<glm::vec3, 3> normals_at(FaceId base, const std::array<glm::vec3, 3>& points) const;

  // Slots of faces as loaded; the corners of one in the float frame, nothing where it was no face.
  uint32_t count() const { return static_cast<uint32_t>(faces_.size()); }
  std::optional<std::array<glm::vec3, 3>> corners(FaceId base) const;

  // Memory that it holds.
  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  // What corners of faces around one position have in common that are smooth to one another.
  struct Corner {
    glm::vec3 at;
    uint32_t normal;  // packed
  };
  class Builder;

  bool knows(FaceId base) const { return base.index < faces_.size() && faces_[base.index][0] != kNone; }

  std::vector<Corner> corners_;
  std::vector<std::array<uint32_t, 3>> faces_;  // by face slot as loaded; kNone where it was no face
};

// A unit vector as the GPU's INT_2_10_10_10_REV and back.
uint32_t pack_normal(const glm::vec3& n);
glm::vec3 unpack_normal(uint32_t packed);

}  // namespace kerf
