#pragma once

#include <span>

#include "core/mesh/mesh.h"

namespace kerf::bench {

// Edits of single edges and faces, for two kernels: no two of the edges have a face in common.
struct KernelEdits {
  struct Edge {
    FaceId face;
    VertexId from, to;
  };
  std::vector<Edge> splits;      // at their midpoints
  std::vector<FaceId> removals;  // each once
};

// What a kernel took for them, each kind on the mesh as it was, and the memory that it has allocated for
// that.
struct KernelStatistics {
  double split_seconds = 0, remove_seconds = 0;  // of processor time, for all
  double longest_seconds = 0;                    // of one split
  double bytes = 0;
};

// OpenMesh's half-edge kernel with doubles and the status bits that removing needs. Precondition: the mesh
// has no ring.
KernelStatistics time_openmesh(const Mesh& mesh, const KernelEdits& edits);

}  // namespace kerf::bench
