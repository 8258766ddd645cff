#pragma once

#include <cstddef>
#include <string>

#include "core/base/random.h"
#include "core/mesh/mesh.h"

namespace kerf::test {

// What splitting without removing must leave as it is, counted from positions alone: the half-edges are not
// asked, so a fault in them shows.
struct MeshNumbers {
  double area = 0;
  double boundary_length = 0;  // of edges with one face
  size_t boundary_loops = 0;   // connected sets of such edges
  long euler = 0;              // vertices - edges + faces, copies of a face counted once
  size_t components = 0;       // over shared edges
};
MeshNumbers count_numbers(const Mesh& mesh);

// The same counted from the half-edges and rings: edges and vertices are one where the mesh says that they
// hang together. For real meshes, in which a midpoint may fall on a vertex that it has nothing to do with.
MeshNumbers count_connected_numbers(const Mesh& mesh);

// Expects what splitting must leave to be as it was, to the rounding of sums.
void expect_same(const MeshNumbers& before, const MeshNumbers& after);

double live_area(const Mesh& mesh);
FaceId random_live_face(const Mesh& mesh, Random& random);

// The first thing that is wrong with the half-edges, or nothing: neighbours that are not the faces on the
// same edge by position, dead neighbours, a hanging node (an edge of one face whose midpoint is a vertex with
// the two halves as edges). Real meshes may have vertices where midpoints fall (T-junctions), so that edges
// come to lie on one another which never hung together; with `chance_allowed` such faces need not be
// neighbours.
std::string find_fault(const Mesh& mesh, bool chance_allowed = false);

}  // namespace kerf::test
