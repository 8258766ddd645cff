#include "core/laser/rotary_axes.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

namespace kerf {

namespace {

// Maximum rotation between two keys of a beam [rad].
constexpr double kMaxTurnOfPart = 0.035;

double angle_of(const RotaryAxis& axis, const MachinePosition& at) { return at.angles[axis.letter - 'A']; }

// Whole turns are removed first, so that they restore positions to the bit.
glm::dquat rotation(const RotaryAxis& axis, double degrees) {
  KERF_ASSERT(is_unit(axis.axis));
  return axis_angle(axis.axis, radians_of(std::fmod(degrees, 360)));
}

Pose turned(const Pose& pose, const RotaryAxis& axis, const Vec3& pivot, double degrees) {
  if (degrees == 0) return pose;
  const glm::dquat by = rotation(axis, degrees);
  return {pivot + by * (pose.origin - pivot), by * pose.direction};
}

}  // namespace

bool RotaryAxes::has(char letter) const {
  return std::ranges::any_of(axes, [&](const RotaryAxis& axis) { return axis.letter == letter; });
}

Pose RotaryAxes::beam(const MachinePosition& at) const {
  Pose pose{at.point + Vec3(0, 0, height), {0, 0, -1}};
  for (size_t i = axes.size(); i-- > 0;) {
    if (axes[i].turns == RotaryAxis::Turns::kHead)
      pose = turned(pose, axes[i], at.point + axes[i].pivot, angle_of(axes[i], at));
  }
  for (const RotaryAxis& axis : axes) {
    if (axis.turns == RotaryAxis::Turns::kTable) pose = turned(pose, axis, axis.pivot, -angle_of(axis, at));
  }
  return {pose.origin, glm::normalize(pose.direction)};
}

double RotaryAxes::parts(const MachinePosition& from, const MachinePosition& to, double tolerance) const {
  KERF_ASSERT(tolerance > 0);
  double turn = 0;
  for (const RotaryAxis& axis : axes) turn += std::abs(radians_of(angle_of(axis, to) - angle_of(axis, from)));
  if (turn == 0) return 1;
  // The start of the beam is at most this far from a pivot. An arc deviates from its chord by an eighth of
  // the radius times the squared angle, and a spiral by a quarter of its growth times the angle.
  double reach = 0;
  for (const RotaryAxis& axis : axes) {
    const bool is_head = axis.turns == RotaryAxis::Turns::kHead;
    const auto radius = [&](const MachinePosition& at) {
      const Vec3 arm = (is_head ? Vec3(0) : at.point) + Vec3(0, 0, height) - axis.pivot;
      return axes.size() == 1 ? glm::length(glm::cross(arm, axis.axis)) : glm::length(arm);
    };
    reach = std::max({reach, radius(from), radius(to)});
  }
  const Vec3 way = to.point - from.point;
  const double growth = axes.size() == 1 ? glm::length(glm::cross(way, axes.front().axis)) : glm::length(way);
  const double deviation = reach * turn * turn / 8 + growth * turn / 4;
  return std::max({1.0, std::ceil(std::sqrt(deviation / tolerance)), std::ceil(turn / kMaxTurnOfPart)});
}

}  // namespace kerf
