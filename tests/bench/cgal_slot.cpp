#include <CGAL/boost/graph/generators.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include "tests/bench/peer.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
namespace pmp = CGAL::Polygon_mesh_processing;

SurfaceMesh mesh_of(const TriangleArrays& arrays) {
  SurfaceMesh mesh;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (size_t i = 0; i < arrays.positions.size(); i += 3)
    vertices.push_back(
        mesh.add_vertex(Point(arrays.positions[i], arrays.positions[i + 1], arrays.positions[i + 2])));
  for (size_t i = 0; i < arrays.corners.size(); i += 3)
    mesh.add_face(vertices[arrays.corners[i]], vertices[arrays.corners[i + 1]],
                  vertices[arrays.corners[i + 2]]);
  return mesh;
}

// As thick as the slot, and larger than the mesh to all sides.
SurfaceMesh box_of(const SlotBox& slot) {
  Vec3 low = slot.low - 0.1 * (slot.high - slot.low), high = slot.high + 0.1 * (slot.high - slot.low);
  low[slot.across] = slot.middle[slot.across] - slot.radius;
  high[slot.across] = slot.middle[slot.across] + slot.radius;
  const auto corner = [&](int x, int y, int z) {
    return Point(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
  };
  SurfaceMesh box;
  CGAL::make_hexahedron(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1),
                        corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), box);
  pmp::triangulate_faces(box);
  return box;
}

}  // namespace

std::optional<double> cgal_slot_seconds(const TriangleArrays& arrays, const SlotBox& slot) {
  SurfaceMesh mesh = mesh_of(arrays), box = box_of(slot), rest;
  bool done = false;
  std::vector<SurfaceMesh> parts;
  const double seconds = seconds_of([&] {
    done = pmp::corefine_and_compute_difference(mesh, box, rest);
    if (done) pmp::split_connected_components(rest, parts);
  });
  return done ? std::optional(seconds) : std::nullopt;
}

}  // namespace kerf::bench
