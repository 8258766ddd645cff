#include "tests/solids_oracle/cgal_difference.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

namespace kerf::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

SurfaceMesh surface_of(const Soup& soup) {
  SurfaceMesh mesh;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (const Vec3& p : soup.positions) vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& t : soup.triangles) mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return mesh;
}

}  // namespace

std::vector<double> volumes_of_difference(const Soup& part, const Soup& tool) {
  SurfaceMesh a = surface_of(part), b = surface_of(tool), difference;
  if (!pmp::corefine_and_compute_difference(a, b, difference)) return {};
  std::vector<SurfaceMesh> parts;
  pmp::split_connected_components(difference, parts);
  std::vector<double> volumes;
  for (const SurfaceMesh& p : parts) volumes.push_back(CGAL::to_double(pmp::volume(p)));
  return volumes;
}

}  // namespace kerf::test
