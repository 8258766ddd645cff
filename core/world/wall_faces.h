#pragma once

#include "core/mesh/mesh.h"

namespace kerf {

// Which faces of a mesh are walls, i.e. were made on the boundary of what a beam swept to close a solid body
// (see core/walls). A wall is its own base face, and knows the base face of a face beside it, through which
// it belongs to a part of what was loaded.
struct WallFaces {
  FaceColumn<uint32_t> beside_of;  // the index of that base face plus one; 0 for other faces

  // Precondition: no change of the mesh is open.
  static WallFaces attach(Mesh& mesh) { return {mesh.columns().attach_copied<uint32_t>()}; }

  bool contain(const Mesh& mesh, FaceId f) const { return mesh.columns().get(beside_of, f) != 0; }
  // The base face beside a wall; invalid for other faces.
  FaceId beside(const Mesh& mesh, FaceId f) const { return FaceId(mesh.columns().get(beside_of, f) - 1); }
  void set(Mesh& mesh, FaceId f, FaceId base) const { mesh.columns().set(beside_of, f, base.index + 1); }
};

}  // namespace kerf
