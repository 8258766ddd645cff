#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"

namespace kerf {

// Loads a mesh file and makes a body of it, with the errors of load_mesh and make_body. `progress` may be
// null.
Result<Body> load_body(std::string name, const std::filesystem::path& file, const Progress* progress);

// A piece to be remeshed, with its faces copied from its body.
struct PieceCopy {
  uint32_t label = 0;
  std::vector<FaceId> faces;         // of the body, ascending
  Mesh mesh;                         // face i is a copy of faces[i]
  std::vector<uint32_t> loaded;      // by face of `mesh`: the loaded face that contains it
  std::vector<uint32_t> components;  // by face of `mesh`: of LoadedComponents; empty if the body has none
};

// Copies a piece. Precondition: it has faces. O(n log n).
PieceCopy copy_piece(const Body& body, uint32_t label);

// Makes the body that replaces a piece. Triangles are sorted by the loaded faces they stem from, so that
// `parts` of loaded faces become parts of the new ones. All data but the faces is copied from `body`. Fails
// like build_mesh and make_body; `progress` may be null. Precondition: `remeshed` was made of `copy.mesh`,
// which was made of `body`, and has triangles.
Result<Body> rebuilt_body(const Body& body, const PieceCopy& copy, Remeshed& remeshed,
                          std::span<const MeshPart> parts, const Progress* progress);

}  // namespace kerf
