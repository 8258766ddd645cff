#include "core/physics/contact/collider.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace kerf {
namespace {

Box random_box(Random& random, double size) {
  Box box;
  const Vec3 at(random.uniform(-1, 3), random.uniform(0, 1), random.uniform(-0.2, 0.2));
  box.add(at);
  box.add(at + Vec3(random.uniform(0, size), random.uniform(0, size), random.uniform(0, size)));
  return box;
}

TEST(Occupancy, overlaps_every_box_that_overlaps_an_added_one) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Box> added;
    Box bounds;
    for (int i = 0; i < 10; ++i) bounds.add(added.emplace_back(random_box(random, 0.3)));
    Occupancy space(bounds);
    for (const Box& box : added) space.add(box);
    size_t nowhere = 0;
    for (int i = 0; i < 1000; ++i) {
      const Box box = random_box(random, 0.2);
      const bool meets =
          std::any_of(added.begin(), added.end(), [&](const Box& b) { return b.overlaps(box); });
      if (meets) EXPECT_TRUE(space.meets(box));
      nowhere += !space.meets(box);
    }
    EXPECT_GT(nowhere, 300u);
  }
}

TEST(Occupancy, is_empty_without_boxes) {
  EXPECT_FALSE(Occupancy().meets({Vec3(-1), Vec3(1)}));
  EXPECT_FALSE(Occupancy({Vec3(0), Vec3(1)}).meets({Vec3(-1), Vec3(1)}));
}

TEST(Occupancy, is_apart_at_the_opposite_corner_of_bounds_anywhere) {
  for (const Vec3& middle : {Vec3(0), Vec3(5, -3, 2), Vec3(-7, -7, -7)}) {
    Occupancy space({middle - 1.0, middle + 1.0});
    space.add({middle - 1.0, middle - 0.9});
    EXPECT_TRUE(space.meets({middle - 1.0, middle - 0.95}));
    EXPECT_FALSE(space.meets({middle + 0.9, middle + 1.0}));
  }
}

}  // namespace
}  // namespace kerf
