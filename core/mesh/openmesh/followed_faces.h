#pragma once

// Private to core/mesh/openmesh.
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/openmesh/remeshed.h"
#include "core/mesh/openmesh/sheets.h"

namespace kerf {

// Where the quarters of some faces of a mesh lie while its sheets are simplified. A quarter lies on the face
// that is nearest to its middle among those that took the place of the face on which it lay. So it never goes
// on to another sheet, and the cost of a collapse depends on the quarters around the removed vertex alone.
class FollowedFaces {
 public:
  // A face that a collapse changes, as it will be, in the frame of the sheets.
  struct Changed {
    OpenMeshKernel::FaceHandle face;
    Triangle corners;
  };

  // Each quarter lies on its own face. Precondition: `sheets` were made of `mesh`, and the faces are live.
  FollowedFaces(const Mesh& mesh, const Sheets& sheets, std::span<const FaceId> faces);

  // Whether any quarter lies on the face.
  bool lie_on(OpenMeshKernel::FaceHandle f) const { return !lying_.empty() && first_on(f) != kNone; }
  // Hands on what lies on `before`, the faces around a vertex that goes, to the changed ones among them.
  // Precondition: neither is empty.
  void hand_on(std::span<const OpenMeshKernel::FaceHandle> before, std::span<const Changed> changed);

  // The places of the quarters, in the order of the faces. O(faces).
  std::vector<FollowedFace> places(const Sheets& sheets) const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  uint32_t first_on(OpenMeshKernel::FaceHandle f) const { return lying_[static_cast<size_t>(f.idx())]; }

  std::vector<FaceId> faces_;
  std::vector<Vec3> middles_;    // of quarter i % 4 of face i / 4
  std::vector<uint32_t> lying_;  // by face handle: the first quarter of its list; empty if none is followed
  std::vector<uint32_t> next_;   // by quarter: the next one in the same list
};

}  // namespace kerf
