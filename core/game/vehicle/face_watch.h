#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/files/soup.h"
#include "core/mesh/mesh.h"
#include "core/world/world.h"

namespace kerf {

// Returns true if a group of a mesh belongs to a part: its name begins with that of the part.
inline bool is_of_part(std::string_view group, std::string_view part) { return group.starts_with(part); }

// For each triangle, the index of the part to which one of its groups belongs, or parts.size(). If a group
// belongs to several parts, the one with the longest name counts. O(groups * parts + triangles).
std::vector<uint32_t> part_of_triangles(const Soup& soup, const std::vector<std::string>& parts);

// The triangles of a soup with `part` equal to `wanted`, with their groups. The result may be empty.
Soup extract_part(const Soup& soup, const std::vector<uint32_t>& part, uint32_t wanted);

struct Ball {
  Vec3 centre{0};     // m
  double radius = 0;  // m
};

// The area of a triangle inside a ball [m^2], accurate to about a tenth of the radius, by bisection of the
// longest edge.
double area_within(const Triangle& t, const Ball& ball);

// Measures how much of some groups of its loaded faces a body still has.
class FaceWatch {
 public:
  static constexpr size_t kMaxGroups = 32;

  FaceWatch() = default;
  explicit FaceWatch(const Body& loaded) : groups_of_(loaded.mesh.face_slots(), 0) {}

  // Adds the faces of a part (see is_of_part) as a group and returns its index. Groups may overlap.
  // Precondition: `loaded` is the body of the constructor, and there are fewer than kMaxGroups.
  size_t add_part(const Body& loaded, const std::string& part);
  // Adds the faces of a part near a point as a group: at most 0.1 m, or a quarter, farther away than the
  // nearest face.
  size_t add_part_near(const Body& loaded, const std::string& part, const Vec3& point);

  // The loaded area of a group [m^2].
  double area(size_t group) const { return areas_[group]; }
  size_t size() const { return areas_.size(); }

  // The area of the live faces of each group in a body loaded from the same mesh [m^2]. O(faces).
  std::vector<double> areas_in(const Body& body) const;

 private:
  size_t add(const Body& loaded, const std::vector<bool>& faces, const std::optional<Ball>& near);
  double area_in(size_t group, const Triangle& t) const;

  std::vector<uint32_t> groups_of_;  // by loaded face: bit i is set if it belongs to group i
  std::vector<double> areas_;
  std::vector<std::optional<Ball>> near_;  // by group; only the area in the ball counts
};

}  // namespace kerf
