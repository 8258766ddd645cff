#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/mesh.h"

namespace kerf {

class Looks;

// Repairs made while building a mesh. Every triangle of the file is counted: triangles_in_file = faces +
// degenerate_faces_dropped + non_finite_faces_dropped + invalid_faces_dropped. Incomplete faces have
// no triangle.
struct Repairs {
  size_t welded_vertices = 0;            // used vertices at the position of an earlier vertex of the file
  size_t duplicated_vertices = 0;        // added, because each sheet has vertices of its own
  size_t reoriented_faces = 0;           // flipped to agree with their neighbours, or outward
  size_t degenerate_faces_dropped = 0;   // two corners at the same position
  size_t non_finite_faces_dropped = 0;   // a corner with a non-finite coordinate
  size_t invalid_faces_dropped = 0;      // a vertex index out of range
  size_t incomplete_faces_dropped = 0;   // polygons of the file with fewer than three corners
  size_t zero_area_faces = 0;            // kept, because they connect their neighbours
  size_t isolated_vertices_dropped = 0;  // used by no face of the mesh
};

// A description of the file and of its mesh, as printed by `kerf info`.
struct MeshReport {
  std::string format;
  size_t faces_in_file = 0;
  size_t triangles_in_file = 0;
  size_t faces = 0;
  size_t vertices = 0;            // distinct positions in use
  size_t boundary_edges = 0;      // edges with one face, after welding
  size_t non_manifold_edges = 0;  // edges with three or more faces, after welding
  size_t components = 0;          // sets of faces connected over edges with any number of faces
  double area = 0;                // m^2
  Vec3 min{0}, max{0};            // bounding box of the mesh, m
  Repairs repairs;
  std::vector<std::string> warnings;
  std::string overlap_warning;  // one of these, true until inner shells are turned; empty if there is none
};

struct BuiltMesh {
  Mesh mesh;
  MeshReport report;
  std::vector<std::string> material_names;  // by FaceData::material; empty if the file names none
  std::vector<MeshPart> parts;              // of the soup, as ranges of faces; empty ones are dropped
  std::shared_ptr<const Looks> looks;       // null if the file has none
};

// Builds a conforming half-edge mesh from a soup:
// - Welds equal positions; drops and counts unusable faces.
// - Orients components consistently, and flips closed parts that face inward, unless they are inside another
//   closed part, where they may be cavities.
// - Splits edges of three or more faces into rings, in which each closed shell has one edge.
// - Gives each fan of faces around a vertex a vertex of its own.
// Face slots have the order of the soup's triangles. Fails if no face remains, for a mesh wider than 1e150 m,
// whose squared lengths may overflow, or with cancelled() when stopped; `progress` may be null. Precondition:
// all indices of the soup are in range. O(n log d), where d is the maximum number of edges at a vertex.
Result<BuiltMesh> build_mesh(const Soup& soup, const Progress* progress = nullptr);

}  // namespace kerf
