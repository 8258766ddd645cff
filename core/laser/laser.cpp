#include "core/laser/laser.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"

namespace kerf {

namespace {

Pose halfway(const Pose& a, const Pose& b) {
  const Vec3 direction = a.direction == b.direction ? a.direction : glm::normalize(a.direction + b.direction);
  return {0.5 * a.origin + 0.5 * b.origin, direction};
}

void bisect(const BeamMove& move, size_t parts, std::vector<BeamMove>& out) {
  if (parts == 1) {
    out.push_back(move);
    return;
  }
  const Pose middle = halfway(move.from, move.to);
  bisect({move.from, middle, 0.5 * move.seconds}, parts / 2, out);
  bisect({middle, move.to, 0.5 * move.seconds}, parts / 2, out);
}

// The seconds for which a pulsed beam has been on after `t` seconds.
double seconds_on(const Laser& laser, double t) {
  const double period = 1 / laser.pulse_rate, whole = std::floor(t / period);
  return laser.duty * period * whole + std::min(t - whole * period, laser.duty * period);
}

}  // namespace

double emitted_energy(const Laser& laser, double from, double to) {
  KERF_ASSERT(0 <= from && from <= to && laser.power > 0 && laser.duty > 0 && laser.duty <= 1);
  if (laser.pulse_rate <= 0 || laser.duty >= 1) return laser.power * (to - from);
  return laser.power * (seconds_on(laser, to) - seconds_on(laser, from));
}

// Starts from the axis of the world that is least parallel to d.
Vec3 across(const Vec3& d) {
  const Vec3 size = glm::abs(d);
  const Vec3 e = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                 : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                      : Vec3(0, 0, 1);
  return glm::normalize(glm::cross(d, e));
}

std::vector<SweptCylinder> sweep_beam(const Laser& laser, const BeamMove& move) {
  if (laser.pattern == Pattern::kVolume)
    return {SweptCylinder(move.from, move.to, laser.radius, laser.range)};
  std::vector<SweptCylinder> rays;
  const auto shifted = [&](const Pose& pose, int ray) {
    const Vec3 u = across(pose.direction), w = glm::cross(pose.direction, u);
    const Vec3 offset = (ray % 2 == 0 ? u : w) * (ray < 2 ? laser.radius : -laser.radius);
    return Pose{pose.origin + offset, pose.direction};
  };
  for (int ray = 0; ray < 4; ++ray) {
    rays.emplace_back(shifted(move.from, ray), shifted(move.to, ray), 0.0, laser.range);
  }
  return rays;
}

size_t subdivisions(const BeamMove& move, double radius, double reach) {
  constexpr double kArcOverChord = kPi / 2;  // at most, for arcs up to half a turn
  constexpr double kLargestTurn = 0.05;      // rad in one move
  constexpr size_t kMost = size_t{1} << 17;
  KERF_ASSERT(radius > 0 && reach >= 0);
  const Vec3 turn = move.to.direction - move.from.direction;
  const double arc = kArcOverChord * glm::length(turn);
  const double way = glm::length(move.to.origin - move.from.origin) + arc * reach;
  size_t moves = 1;
  for (double m = std::max(way / radius, arc / kLargestTurn); m > 1 && moves < kMost; m *= 0.5) moves *= 2;
  return moves;
}

std::vector<BeamMove> subdivide(const BeamMove& move, double radius, double reach) {
  KERF_ASSERT(move.seconds >= 0);
  const size_t moves = subdivisions(move, radius, reach);
  std::vector<BeamMove> out;
  out.reserve(moves);
  bisect(move, moves, out);
  return out;
}

}  // namespace kerf
