#include "core/laser/ray_bundle.h"

#include <cmath>

#include "core/base/angle.h"

namespace kerf {

namespace {

constexpr double kFibreWavelength = 1.07e-6;  // m

// exp(-2 kBundleSpacing^2). The square of the distance of a point from the axis is a whole multiple of that
// of the spacing and a third of it, so its profile is a power of this, but for a factor that all have.
constexpr double kOneSpacing = 0.83527021141127200;
static_assert(kBundleSpacing == 0.3);
constexpr double kSpacingsAFace = 0.6;  // the spacing is at most this share of a face

int halvings_for(double face) {
  int halvings = 0;
  for (double s = kBundleSpacing; s > kSpacingsAFace * face && halvings < kMostHalvings; s *= 0.5) ++halvings;
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
      const int square = i * i + i * j + j * j + i + j;  // of the distance, in spacings, less a third
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
