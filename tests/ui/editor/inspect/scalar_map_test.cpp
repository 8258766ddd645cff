#include "ui/editor/inspect/scalar_map.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

World sheet_world() {
  World world;
  world.add(make_body("sheet", test::build(test::grid(10, 2))));
  return world;
}

Delta replaced() {
  Delta delta;
  delta.replaced = true;
  return delta;
}

// Of the faces of the first body.
Delta changed(const World& world) {
  Delta delta;
  delta.bodies.emplace_back().body = world.ids().front();
  return delta;
}

TEST(ScalarMap, is_empty_while_nothing_is_shown) {
  ScalarMap map;
  const World world = sheet_world();
  map.follow(world, replaced());
  map.update(world, {});
  EXPECT_FALSE(map.is_old());
  EXPECT_EQ(map.histogram().faces, 0u);
  EXPECT_EQ(map.field(FileUnit::kMetre), nullptr);
}

TEST(ScalarMap, the_range_fits_the_values_until_it_is_set) {
  ScalarMap map;
  const World world = sheet_world();
  map.show(FaceQuantity::kLongestEdge);
  EXPECT_TRUE(map.is_old());
  map.update(world, {});
  EXPECT_FALSE(map.is_old());
  EXPECT_EQ(map.range().low, map.histogram().least);
  EXPECT_TRUE(map.fits());
  map.set_range({0.1, 0.2});
  EXPECT_FALSE(map.fits());
  map.forget();
  map.update(world, {});
  EXPECT_EQ(map.range(), (ScalarRange{0.1, 0.2}));
  map.fit(0);
  EXPECT_EQ(map.range().low, map.histogram().least);
}

TEST(ScalarMap, a_cut_adds_finer_faces_and_undo_removes_them) {
  Document document(sheet_world());
  ScalarMap map;
  map.show(FaceQuantity::kLevel);
  map.follow_steps(document.world(), false);
  map.update(document.world(), {});
  map.follow_steps(document.world(), false);
  const auto before = map.field(FileUnit::kMetre)->of_bodies.begin()->second;
  EXPECT_EQ(map.histogram().most, 0);
  CutSettings settings;
  settings.laser.radius = 0.03;
  settings.resolution.target_edge = 0.05;
  document.apply(BeginStroke{settings, {{0.1, 3, -0.5}, {0, -1, 0}}});
  document.apply(EndStroke{});
  while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
  EXPECT_FALSE(map.is_old());
  map.follow_steps(document.world(), false);
  EXPECT_TRUE(map.is_old());
  map.update(document.world(), {});
  EXPECT_GT(map.histogram().most, 0);
  EXPECT_EQ(map.histogram().faces, document.world().live_faces());
  EXPECT_EQ(map.range().high, map.histogram().most);
  ASSERT_TRUE(document.travel(0).ok());
  map.forget();
  map.update(document.world(), {});
  EXPECT_EQ(map.histogram().most, 0);
  EXPECT_EQ(map.histogram().faces,
            static_cast<size_t>(
                std::count_if(before->begin(), before->end(), [](float v) { return v != kNoScalar; })));
}

TEST(ScalarMap, unchanged_values_keep_the_same_list) {
  ScalarMap map;
  const World world = sheet_world();
  map.show(FaceQuantity::kMinAngle);
  map.update(world, {});
  const auto before = map.field(FileUnit::kMetre);
  map.follow(world, changed(world));
  map.update(world, {});
  EXPECT_EQ(map.field(FileUnit::kMetre)->of_bodies, before->of_bodies);
}

TEST(ScalarMap, the_scale_has_labels_from_end_to_end) {
  ScalarMap map;
  const World world = sheet_world();
  map.show(FaceQuantity::kMinAngle);
  map.update(world, {});
  map.set_range({20, 60});
  const auto field = map.field(FileUnit::kMetre);
  EXPECT_EQ(field->name, "Min. angle");
  EXPECT_EQ(field->labels.front(), "20.0\u00b0");
  EXPECT_EQ(field->labels[2], "40.0\u00b0");
  EXPECT_EQ(field->labels.back(), "60.0\u00b0");
}

}  // namespace
}  // namespace kerf
