#include "ui/editor/path/hole_pattern.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "core/document/files/edit_path.h"

namespace kerf {

namespace {

constexpr double kTurn = 6.283185307179586;
constexpr int kLeastKeys = 12, kMostKeys = 360;  // of a hole
constexpr double kSagitta = 1.0 / 16;  // of the beam's radius: so far a chord may be inside its circle

// Directions across the beam: that of the rows, and that of the columns.
struct Plane {
  Vec3 along, across;
  Vec3 at(double x, double y) const { return along * x + across * y; }
};

Plane plane_across(const Vec3& beam) {
  int best = 0;
  for (const int axis : {2, 1}) {
    if (std::abs(beam[axis]) < std::abs(beam[best]) - 1e-6) best = axis;
  }
  Vec3 along(0);
  along[best] = 1;
  along = glm::normalize(along - beam * glm::dot(along, beam));
  return {along, glm::cross(beam, along)};
}

int keys_of_circle(double circle, double radius) {
  const double sagitta = std::min(kSagitta * radius / circle, 1.0);
  const double keys = std::ceil(0.5 * kTurn / std::acos(1 - sagitta));
  return static_cast<int>(std::clamp<double>(keys, kLeastKeys, kMostKeys));
}

// The middles of the holes, from the middle of the pattern.
std::vector<Vec3> middles(const HolePattern& p, const Plane& plane) {
  std::vector<Vec3> all;
  if (p.kind == HolePattern::Kind::kCircle) {
    for (int i = 0; i < p.count; ++i) {
      const double angle = kTurn * i / p.count;
      all.push_back(plane.at(p.circle_radius * std::cos(angle), p.circle_radius * std::sin(angle)));
    }
    return all;
  }
  for (int row = 0; row < p.rows; ++row) {
    for (int column = 0; column < p.columns; ++column) {
      const double x = column - 0.5 * (p.columns - 1), y = row - 0.5 * (p.rows - 1);
      all.push_back(plane.at(p.spacing * x, p.spacing * y));
    }
  }
  return all;
}

StrokePath hole(const Pose& middle, const Plane& plane, double hole_radius, double radius) {
  StrokePath stroke;
  stroke.radius = std::min(radius, hole_radius);
  const double circle = hole_radius - radius;
  if (circle > 0) {
    const int keys = keys_of_circle(circle, radius);
    for (int i = 0; i <= keys; ++i) {
      const double angle = kTurn * (i % keys) / keys;
      const Vec3 aside = plane.at(circle * std::cos(angle), circle * std::sin(angle));
      stroke.keys.push_back({middle.origin + aside, middle.direction});
    }
  } else {
    stroke.keys.push_back(middle);
  }
  retime(stroke, 1);
  return stroke;
}

}  // namespace

std::vector<StrokePath> hole_strokes(const HolePattern& pattern, const Pose& beam, double radius) {
  KERF_ASSERT(pattern.hole_radius > 0 && radius > 0);
  KERF_ASSERT(is_unit(beam.direction));
  const Plane plane = plane_across(beam.direction);
  std::vector<StrokePath> strokes;
  for (const Vec3& middle : middles(pattern, plane))
    strokes.push_back(hole({beam.origin + middle, beam.direction}, plane, pattern.hole_radius, radius));
  return strokes;
}

}  // namespace kerf
