#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/mesh.h"

namespace kerf {

// An edge at which a sheet ends or bends sharply.
struct FeatureEdge {
  VertexId from, to;
  FaceId face;       // a face on it
  bool rim = false;  // true if the sheet ends there, false for a crease
};

struct FeatureEdges {
  // Edges with one face, and edges at which faces meet at more than 40 degrees.
  std::vector<FeatureEdge> lines;
  // Other edges with three or more faces, which may all lie on one side; `rim` is false.
  std::vector<FeatureEdge> seams;
};

// Returns the feature edges of a mesh, each once, in the order of the slots of their faces. `normals`: unit
// normals of the live faces by slot. O(faces).
FeatureEdges feature_edges(const Mesh& mesh, const std::vector<Vec3>& normals);

// A sequence of vertices along feature edges; closed if the first and the last are the same.
using FeatureLine = std::vector<VertexId>;

// Joins edges that meet in vertices of exactly two of them. O(n + highest vertex).
std::vector<FeatureLine> joined(const std::vector<FeatureEdge>& edges);

// Returns for each point of a polyline the squared error (m^2) from which on a simplified line omits it:
// infinite for the ends, 0 for points omitted at `least_error` (m) already. The points with larger values
// than the square of an error form its simplified line: starting with the ends, of each part between kept
// points it keeps the point farthest from the segment between them while that is farther than the error (D.
// Douglas, T. Peucker: Algorithms for the reduction of the number of points required to represent a
// digitized line, 1973). A closed line, whose first and last points are equal, always keeps the point
// farthest from them. O(n^2) at worst, usually O(n log n).
std::vector<double> left_out_from(const std::vector<Vec3>& line, double least_error);

// Returns the simplified line for an error (m).
std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error);

// Appends indices of points that lie as far apart as possible to a selection: each is the point farthest
// from all selected before (T. Gonzalez, 1985), the first of equal ones, until the selection has `most`
// members or no point lies apart from it. O(points * most).
void select_spread_points(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& selected);

// Appends the indices of the points that are extreme along the axes and the space diagonals, each once.
void select_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& selected);

}  // namespace kerf
