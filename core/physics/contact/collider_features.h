#pragma once

#include <vector>

#include "core/base/geometry.h"
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

// For each point of a polygonal line, the squared error (m^2) from which on a simplified line goes without
// it: infinite for the ends, 0 for points that are left out at `least_error` (m) already. The line of all
// points with larger values than the square of an error is the one that keeps, beside the ends, of each part
// between kept points the one farthest from the segment between them, as long as it is farther than the error
// (D. Douglas, T. Peucker: Algorithms for the reduction of the number of points required to represent a
// digitized line, 1973). A closed line, whose first and last points are equal, always keeps the point
// farthest from them. O(n^2) at worst, O(n log n) as a rule.
std::vector<double> left_out_from(const std::vector<Vec3>& line, double least_error);

// The simplified line for an error (m).
std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error);

// Adds indices of points that lie as far apart as possible to `chosen`: each is the point farthest from all
// that were chosen before (T. Gonzalez, 1985), of equal ones the first, until `chosen` has `most` members or
// no point lies apart from those chosen. O(points * most).
void choose_spread(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& chosen);

// Adds the indices of the points that are extreme along the axes and the diagonals of space, each once.
void choose_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& chosen);

}  // namespace kerf
