#pragma once

#include <array>
#include <map>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// A face that the beam removed, as it was when it was removed. Its neighbours are the nearest faces of
// Mesh::append_nearest_neighbours that were live then, so that the links between the faces of a cut do not
// depend on whether vertices were moved or edges split afterwards. Entries without a face are invalid.
struct CutFace {
  FaceId face, base;
  uint32_t piece = 0;        // its label then
  bool closed_loop = false;  // whether removing it closed a loop of removed faces (see CutLoops)
  Triangle corners{};        // m, in the frame of the body
  std::array<FaceId, 9> neighbours{};
};

// The faces that the beam removed from bodies, in the order of removal.
using CutFaces = std::map<BodyId, std::vector<CutFace>>;

}  // namespace kerf
