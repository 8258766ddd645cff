#pragma once

#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

struct ViewOptions;

// A plane through a point (m) of the world. What lies on the side to which the normal points is not drawn;
// the world stays whole: the beam cuts it and the light is kept away by it as without the plane.
struct SectionPlane {
  Vec3 point{0};
  Vec3 normal{0, 0, 1};  // unit

  // The plane that faces along a vector of any length but 0.
  static SectionPlane facing(const Vec3& point, const Vec3& way);

  // The height of a point over the plane (m), positive where nothing is drawn.
  double height_of(const Vec3& p) const { return glm::dot(normal, p - point); }
  // The lengths along a ray at which it is on the side that is drawn, from 0 on.
  Interval kept_along(const Pose& ray) const;
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

// The plane through the middle of a box that takes away the half towards the eye; its normal is the axis of
// the world that is nearest to the direction to the eye.
SectionPlane section_through(const World::Bounds& bounds, const Vec3& to_eye);

// The plane with which the options cut the picture, or null.
const SectionPlane* shown_section(const ViewOptions& options);

// A plane as text: "x,y,z x,y,z", the point and the normal. The numbers are read back as the same doubles.
std::string section_text(const SectionPlane& plane);
// Reads such a text; the normal may have any length but 0. The text may stand in quotation marks and after
// "--section", as on the command line. The error does not say where the text comes from.
Result<SectionPlane> parse_section(std::string_view text);

}  // namespace kerf
