#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/pieces/area_selection.h"
#include "ui/editor/pieces/pieces_list.h"

namespace kerf {
namespace {

using test::build;
using test::moved;

std::set<PieceId> set_of(const World& world, const std::vector<size_t>& bodies) {
  std::set<PieceId> pieces;
  for (const size_t i : bodies) pieces.insert({world.ids()[i], 0});
  return pieces;
}

// Square sheets of edge 1 in a row, with gaps of 0.1 between them.
World row_of_sheets(size_t count) {
  World world;
  for (size_t i = 0; i < count; ++i)
    world.add(make_body("sheet", build(moved(test::grid(3, 1), {1.1 * static_cast<double>(i), 0, 0}, 1))));
  return world;
}

TEST(Neighbours, lie_across_a_gap_within_reach) {
  const World world = row_of_sheets(4);
  EXPECT_EQ(neighbours_of(set_of(world, {1}), world, 0.15, {}), set_of(world, {0, 2}));
  EXPECT_EQ(neighbours_of(set_of(world, {0, 1}), world, 0.15, {}), set_of(world, {2}));
  EXPECT_TRUE(neighbours_of(set_of(world, {1}), world, 0.08, {}).empty());
  EXPECT_EQ(neighbours_of(set_of(world, {1}), world, 0.15, {{{world.ids()[0], 0}, {.hidden = true}}}),
            set_of(world, {2}));
}

TEST(Neighbours, grow_and_shrink_the_selection_by_a_step) {
  const Document document(row_of_sheets(5));
  const World& world = document.world();
  PieceMap looks;
  looks[{world.ids()[2], 0}].selected = true;
  grow_selection(document, looks);  // no cut: only touching rims count
  EXPECT_EQ(selected_count(looks), 1u);
  for (const BodyId id : world.ids()) looks[{id, 0}].selected = true;
  shrink_selection(document, looks);
  EXPECT_EQ(selected_count(looks), 5u);
}

TEST(Neighbours, touch_without_a_cut) {
  World world;
  for (const double x : {0.0, 1.0, 2.0, 3.5})
    world.add(make_body("sheet", build(moved(test::plate(1), {x, 0, 0}, 1))));
  const Document document(std::move(world));
  PieceMap looks;
  const std::vector<BodyId> ids = document.world().ids();
  looks[{ids[0], 0}].selected = true;
  grow_selection(document, looks);
  EXPECT_TRUE(looks[(PieceId{ids[1], 0})].selected);
  EXPECT_EQ(selected_count(looks), 2u);
  grow_selection(document, looks);
  EXPECT_EQ(selected_count(looks), 3u);
  shrink_selection(document, looks);  // the distant sheet touches none of them
  EXPECT_EQ(selected_count(looks), 3u);
  looks[{ids[2], 0}].selected = false;
  shrink_selection(document, looks);
  EXPECT_EQ(selected_count(looks), 1u);
}

double distance_of_points(const Soup& a, const Soup& b) {
  constexpr int kPoints = 40;
  double least = INFINITY;
  const auto each = [&](const Soup& soup, const auto& use) {
    for (size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < kPoints; ++k)
        use(glm::mix(soup.positions[i], soup.positions[(i + 1) % 3], double(k) / kPoints));
    }
  };
  each(a,
       [&](const Vec3& p) { each(b, [&](const Vec3& q) { least = std::min(least, glm::length(p - q)); }); });
  return least;
}

// Against all pairs of points on the edges of random triangles. Pairs near the limit may differ.
TEST(Neighbours, equal_a_search_of_all_pairs) {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    World world;
    std::vector<Soup> soups;
    for (int i = 0; i < 24; ++i) {
      Soup soup;
      const Vec3 at(random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2));
      for (int k = 0; k < 3; ++k)
        soup.positions.push_back(
            at + Vec3(random.uniform(0, 0.5), random.uniform(0, 0.5), random.uniform(0, 0.5)));
      soup.triangles = {{0, 1, 2}};
      soups.push_back(soup);
      world.add(make_body("triangle", build(soup)));
    }
    const double reach = random.uniform(0.1, 0.3);
    const std::set<PieceId> found = neighbours_of(set_of(world, {0, 1}), world, reach, {});
    for (size_t i = 2; i < soups.size(); ++i) {
      const double distance =
          std::min(distance_of_points(soups[0], soups[i]), distance_of_points(soups[1], soups[i]));
      if (distance > 0.8 * reach && distance < 1.1 * reach) continue;
      EXPECT_EQ(found.contains({world.ids()[i], 0}), distance < reach) << "seed " << seed << ", " << i;
    }
  }
}

TEST(PieceMeasures, are_area_and_volume_of_closed_pieces) {
  World world;
  world.add(make_body("brick", build(test::brick({2, 1, 3}))));
  world.add(make_body("brick", build(moved(test::brick({1, 1, 1}), {5, 0, 0}, 1))));
  world.add(make_body("sheet", build(moved(test::plate(1), {9, 0, 0}, 1))));
  const auto measured = [&](const std::vector<size_t>& bodies) {
    const std::set<PieceId> pieces = set_of(world, bodies);
    return measure_pieces(world, {pieces.begin(), pieces.end()});
  };
  EXPECT_NEAR(measured({0}).area, 22, 1e-12);
  EXPECT_NEAR(measured({0}).volume.value(), 6, 1e-12);
  EXPECT_NEAR(measured({0, 1}).volume.value(), 7, 1e-12);
  EXPECT_FALSE(measured({0, 2}).volume);
  EXPECT_NEAR(measured({2}).area, 1, 1e-12);
}

TEST(SelectionMeasures, are_updated_once_a_stroke_is_cut) {
  Document document(row_of_sheets(1));
  PieceMap looks;
  looks[{document.world().ids()[0], 0}].selected = true;
  SelectionMeasures measures;
  const double before = measures.follow(document, looks).area;
  CutSettings settings;
  settings.laser.radius = 0.1;
  const Vec3 above = document.world().bounds().centre() + Vec3(0, 5, 0);
  document.apply(BeginStroke{settings, {above, {0, -1, 0}}});
  document.apply(EndStroke{});
  EXPECT_EQ(measures.follow(document, looks).area, before);
  while (document.waiting() > 0) ASSERT_TRUE(document.step(8).ok());
  EXPECT_LT(measures.follow(document, looks).area, before - 0.02);
}

}  // namespace
}  // namespace kerf
