#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"

namespace kerf {

// Loads a mesh file as a body; `unit` is that of its positions if the file states none. Fails like load_mesh
// and make_body. `progress` may be null.
Result<Body> load_body(std::string name, const std::filesystem::path& file, const Progress* progress,
                       FileUnit unit = FileUnit::kMetre);

// A piece to remesh, copied from its body.
struct PieceCopy {
  uint32_t label = 0;
  std::vector<FaceId> faces;         // of the body, ascending
  Mesh mesh;                         // face i is a copy of faces[i]
  std::vector<uint32_t> loaded;      // by face of `mesh`: the loaded face that contains it
  std::vector<uint32_t> components;  // by face of `mesh`: its loaded component; empty if the body has none
};

// Copies a piece. Precondition: it has faces. O(n log n).
PieceCopy copy_piece(const Body& body, uint32_t label);

// Creates the body that replaces a piece. Its triangles are sorted by the loaded faces from which they
// derive, so that `parts`, ranges of loaded faces, become ranges of the new ones. All data except the faces
// is copied from `body`. Fails like build_mesh and make_body; `progress` may be null. Preconditions:
// `remeshed` was computed from `copy.mesh` and has triangles, and `copy` is of `body`.
Result<Body> rebuilt_body(const Body& body, const PieceCopy& copy, Remeshed& remeshed,
                          std::span<const MeshPart> parts, const Progress* progress);

}  // namespace kerf
