#include "core/physics/contact/collider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace kerf {
namespace {

TEST(SimplifiedLine, stays_within_its_error) {
  std::vector<Vec3> line;
  for (int i = 0; i <= 200; ++i) line.emplace_back(0.01 * i, std::sin(0.05 * i), 0);
  const std::vector<Vec3> few = simplified(line, 0.01);
  EXPECT_LT(few.size(), 40u);
  for (const Vec3& p : line) {
    double nearest = 1;
    for (size_t i = 0; i + 1 < few.size(); ++i) {
      const Vec3 way = few[i + 1] - few[i];
      const double t = std::clamp(glm::dot(p - few[i], way) / glm::dot(way, way), 0.0, 1.0);
      nearest = std::min(nearest, glm::length(p - few[i] - t * way));
    }
    EXPECT_LE(nearest, 0.01);
  }
}

TEST(SimplifiedLine, for_larger_errors_is_a_subset_of_that_for_the_smallest) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<Vec3> line(2 + random.below(60));
    for (Vec3& p : line) p = {random.unit(), random.unit(), random.unit()};
    if (seed % 2 == 0) line.back() = line.front();
    const std::vector<double> from = omission_errors(line, 0.01);
    for (const double error : {0.01, 0.05, 0.2, 0.4, 2.0}) {
      std::vector<Vec3> kept;
      for (size_t i = 0; i < line.size(); ++i) {
        if (from[i] > error * error) kept.push_back(line[i]);
      }
      EXPECT_EQ(kept, simplified(line, error)) << "seed " << seed << ", error " << error;
    }
  }
}

}  // namespace
}  // namespace kerf
