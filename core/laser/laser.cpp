#include "core/laser/laser.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

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

// Returns the time (s) that a pulsed beam has been on after `t` seconds.
double seconds_on(const Laser& laser, double t) {
  KERF_ASSERT(laser.pulse_rate > 0);
  const double period = 1 / laser.pulse_rate, whole = std::floor(t / period);
  return laser.duty * period * whole + std::min(t - whole * period, laser.duty * period);
}

constexpr double kFibreWavelength = 1.07e-6;  // m

// exp(-2 kBundleSpacing^2). The squared distance of a point from the axis is an integer multiple of the
// squared spacing plus a third of it, so its profile is a power of this, but for a common factor.
constexpr double kOneSpacing = 0.83527021141127200;
static_assert(kBundleSpacing == 0.3);
constexpr double kSpacingsAFace = 0.6;  // the spacing is at most this share of a face

int halvings_for(double face) {
  KERF_ASSERT(face > 0);
  int halvings = 0;
  for (double s = kBundleSpacing; s > kSpacingsAFace * face && halvings < kMaxHalvings; s *= 0.5) ++halvings;
  return halvings;
}

double to_the_power(double x, int n) {
  double product = 1;
  for (; n > 0; --n) product *= x;
  return product;
}

std::vector<BundleRay> gaussian_bundle(int halvings) {
  constexpr double kHalfRoot3 = 0.86602540378443865;
  double spacing = kBundleSpacing, profile = kOneSpacing;
  for (int i = 0; i < halvings; ++i) {
    spacing *= 0.5;
    profile = std::sqrt(std::sqrt(profile));
  }
  const auto steps = static_cast<int>(kBundleReach / spacing / kHalfRoot3) + 2;
  const auto farthest = static_cast<int>(kBundleReach * kBundleReach / (spacing * spacing));
  std::vector<BundleRay> rays;
  double sum = 0;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const int square = i * i + i * j + j * j + i + j;  // squared distance in spacings, minus a third
      if (square > farthest) continue;
      const Vec2 at(i + 0.5 * j + 0.5, kHalfRoot3 * (j + 1.0 / 3));
      rays.push_back({spacing * at, to_the_power(profile, square)});
      sum += rays.back().share;
    }
  }
  for (BundleRay& ray : rays) ray.share /= sum;
  return rays;
}

}  // namespace

double emitted_energy(const Laser& laser, double from, double to) {
  KERF_ASSERT(0 <= from && from <= to && laser.power > 0 && laser.duty > 0 && laser.duty <= 1);
  if (laser.pulse_rate <= 0 || laser.duty >= 1) return laser.power * (to - from);
  return laser.power * std::max(0.0, seconds_on(laser, to) - seconds_on(laser, from));
}

// Starts from the world axis least parallel to d.
Vec3 across(const Vec3& d) {
  KERF_ASSERT(is_unit(d));
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
  constexpr double kMaxTurn = 0.05;          // rad in one move
  constexpr size_t kMost = size_t{1} << 17;
  KERF_ASSERT(radius > 0 && reach >= 0);
  const Vec3 turn = move.to.direction - move.from.direction;
  const double arc = kArcOverChord * glm::length(turn);
  const double way = glm::length(move.to.origin - move.from.origin) + arc * reach;
  size_t moves = 1;
  for (double m = std::max(way / radius, arc / kMaxTurn); m > 1 && moves < kMost; m *= 0.5) moves *= 2;
  return moves;
}

std::vector<BeamMove> subdivide(const BeamMove& move, double radius, double reach) {
  KERF_ASSERT(move.seconds >= 0);
  KERF_ASSERT(is_unit(move.from.direction) && is_unit(move.to.direction));
  const size_t moves = subdivisions(move, radius, reach);
  std::vector<BeamMove> out;
  out.reserve(moves);
  bisect(move, moves, out);
  return out;
}

double bundle_spacing(double face) {
  double spacing = kBundleSpacing;
  for (int i = halvings_for(face); i > 0; --i) spacing *= 0.5;
  return spacing;
}

std::vector<BundleRay> ray_bundle(Pattern pattern, double face) {
  if (pattern == Pattern::kVolume) return gaussian_bundle(halvings_for(face));
  return {{{1, 0}, 0.25}, {{0, 1}, 0.25}, {{-1, 0}, 0.25}, {{0, -1}, 0.25}};
}

std::vector<BundleRay> turned_bundle(const std::vector<BundleRay>& rays, uint64_t number) {
  const auto times = [](Vec2 a, Vec2 b) { return Vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); };
  Vec2 turn(1, 0), square(0.8, 0.6);
  for (uint64_t bit = 1; bit < 4096; bit *= 2, square = times(square, square)) {
    if ((number & bit) != 0) turn = times(turn, square);
  }
  std::vector<BundleRay> turned = rays;
  for (BundleRay& ray : turned) ray.offset = times(turn, ray.offset);
  return turned;
}

Pose ray_at(const Laser& laser, const BundleRay& ray, const Pose& pose) {
  const Vec3 u = across(pose.direction), w = glm::cross(pose.direction, u);
  const Vec3 offset = laser.radius * (ray.offset.x * u + ray.offset.y * w);
  if (!laser.focus) return {pose.origin + offset, pose.direction};
  const double wavelength = laser.wavelength > 0 ? laser.wavelength : kFibreWavelength;
  const double rayleigh = kPi * laser.radius * laser.radius / wavelength;
  const Vec3 slope = glm::cross(pose.direction, offset) / rayleigh;
  const Vec3 waist = pose.origin + offset + *laser.focus * pose.direction;
  const Vec3 way = pose.direction + slope;
  return {waist - *laser.focus * way, glm::normalize(way)};
}

}  // namespace kerf
