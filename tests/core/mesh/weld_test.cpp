#include "core/mesh/weld.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/random.h"

namespace kerf {
namespace {

using Indices = std::vector<uint32_t>;

TEST(Weld, maps_to_the_first_of_equal_positions) {
  Random random(5);
  std::vector<Vec3> positions;
  for (int i = 0; i < 500; ++i)
    positions.emplace_back(random.below(4), random.below(4), 1e-300 * static_cast<double>(random.below(4)));
  const Indices found = weld_positions(positions);
  for (uint32_t i = 0; i < positions.size(); ++i) {
    uint32_t first = 0;
    while (positions[first] != positions[i]) ++first;
    ASSERT_EQ(found[i], first);
  }
}

TEST(Weld, treats_signed_zeros_as_equal_and_nans_as_distinct) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(weld_positions(std::vector{Vec3(0.0, 1, 2), Vec3(-0.0, 1, 2), Vec3(nan, 0, 0), Vec3(nan, 0, 0)}),
            (Indices{0, 0, 2, 3}));
}

TEST(Weld, does_not_join_nearby_positions) {
  EXPECT_EQ(weld_positions(std::vector{Vec3(1, 0, 0), Vec3(1 + 1e-15, 0, 0)}), (Indices{0, 1}));
  EXPECT_TRUE(weld_positions(std::vector<Vec3>()).empty());
}

}  // namespace
}  // namespace kerf
