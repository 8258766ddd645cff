#include "ui/render/bodies/face_buffer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace kerf {
namespace {

Vec3 random_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(HeatFit, reproduces_a_linear_field_on_faces_of_any_size) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Vec3 vertex = random_point(random);
    const std::array<Vec3, 2> slopes{300.0 * random_point(random), 200.0 * random_point(random)};
    const auto linear = [&](size_t i, const Vec3& p) { return 900 + glm::dot(slopes[i], p - vertex); };
    std::vector<FaceSample> samples;
    for (size_t i = 0; i < 8 + random.below(6); ++i) {
      const double size = std::exp(random.uniform(-1, 1));
      const Vec3 centroid = vertex + 0.4 * size * random_point(random);
      samples.push_back({centroid, size, {linear(0, centroid), linear(1, centroid)}});
    }
    const auto fits = fit_heat(vertex, samples);
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(fits[i].at, 900, 3);
      EXPECT_LT(glm::length(fits[i].gradient - slopes[i]), 0.05 * glm::length(slopes[i]));
    }
  }
}

TEST(HeatFit, has_no_normal_gradient_for_coplanar_faces) {
  Random random(3);
  std::vector<FaceSample> samples;
  for (int i = 0; i < 7; ++i) {
    Vec3 p = random_point(random);
    p.y = 0.2;
    samples.push_back({p, 1, {random.uniform(300, 1500), 293}});
  }
  const auto [now, hottest] = fit_heat({0, 0.2, 0}, samples);
  EXPECT_NEAR(now.gradient.y, 0, 1e-6);
  EXPECT_GT(glm::length(now.gradient), 1);
  EXPECT_EQ(hottest.gradient, Vec3(0));
  EXPECT_NEAR(hottest.at, 293, 1e-9);
}

TEST(HeatFit, is_the_temperature_of_a_single_face) {
  const std::vector<FaceSample> samples{{{1, 2, 3}, 0.5, {1000, 1200}}};
  const auto [now, hottest] = fit_heat({1, 2, 3.2}, samples);
  EXPECT_EQ(now.at, 1000);
  EXPECT_EQ(hottest.at, 1200);
  EXPECT_EQ(now.gradient, Vec3(0));
}

}  // namespace
}  // namespace kerf
