#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/mesh/soup.h"

namespace kerf {

// What building did to the faces of the file; every face is accounted for:
// triangles_in_file = faces + degenerate_faces_dropped + non_finite_faces_dropped + invalid_faces_dropped.
struct Repairs {
  size_t welded_vertices = 0;            // positions that another vertex of the file had already
  size_t duplicated_vertices = 0;        // vertices made so that each sheet has its own
  size_t reoriented_faces = 0;           // turned round to agree with their neighbours
  size_t degenerate_faces_dropped = 0;   // two corners at the same position
  size_t non_finite_faces_dropped = 0;   // a corner that is not a finite number
  size_t invalid_faces_dropped = 0;      // an index that is not there
  size_t zero_area_faces = 0;            // kept: they hold their neighbours together
  size_t isolated_vertices_dropped = 0;  // used by no face that is kept
};

// What is in the file, as `kerf info` prints it.
struct MeshReport {
  std::string format;
  size_t faces_in_file = 0;
  size_t triangles_in_file = 0;
  size_t faces = 0;
  size_t vertices = 0;            // different positions in use
  size_t boundary_edges = 0;      // edges with one face, after welding
  size_t non_manifold_edges = 0;  // edges with three faces or more, after welding
  size_t components = 0;          // sets of faces joined over edges, whatever the number of faces on them
  double area = 0;                // m^2
  Vec3 min{0}, max{0};            // bounds of the faces that are kept, m
  Repairs repairs;
  std::vector<std::string> warnings;
};

struct BuiltMesh {
  Mesh mesh;
  MeshReport report;
  std::vector<std::string> material_names;
};

// From a soup to a conforming half-edge mesh: equal positions are welded, faces that cannot be used dropped
// and counted, components oriented, edges of three or more faces split into rings and vertices where several
// fans meet given one vertex a fan. Face slots follow the order of the soup's triangles. Fails when no face
// is left. O(n log d), d the largest number of edges at a vertex.
Result<BuiltMesh> build_mesh(const Soup& soup, const Progress* progress = nullptr);

}  // namespace kerf
