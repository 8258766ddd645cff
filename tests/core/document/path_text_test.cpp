#include "core/document/stroke_path.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/document/save.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

StrokePath random_path(Random& random) {
  StrokePath stroke;
  if (random.below(2) == 0) stroke.radius = random.uniform(1e-4, 1);
  if (random.below(2) == 0) stroke.range = Interval{random.uniform(0, 1), random.uniform(1, 9)};
  if (random.below(2) == 0) stroke.power = random.uniform(1, 9000);
  double time = random.uniform(-1, 1);
  for (uint64_t k = 0; k < 1 + random.below(9); ++k, time += random.uniform(1e-9, 1)) {
    const Vec3 origin(random.uniform(-1e6, 1e6), random.uniform(-1, 1), random.uniform(-1e-6, 1e-6));
    stroke.keys.push_back({origin, beam_direction(random_direction(random))});
    stroke.times.push_back(time);
  }
  return stroke;
}

void expect_same(const StrokePath& a, const StrokePath& b) {
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.power, b.power);
  ASSERT_EQ(a.range.has_value(), b.range.has_value());
  if (a.range) EXPECT_EQ(std::pair(a.range->low, a.range->high), std::pair(b.range->low, b.range->high));
  EXPECT_EQ(a.times, b.times);
  ASSERT_EQ(a.keys.size(), b.keys.size());
  for (size_t k = 0; k < a.keys.size(); ++k) {
    EXPECT_EQ(a.keys[k].origin, b.keys[k].origin);
    EXPECT_EQ(a.keys[k].direction, b.keys[k].direction);
  }
}

TEST(PathText, round_trips_exactly) {
  const TemporaryFolder folder;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::vector<StrokePath> strokes{random_path(random), random_path(random)};
    write_text(folder / "path.json", path_file_text(strokes));
    const auto read = read_path_file(folder / "path.json");
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->size(), 2u);
    for (size_t i = 0; i < 2; ++i) expect_same((*read)[i], strokes[i]);
  }
}

TEST(PathText, path_file_is_distinguished_from_a_scene_by_bodies) {
  const TemporaryFolder folder;
  Random random(1);
  ASSERT_TRUE(save_path(folder / "path.json", std::vector{random_path(random)}).ok());
  write_text(folder / "scene.json", R"({"bodies": [], "strokes": []})");
  write_text(folder / "broken.json", R"({"strokes": )");
  EXPECT_TRUE(is_path_file(folder / "path.json"));
  for (const char* other : {"scene.json", "broken.json", "missing.json"})
    EXPECT_FALSE(is_path_file(folder / other)) << other;
}

}  // namespace
}  // namespace kerf::test
