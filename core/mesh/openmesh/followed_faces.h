#pragma once

// Private to core/mesh/openmesh.
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/openmesh/remeshed.h"
#include "core/mesh/openmesh/sheets.h"

namespace kerf {

// Where some faces of a mesh lie while its sheets are simplified. Their quarters lie on the faces of the
// sheets: each on the one that is nearest to its middle among those that took the place of the face on which
// it lay. So none goes on to another sheet, and the cost of a collapse depends on the quarters around the
// removed vertex alone.
class FollowedFaces {
 public:
  // The faces around a vertex that a collapse removes, in the frame of the sheets.
  struct Around {
    struct Face {
      OpenMeshKernel::FaceHandle face;
      Triangle corners;
    };
    std::vector<Face> before;  // the collapse
    std::vector<Face> after;   // those that are left
  };

  // Each quarter lies on its own face. Precondition: `sheets` were made of `mesh`, and the faces are live.
  FollowedFaces(const Mesh& mesh, const Sheets& sheets, const Followed& followed);

  // Whether any face that is followed lies on the face.
  bool lie_on(OpenMeshKernel::FaceHandle f) const { return !lying_.empty() && on(f).middle != kNone; }
  // Whether the values stay apart in such a collapse. Precondition: there are faces before and after it.
  bool stay_apart(const Around& around);
  // Follows a collapse. Same precondition.
  void hand_on(const Around& around);

  // Remeshed::middles of the triangles that stem from these faces.
  std::vector<FaceId> middles(const Sheets& sheets, std::span<const FaceId> origins) const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  // What lies on a face of the sheets.
  struct Lying {
    uint32_t first = kNone;   // of its quarters
    uint32_t middle = kNone;  // the index of the followed face where its middle lies
  };
  // What would come to lie on a face.
  struct Mixed {
    double least, most;  // of the values
    double area = 0;     // of the quarters
  };

  Lying& on(OpenMeshKernel::FaceHandle f) { return lying_[static_cast<size_t>(f.idx())]; }
  const Lying& on(OpenMeshKernel::FaceHandle f) const { return lying_[static_cast<size_t>(f.idx())]; }
  double value_of(uint32_t face) const { return face == kNone ? elsewhere_ : faces_[face].value; }
  std::vector<uint32_t> quarters_before(const Around& around) const;

  std::vector<Followed::Face> faces_;
  double elsewhere_, most_mixed_;
  std::vector<Vec3> middles_;   // of quarter i % 4 of face i / 4, in the frame of the sheets
  std::vector<double> areas_;   // of a quarter of face i
  std::vector<Lying> lying_;    // by face handle; empty if none is followed
  std::vector<uint32_t> next_;  // by quarter: the next one on the same face
};

}  // namespace kerf
