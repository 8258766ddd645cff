#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// An edge at which a sheet ends or bends sharply.
struct FeatureEdge {
  VertexId from, to;
  FaceId face;       // a face on it
  bool rim = false;  // the sheet ends there; otherwise it is a crease
};

struct FeatureEdges {
  // All edges with one face and all at which faces meet at more than 40 degrees.
  std::vector<FeatureEdge> lines;
  // All other edges with three faces or more, which may all lie on one side: `rim` is false.
  std::vector<FeatureEdge> seams;
};

// The feature edges of a mesh, each once, in the order of the slots of their faces. `normals` are the unit
// normals of the live faces by slot. O(faces).
FeatureEdges feature_edges(const Mesh& mesh, const std::vector<Vec3>& normals);

// A sequence of vertices along feature edges; closed if the first and the last are the same.
using FeatureLine = std::vector<VertexId>;

// Joins edges that meet in vertices of exactly two of them. O(n + highest vertex).
std::vector<FeatureLine> joined(const std::vector<FeatureEdge>& edges);

}  // namespace kerf
