#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Faces that are to be followed, each with a value that the triangles cannot keep apart where one lies over
// several faces, such as a temperature.
struct Followed {
  struct Face {
    FaceId face;
    double value;
  };
  std::vector<Face> faces;
  double elsewhere = 0;   // the value of all other faces
  double most_mixed = 0;  // by how much the values may differ of faces over which one triangle comes to lie
};

// What a tool made of a mesh: triangles over welded positions, none of which has two corners at the same
// position.
struct Remeshed {
  std::vector<Vec3>
      positions;  // metres, in the frame of the mesh; those of vertices that stayed are bit-equal
  std::vector<std::array<uint32_t, 3>> triangles;  // indices of positions
  // The face of the mesh from which each triangle stems and takes its data, ascending.
  std::vector<FaceId> origins;
  // By triangle the followed face where its middle lies, invalid where there is none. Empty where no face was
  // followed, and where triangles lie where the faces did from which they stem.
  std::vector<FaceId> middles;
};

// The materials of the triangles, those of the faces from which they stem. Precondition: `remeshed` was made
// of `mesh`.
std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh);

// Builds the mesh of the triangles with build_mesh; its face slots have their order. Names and parts are left
// empty. Same precondition. Fails with cancelled() when stopped; `progress` may be null. O(n log n).
Result<BuiltMesh> build_remeshed(const Remeshed& remeshed, const Mesh& mesh, const Progress* progress);

}  // namespace kerf
