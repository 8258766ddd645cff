#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Collects the polygons of a file in its order until all positions are known, because faces may precede their
// vertices.
class PolygonList {
 public:
  void reserve(size_t polygons);

  // Adds a corner to the current polygon. A number that turns out to be no index of a position makes the
  // polygon invalid.
  void add_corner(int64_t vertex);
  // Ends the current polygon and starts the next one.
  void close(uint16_t material = 0);

  // Adds polygons of three corners each, of the material 0.
  void add_triangles(std::vector<Soup::Triangle> triangles);

  // Ends the parts of a level, and starts one for each name: the polygons from here on belong to them. Levels
  // are independent of each other.
  enum class Level : uint8_t { kObject, kGroup };
  void begin_parts(Level level, const std::vector<std::string>& names);

  size_t size() const { return triangles_.size() + ends_.size(); }

  // Triangulates all valid polygons; drops and counts the invalid ones. Fails if no triangle remains. Leaves
  // the list empty.
  Result<Soup> to_soup(std::vector<Vec3> positions, const std::string& file_name);

 private:
  static constexpr uint32_t kNoVertex = 0xffffffffu;

  // The parts as parts of triangles, given the number of triangles before each polygon.
  std::vector<MeshPart> parts_of_triangles(const std::vector<uint32_t>& before) const;

  void put_triangles_in_list();
  void triangulate(std::span<const Vec3> positions, Soup& soup) const;

  std::vector<Soup::Triangle> triangles_;  // of add_triangles(), while there is no other polygon
  std::vector<uint32_t> corners_;
  std::vector<uint32_t> ends_;               // the end of each polygon in corners_
  std::vector<uint16_t> materials_;          // one per polygon, or empty while all are 0
  std::vector<MeshPart> parts_;              // of polygons; those that have not ended end at kNoVertex
  std::array<std::vector<size_t>, 2> open_;  // by level: parts that have not ended
};

// The error for a file without a usable triangle; says why its faces were dropped. Precondition: soup has no
// triangle.
Error no_face_left(const Soup& soup, const std::string& file_name);

}  // namespace kerf
