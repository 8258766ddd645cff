#include "core/game/vehicle/vehicle_model.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

// Eight triangles in four groups, of which one lies within another.
Soup grouped() {
  Soup soup;
  soup.positions.assign(10, Vec3(0));
  for (uint32_t t = 0; t < 8; ++t) soup.triangles.push_back({t, t + 1, t + 2});
  soup.materials = {0, 1, 0, 1, 0, 1, 0, 1};
  soup.material_names = {"paint", "rubber"};
  soup.parts = {{"wheel_front", 0, 2}, {"wheel_front_left", 2, 4}, {"body", 4, 7}, {"body_trim", 5, 6}};
  return soup;
}

using Parts = std::vector<uint32_t>;

TEST(SoupParts, belong_to_the_part_with_the_longest_matching_prefix) {
  EXPECT_EQ(part_of_triangles(grouped(), {"wheel", "wheel_front_left"}), (Parts{0, 0, 1, 1, 2, 2, 2, 2}));
  EXPECT_EQ(part_of_triangles(grouped(), {"wheel_front_left", "wheel"}), (Parts{1, 1, 0, 0, 2, 2, 2, 2}));
}

TEST(SoupParts, without_a_matching_part_belong_to_none) {
  EXPECT_EQ(part_of_triangles(grouped(), {"body_trim"}), (Parts{1, 1, 1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(part_of_triangles(grouped(), {}), Parts(8, 0));
}

TEST(SoupParts, are_extracted_with_their_groups_and_materials) {
  const Soup soup = grouped();
  const Soup own = extract_part(soup, part_of_triangles(soup, {"wheel"}), 0);
  ASSERT_EQ(own.triangles.size(), 4u);
  EXPECT_EQ(own.triangles[3], soup.triangles[3]);
  EXPECT_EQ(own.materials, (std::vector<uint16_t>{0, 1, 0, 1}));
  ASSERT_EQ(own.parts.size(), 2u);
  EXPECT_EQ(own.parts[1].name, "wheel_front_left");
  EXPECT_EQ(own.parts[1].first, 2u);
  EXPECT_EQ(own.parts[1].last, 4u);
  EXPECT_EQ(own.faces_in_file, 4u);
  const Soup rest = extract_part(soup, part_of_triangles(soup, {"wheel"}), 1);
  ASSERT_EQ(rest.parts.size(), 2u);
  EXPECT_EQ(rest.parts[0].name, "body");
  EXPECT_EQ(rest.parts[0].last, 3u);
  EXPECT_EQ(rest.parts[1].first, 1u);
  EXPECT_EQ(rest.triangles.back(), soup.triangles.back()) << "of no group";
}

}  // namespace
}  // namespace kerf
