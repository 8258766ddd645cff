#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mesh/files/surfaces.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// A named part of a file, such as the objects and groups of OBJ: a range of triangles, or of faces.
struct MeshPart {
  std::string name;
  uint32_t first = 0, last = 0;  // exclusive of the last one
};

// The content of a mesh file before welding and validation: its polygons cut into triangles, and positions as
// read. All indices are in range. The corners of a triangle may be equal, and positions may be non-finite;
// build_mesh drops and counts such faces.
struct Soup {
  using Triangle = std::array<uint32_t, 3>;  // indices into positions, counter-clockwise seen from outside

  std::vector<Vec3> positions;        // metres, in the frame of the file
  std::vector<VertexColour> colours;  // one per position, or empty if the file has none
  std::vector<Triangle> triangles;
  std::vector<uint16_t> materials;          // one per triangle: index into material_names; empty if all are 0
  std::vector<std::string> material_names;  // as in the file ("usemtl")
  std::vector<MeshPart> parts;  // of triangles, none empty; ranges may overlap and names may repeat
  CornerLooks looks;            // UVs, normals and attributes of the triangles
  std::shared_ptr<const SurfaceLibrary> surfaces;  // null if the file describes no material
  bool keeps_corners = false;  // build_mesh keeps the corners of the triangles even if there are no looks

  std::string format;                   // "obj", "off", "stl", "ply", "glb", "gltf"
  size_t faces_in_file = 0;             // polygons
  size_t triangles_in_file = 0;         // n - 2 for a polygon of n corners, including invalid ones
  size_t invalid_faces_dropped = 0;     // triangles of polygons that refer to a missing vertex
  size_t incomplete_faces_dropped = 0;  // polygons of fewer than three corners, which have no triangle
  std::vector<std::string> warnings;    // one sentence each, for the user
};

// Collects the polygons of a file until all positions are known, because faces may precede vertices.
class PolygonList {
 public:
  void reserve(size_t polygons);

  // Adds a corner to the current polygon. A number that is no index of a position makes the polygon invalid.
  void add_corner(int64_t vertex);
  void close(uint16_t material = 0);

  // Adds polygons of three corners each, with material 0.
  void add_triangles(std::vector<Soup::Triangle> triangles);

  // Ends the parts of a level, and starts one for each name with the next polygon. Levels are independent.
  enum class Level : uint8_t { kObject, kGroup };
  void begin_parts(Level level, const std::vector<std::string>& names);

  size_t size() const { return triangles_.size() + ends_.size(); }

  // Triangulates valid polygons; drops and counts invalid and incomplete ones. Fails if none remains. Empties
  // the list. Stores in `corners`, unless it is null, which corner each corner of a triangle is, by the order
  // of add_corner(). Precondition: there are no triangles of add_triangles() if `corners` is not null.
  Result<Soup> to_soup(std::vector<Vec3> positions, const std::string& file_name,
                       std::vector<Soup::Triangle>* corners = nullptr);

 private:
  static constexpr uint32_t kNoVertex = 0xffffffffu;

  // Converts the parts to ranges of triangles, given the number of triangles before each polygon.
  std::vector<MeshPart> parts_of_triangles(const std::vector<uint32_t>& before) const;

  void put_triangles_in_list();
  void triangulate(std::span<const Vec3> positions, Soup& soup, std::vector<Soup::Triangle>* corners) const;

  std::vector<Soup::Triangle> triangles_;  // of add_triangles(), as long as there is no other polygon
  std::vector<uint32_t> corners_;
  std::vector<uint32_t> ends_;               // the end of each polygon in corners_
  std::vector<uint16_t> materials_;          // one per polygon, or empty as long as all are 0
  std::vector<MeshPart> parts_;              // of polygons; the end of open ones is kNoVertex
  std::array<std::vector<size_t>, 2> open_;  // by level: open parts
};

// Returns the error for a file without a usable triangle, with the reason why its faces were dropped.
// Precondition: soup has no triangle.
Error no_face_left(const Soup& soup, const std::string& file_name);

}  // namespace kerf
