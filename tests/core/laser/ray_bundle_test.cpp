#include "core/laser/laser.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kFaces[] = {4, 1, 0.5, 0.25, 0.1};  // sizes of faces under the beam, in radii

double share_within(const std::vector<BundleRay>& rays, double radius) {
  double sum = 0;
  for (const BundleRay& ray : rays) sum += glm::length(ray.offset) < radius ? ray.share : 0;
  return sum;
}

TEST(RayBundle, distributes_the_whole_power) {
  for (const double face : kFaces) EXPECT_NEAR(share_within(ray_bundle(Pattern::kVolume, face), 9), 1, 1e-12);
  EXPECT_EQ(ray_bundle(Pattern::kRays4, 1).size(), 4u);
}

// The power within a radius R of a Gaussian beam is 1 - exp(-2 R^2 / w^2); its second moment is w^2 / 2.
TEST(RayBundle, approximates_a_gaussian_profile_better_with_more_rays) {
  double last = 1;
  for (const double face : {1.0, 0.25, 0.1}) {
    const std::vector<BundleRay> rays = ray_bundle(Pattern::kVolume, face);
    double worst = 0, moment = 0;
    for (double r = 0.25; r < 2; r += 0.125)
      worst = std::max(worst, std::abs(share_within(rays, r) - (1 - std::exp(-2 * r * r))));
    for (const BundleRay& ray : rays) moment += ray.share * glm::dot(ray.offset, ray.offset);
    EXPECT_LT(worst, last);
    EXPECT_LT(worst, 0.5 * bundle_spacing(face));
    EXPECT_NEAR(moment, 0.5, 0.002);
    last = worst;
  }
}

TEST(RayBundle, is_finer_than_the_faces) {
  for (const double face : kFaces) EXPECT_LT(bundle_spacing(face), std::max(face, 0.05));
}

TEST(RayBundle, is_rotated_by_the_pose_index_only) {
  const std::vector<BundleRay> rays = ray_bundle(Pattern::kVolume, 1);
  for (const uint64_t number : {0u, 1u, 2u, 77u, 4095u, 4096u}) {
    const std::vector<BundleRay> turned = turned_bundle(rays, number);
    ASSERT_EQ(turned.size(), rays.size());
    const double angle = static_cast<double>(number % 4096) * std::atan2(0.6, 0.8);
    for (size_t i = 0; i < rays.size(); ++i) {
      const Vec2 p = rays[i].offset;
      const Vec2 expected(std::cos(angle) * p.x - std::sin(angle) * p.y,
                          std::sin(angle) * p.x + std::cos(angle) * p.y);
      EXPECT_NEAR(glm::distance(turned[i].offset, expected), 0, 1e-9);
      EXPECT_EQ(turned[i].share, rays[i].share);
    }
  }
}

TEST(RayBundle, is_parallel_without_a_focus) {
  Random random(3);
  Laser laser;
  laser.radius = 0.01;
  const Pose pose{{1, 2, 3}, random_direction(random)};
  for (const BundleRay& ray : ray_bundle(Pattern::kVolume, 1)) {
    const Pose line = ray_at(laser, ray, pose);
    EXPECT_EQ(line.direction, pose.direction);
    EXPECT_NEAR(glm::distance(line.origin, pose.origin), laser.radius * glm::length(ray.offset), 1e-12);
  }
}

// radius(z)^2 = w^2 (1 + (z / z_R)^2), z_R = pi w^2 / wavelength.
TEST(RayBundle, widens_from_its_focus_as_a_gaussian_beam_does) {
  Random random(5);
  Laser laser;
  laser.radius = 1e-4;
  laser.focus = 0.2;
  laser.wavelength = 1.07e-6;
  const double rayleigh = 3.14159265358979 * laser.radius * laser.radius / laser.wavelength;
  EXPECT_NEAR(rayleigh, 2.936068e-2, 1e-7);
  const Pose pose{{0, 0, 0}, random_direction(random)};
  for (const BundleRay& ray : ray_bundle(Pattern::kVolume, 1)) {
    const Pose line = ray_at(laser, ray, pose);
    for (const double depth : {0.0, 0.15, 0.2, 0.25}) {
      const Vec3 plane = pose.origin + depth * pose.direction;
      const double along =
          glm::dot(plane - line.origin, pose.direction) / glm::dot(line.direction, pose.direction);
      const Vec3 at = line.origin + along * line.direction;
      const double z = (depth - *laser.focus) / rayleigh;
      EXPECT_NEAR(glm::distance(at, plane), laser.radius * glm::length(ray.offset) * std::sqrt(1 + z * z),
                  1e-12);
    }
  }
}

TEST(EmittedEnergy, is_the_power_times_the_pulse_on_time) {
  Laser laser;
  laser.power = 100;
  EXPECT_DOUBLE_EQ(emitted_energy(laser, 0.5, 2), 150);
  laser.pulse_rate = 10;
  laser.duty = 0.25;
  EXPECT_NEAR(emitted_energy(laser, 0, 1), 25, 1e-9);
  EXPECT_NEAR(emitted_energy(laser, 0, 0.025), 2.5, 1e-9);
  EXPECT_NEAR(emitted_energy(laser, 0.025, 0.1), 0, 1e-9);
  EXPECT_NEAR(emitted_energy(laser, 0.09, 0.11), 1, 1e-9);
}

TEST(EmittedEnergy, is_never_negative) {
  Laser laser;
  for (const double rate : {10.0, 50.0, 300.0, 2000.0}) {
    for (const double duty : {0.1, 0.3, 0.7}) {
      laser.pulse_rate = rate;
      laser.duty = duty;
      double sum = 0;
      for (int i = 0; i < 1024; ++i) {
        const double joules = emitted_energy(laser, i / 1024.0, (i + 1) / 1024.0);
        ASSERT_GE(joules, 0) << rate << " Hz, " << duty << ", part " << i;
        sum += joules;
      }
      EXPECT_NEAR(sum, duty * laser.power, 1e-9 * laser.power);
    }
  }
}

}  // namespace
}  // namespace kerf::test
