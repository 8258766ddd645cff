#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/world/world.h"

namespace kerf {

// Tells how much is left in a body of some groups of the faces that were loaded with it.
class FaceWatch {
 public:
  static constexpr size_t kMostGroups = 32;

  FaceWatch() = default;
  explicit FaceWatch(const Body& loaded) : groups_of_(loaded.mesh.face_slots(), 0) {}

  // Adds a group of loaded faces and returns its index. Groups may overlap. Precondition: `loaded` is the
  // body of the constructor, and there are fewer than kMostGroups.
  size_t add(const Body& loaded, const std::function<bool(FaceId)>& belongs);
  // The same for all faces of a part (see is_of_part).
  size_t add_part(const Body& loaded, const std::string& part);
  // The same for the faces of a part that are near a point: those at most 0.1 m, or a quarter, farther away
  // than the nearest one.
  size_t add_part_near(const Body& loaded, const std::string& part, const Vec3& point);

  // The area of a group as loaded, m^2.
  double area(size_t group) const { return areas_[group]; }
  size_t size() const { return areas_.size(); }

  // By group, the area of its live faces in a body that was loaded from the same mesh, m^2. O(faces).
  std::vector<double> areas_in(const Body& body) const;

 private:
  std::vector<uint32_t> groups_of_;  // by loaded face: bit i is set if it belongs to group i
  std::vector<double> areas_;
};

}  // namespace kerf
