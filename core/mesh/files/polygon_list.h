#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/soup.h"

namespace kerf {

// The polygons of a file in its order, collected until all positions are known: faces may come before their
// vertices.
class PolygonList {
 public:
  void reserve(size_t polygons);

  // The next corner of the polygon that is being read. Any number that is no index of a position makes the
  // polygon invalid.
  void add_corner(int64_t vertex);
  // Ends the polygon.
  void close(uint16_t material = 0);

  size_t size() const { return ends_.size(); }

  // Cuts every polygon into triangles, counts and drops the invalid ones. Fails when no face is left.
  Result<Soup> to_soup(std::vector<Vec3> positions, const std::string& file_name) const;

 private:
  static constexpr uint32_t kNoVertex = 0xffffffffu;

  std::vector<uint32_t> corners_;
  std::vector<uint32_t> ends_;       // where the corners of each polygon end
  std::vector<uint16_t> materials_;  // one a polygon, or empty while all are 0
};

// The error of a file of which no triangle can be used; says what became of those that it lists.
Error no_face_left(const Soup& soup, const std::string& file_name);

}  // namespace kerf
