
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

class Some {
 public:
  explicit Some(uint32_t seed) : random_(seed) {}
  double number() { return static_cast<double>(random_()) / 2147483648.0 - 1; }  // -1 to 1
  Vec3 vector() { return {number(), number(), number()}; }
  SectionPlane plane() { return SectionPlane::facing(vector() * std::exp2(40 * number()), vector()); }

 private:
  std::mt19937 random_;
};

TEST(SectionPlane, a_ray_is_kept_below_the_plane) {
  Some some(1);
  size_t kept = 0, removed = 0;
  for (int i = 0; i < 2000; ++i) {
    const SectionPlane plane = SectionPlane::facing(some.vector(), some.vector());
    const Pose ray{some.vector(), glm::normalize(some.vector())};
    const Interval range = plane.kept_along(ray);
    for (const double length : {0.0, 0.3, 1.1, 7.0, 900.0}) {
      const double height = plane.height_of(ray.origin + ray.direction * length);
      if (std::abs(height) < 1e-9) continue;
      const bool in_range = range.low <= length && length <= range.high;
      EXPECT_EQ(in_range, height < 0) << "trial " << i << ", length " << length;
      (in_range ? kept : removed) += 1;
    }
  }
  EXPECT_GT(kept, 2000u);
  EXPECT_GT(removed, 2000u);
}

TEST(SectionPlane, a_ray_along_the_plane_is_kept_whole_or_not_at_all) {
  const SectionPlane plane{{0, 1, 0}, {0, 1, 0}};
  EXPECT_GT(plane.kept_along({{0, 0.5, 0}, {1, 0, 0}}).high, 1e300);
  const Interval removed = plane.kept_along({{0, 1.5, 0}, {1, 0, 0}});
  EXPECT_LT(removed.high, removed.low);
}

TEST(SectionPlane, text_round_trips) {
  Some some(2);
  for (int i = 0; i < 500; ++i) {
    const SectionPlane plane = some.plane();
    const auto read = parse_section(section_text(plane));
    ASSERT_TRUE(read.ok()) << section_text(plane);
    EXPECT_EQ(*read, plane) << section_text(plane);
  }
}

TEST(SectionPlane, is_parsed_from_common_notations) {
  const SectionPlane expected{{1, -2.5, 0}, {0, 1, 0}};
  for (const char* text : {"1,-2.5,0 0,1,0", "  1, -2.5, 0   0, 20, 0\n", "\"1,-2.5,0 0,1,0\"",
                           "--section \"1,-2.5,0 0,1e-200,0\"", "--section='1,-2.5,0\t0,1e200,0'"}) {
    const auto read = parse_section(text);
    ASSERT_TRUE(read.ok()) << text;
    EXPECT_EQ(*read, expected) << text;
  }
}

TEST(SectionPlane, other_texts_are_rejected_with_a_message) {
  for (const char* text :
       {"", "--section", "1,2,3", "1,2,3 0,1", "1,2,3 0,1,0 5", "1,2,3,0,1,0", "1 2 3 0 1 0", "a,b,c 0,1,0",
        "1,2,nan 0,1,0", "1,2,3 0,inf,0", "{\"eye\":[1,2,3]}"}) {
    const auto read = parse_section(text);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_NE(read.error().message.find("x,y,z x,y,z"), std::string::npos) << text;
  }
  EXPECT_NE(parse_section("1,2,3 0,0,0").error().message.find("must not be 0,0,0"), std::string::npos);
}

TEST(SectionPlane, the_initial_plane_passes_through_the_centre_facing_the_eye) {
  const World::Bounds bounds{{0, 2, 4}, {2, 4, 10}};
  EXPECT_EQ(section_through(bounds, {0.3, 0.5, 0.8}), (SectionPlane{{1, 3, 7}, {0, 0, 1}}));
  EXPECT_EQ(section_through(bounds, {-0.8, 0.5, 0.3}), (SectionPlane{{1, 3, 7}, {-1, 0, 0}}));
  EXPECT_EQ(section_through(bounds, {0.3, -0.9, 0.2}), (SectionPlane{{1, 3, 7}, {0, -1, 0}}));
}

TEST(SectionPlane, clips_only_while_shown) {
  ViewOptions options;
  EXPECT_EQ(shown_section(options), nullptr);
  options.show.section = true;
  EXPECT_EQ(shown_section(options), nullptr);
  options.section.emplace();
  EXPECT_EQ(shown_section(options), &*options.section);
  options.show.section = false;
  EXPECT_EQ(shown_section(options), nullptr);
}

}  // namespace
}  // namespace kerf
