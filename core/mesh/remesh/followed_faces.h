#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/float_frame.h"
#include "core/mesh/mesh.h"
#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// Where the quarters of some faces of a mesh lie while its sheets are simplified. A quarter lies on the face
// that is nearest to its middle among those that took the place of the face on which it lay. So it never goes
// on to another sheet, and the cost of a collapse depends on the quarters around the removed vertex alone.
class FollowedFaces {
 public:
  // A face that a collapse changes, by its number, as it will be, in the frame of the sheets.
  struct Changed {
    uint32_t face;
    Triangle corners;
  };

  // Each quarter lies on its own face. `numbers` has the faces of the mesh by their number on the sheets,
  // ascending, and `frame` is that of the sheets. Precondition: the faces are live.
  FollowedFaces(const Mesh& mesh, const FloatFrame& frame, std::span<const FaceId> numbers,
                std::span<const FaceId> faces);

  // Whether any quarter lies on the face.
  bool lie_on(uint32_t f) const { return !lying_.empty() && first_on(f) != kNone; }
  // Hands on what lies on `before`, the faces around a vertex that goes, to the changed ones among them.
  // Precondition: neither is empty.
  void hand_on(std::span<const uint32_t> before, std::span<const Changed> changed);

  // The places of the quarters, in the order of the faces; `numbers` as for the constructor. O(faces).
  std::vector<FollowedFace> places(std::span<const FaceId> numbers) const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  uint32_t first_on(uint32_t f) const { return lying_[f]; }

  std::vector<FaceId> faces_;
  std::vector<Vec3> middles_;  // of quarter i % 4 of face i / 4
  std::vector<uint32_t>
      lying_;  // by number of the face: the first quarter of its list; empty if none is followed
  std::vector<uint32_t> next_;  // by quarter: the next one in the same list
};

}  // namespace kerf
