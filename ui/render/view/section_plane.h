#pragma once

#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

struct ViewOptions;

// A plane through a point [m] of the world. The side to which the normal points is not drawn; the plane
// affects neither cuts nor shadows.
struct SectionPlane {
  Vec3 point{0};
  Vec3 normal{0, 0, 1};  // unit

  // Returns the plane facing along a vector of any non-zero length.
  static SectionPlane facing(const Vec3& point, const Vec3& way);

  // The height of a point over the plane [m], positive on the side not drawn.
  double height_of(const Vec3& p) const { return glm::dot(normal, p - point); }
  // The lengths along a ray, from 0 on, at which it is on the drawn side.
  Interval kept_along(const Pose& ray) const;
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

// Returns the plane through the middle of a box that removes the half towards the eye; its normal is the
// axis of the world closest to the direction to the eye.
SectionPlane section_through(const World::Bounds& bounds, const Vec3& to_eye);

// The section plane that the options enable, or null.
const SectionPlane* shown_section(const ViewOptions& options);

// Formats a plane as "x,y,z x,y,z", the point and the normal. Reading the numbers gives the same doubles.
std::string section_text(const SectionPlane& plane);
// Reads such a text; the normal may have any non-zero length. The text may be quoted and preceded by
// "--section", as on the command line. The error does not name the source of the text.
Result<SectionPlane> parse_section(std::string_view text);

}  // namespace kerf
