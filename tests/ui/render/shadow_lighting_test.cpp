#include <gtest/gtest.h>

#include "tests/ui/render/shadow_scenes.h"
#include "tests/ui/render/stage.h"

namespace kerf {
namespace {

constexpr int kLightingWidth = 240, kLightingHeight = 180;

class Lit {
 public:
  Lit()
      : stage_(test::world_of_all({test::box({0, 1, 0}, {1, 1, 1}), test::floor_at(0, 40)})),
        view_(look_at({2.6, 2.0, 4.2}, {0, 1.3, 0}, static_cast<double>(kLightingWidth) / kLightingHeight)) {
    options_.antialias = false;
    options_.show.shadows = Shadows::kAll;
    options_.lights = {test::sun_from({0.4, 1, 0.5})};
    counts_ = stage_.renderer().shadow_counts(stage_.world(), view_, options_, 0, ShadowMethod::kRobust, true,
                                              kLightingWidth, kLightingHeight);
  }
  Pixels draw() { return stage_.draw(view_, options_, kLightingWidth, kLightingHeight); }
  ViewOptions& options() { return options_; }

  // Calls visit(byte of the first channel, face, shadow) for every pixel.
  template <typename Visit>
  void for_each_pixel(const Visit& visit) const {
    for (int y = 0; y < kLightingHeight; ++y) {
      for (int x = 0; x < kLightingWidth; ++x) {
        const auto i = static_cast<size_t>(y * kLightingWidth + x);
        visit(3 * static_cast<size_t>((kLightingHeight - 1 - y) * kLightingWidth + x), counts_.faces[i],
              counts_.stencil[i] != 0);
      }
    }
  }

  // Calls visit(byte of the first channel, shadow) for every pixel whose 3x3 neighbours show a face, all of
  // them lit or all in shadow.
  template <typename Visit>
  void for_each_inner_pixel(const Visit& visit) const {
    for_each_pixel([&](size_t at, uint32_t face, bool shadow) {
      const int i = static_cast<int>(at / 3), x = i % kLightingWidth,
                y = kLightingHeight - 1 - i / kLightingWidth;
      if (face == 0 || x == 0 || y == 0 || x == kLightingWidth - 1 || y == kLightingHeight - 1) return;
      for (int n = 0; n < 9; ++n) {
        const auto beside = static_cast<size_t>((y + n / 3 - 1) * kLightingWidth + x + n % 3 - 1);
        if (counts_.faces[beside] == 0 || (counts_.stencil[beside] != 0) != shadow) return;
      }
      visit(at, shadow);
    });
  }

 private:
  test::Stage stage_;
  CameraView view_;
  ViewOptions options_;
  ShadowCounts counts_;
};

// The sky, as it is without any shadow, with every method and look.
TEST(ShadowLighting, does_not_affect_the_sky) {
  Lit lit;
  lit.options().show.shadows = Shadows::kGround;
  const Pixels plain = lit.draw();
  lit.options().show.shadows = Shadows::kAll;
  for (const ShadowMethod method : {ShadowMethod::kRobust, ShadowMethod::kPaperOneVolume}) {
    for (const bool paper_look : {false, true}) {
      lit.options().shadow.method = method;
      lit.options().shadow.paper_look = paper_look;
      const Pixels drawn = lit.draw();
      size_t sky = 0, changed = 0;
      lit.for_each_pixel([&](size_t at, uint32_t face, bool) {
        sky += face == 0;
        changed += face == 0 && std::abs(drawn.rgb[at] - plain.rgb[at]) > 1;
      });
      EXPECT_GT(sky, 1000u);
      EXPECT_EQ(changed, 0u);
    }
  }
}

// In shadow all is as without the light; elsewhere it is brighter or the same.
TEST(ShadowLighting, light_is_added_only_where_the_stencil_is_zero) {
  Lit lit;
  const Pixels with = lit.draw();
  lit.options().lights.clear();
  const Pixels without = lit.draw();
  size_t shadow = 0, brighter = 0;
  lit.for_each_pixel([&](size_t at, uint32_t face, bool in_shadow) {
    if (face == 0) return;
    const int gain = with.rgb[at] - without.rgb[at];
    shadow += in_shadow;
    EXPECT_GE(gain, -1);
    if (in_shadow) {
      EXPECT_LE(std::abs(gain), 6);  // what is mirrored of the light's environment
    } else {
      brighter += gain > 6;
    }
  });
  EXPECT_GT(shadow, 1000u);
  EXPECT_GT(brighter, 5000u);
}

// The first channel of a pixel or of one of its eight neighbours.
int darkest_around(const Pixels& picture, size_t at) {
  int darkest = 255;
  for (int n = 0; n < 9; ++n) {
    const int beside = static_cast<int>(at) + 3 * ((n / 3 - 1) * kLightingWidth + n % 3 - 1);
    darkest = std::min<int>(darkest, picture.rgb[static_cast<size_t>(beside)]);
  }
  return darkest;
}

// Each sample of a pixel has a stencil of its own: away from the boundaries of the shadow that one sample
// sees, no light leaks into it and no dark out of it.
TEST(ShadowLighting, light_does_not_leak_at_edges_with_multisampling) {
  Lit lit;
  const Pixels one_sample = lit.draw();
  lit.options().antialias = true;
  const Pixels with = lit.draw();
  lit.options().lights.clear();
  const Pixels without = lit.draw();
  size_t shadow = 0, lit_up = 0, leaks = 0, dark = 0;
  lit.for_each_inner_pixel([&](size_t at, bool in_shadow) {
    (in_shadow ? shadow : lit_up)++;
    leaks += in_shadow && with.rgb[at] - without.rgb[at] > 6;
    dark += !in_shadow && with.rgb[at] < darkest_around(one_sample, at) - 12;
  });
  EXPECT_GT(shadow, 1000u);
  EXPECT_GT(lit_up, 5000u);
  EXPECT_EQ(leaks, 0u);
  EXPECT_EQ(dark, 0u);
}

TEST(ShadowLighting, four_lights_add_up_and_cast_a_shadow_each) {
  Lit lit;
  const Pixels one = lit.draw();
  for (const Vec3& from : {Vec3(-0.6, 1, 0.2), Vec3(0.1, 1, -0.8), Vec3(0.8, 0.7, -0.1)}) {
    lit.options().lights.push_back(test::sun_from(from));
  }
  const Pixels four = lit.draw();
  size_t brighter_in_shadow = 0, darker = 0;
  lit.for_each_pixel([&](size_t at, uint32_t face, bool in_shadow) {
    brighter_in_shadow += face != 0 && in_shadow && four.rgb[at] > one.rgb[at] + 10;
    darker += four.rgb[at] + 1 < one.rgb[at];
  });
  EXPECT_GT(brighter_in_shadow, 300u);
  EXPECT_EQ(darker, 0u);
}

// Without shadows, with those on the ground and with all, each state darkens what it names and nothing else.
TEST(ShadowLighting, none_ground_and_all_differ_on_the_surfaces_they_name) {
  test::Stage stage(test::world_of_all({test::box({0, 0, 0}, {1, 1, 1}), test::box({0, 2.2, 0}, {1, 1, 1})}));
  const CameraView view =
      look_at({6, 7, -9}, {-1, 1, 0}, static_cast<double>(kLightingWidth) / kLightingHeight);
  ViewOptions options;
  options.antialias = false;
  options.lights = {test::sun_from({0.4, 1, 0.2})};
  const auto draw = [&](Shadows shadows) {
    options.show.shadows = shadows;
    return stage.draw(view, options, kLightingWidth, kLightingHeight);
  };
  const Pixels none = draw(Shadows::kNone), ground = draw(Shadows::kGround), all = draw(Shadows::kAll);
  const ShadowCounts counts = stage.renderer().shadow_counts(
      stage.world(), view, options, 0, ShadowMethod::kRobust, false, kLightingWidth, kLightingHeight);
  const auto darker = [&](const Pixels& picture, bool on_bodies) {
    size_t count = 0;
    for (size_t i = 0; i < counts.faces.size(); ++i) {
      const size_t x = i % kLightingWidth, y = kLightingHeight - 1 - i / kLightingWidth,
                   at = 3 * (y * kLightingWidth + x);
      count += (counts.faces[i] != 0) == on_bodies && picture.rgb[at] + 10 < none.rgb[at];
    }
    return count;
  };
  EXPECT_GT(darker(ground, false), 300u);
  EXPECT_EQ(darker(ground, true), 0u);
  EXPECT_GT(darker(all, false), 300u);
  EXPECT_GT(darker(all, true), 100u);
}

// A white-hot rim shows as bright under the paper's black as without it.
TEST(ShadowLighting, glowing_surfaces_are_not_darkened) {
  test::Stage stage = test::ball_and_ring();
  ViewOptions options;
  options.antialias = false;
  options.show.shadows = Shadows::kAll;
  options.lights = {test::sun_from({0.2, 1, -1.2})};  // the side that is seen lies in shadow
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kLightingWidth) / kLightingHeight);
  const auto hot = [&](const Pixels& p) {
    size_t count = 0;
    for (size_t i = 0; i < p.rgb.size(); i += 3) count += p.rgb[i] > 200 && p.rgb[i + 2] < p.rgb[i] - 40;
    return count;
  };
  const size_t bright = hot(stage.draw(view, options, kLightingWidth, kLightingHeight));
  options.shadow.paper_look = true;
  const size_t under_black = hot(stage.draw(view, options, kLightingWidth, kLightingHeight));
  EXPECT_GT(bright, 20u);
  EXPECT_GE(under_black, bright * 9 / 10);
}

}  // namespace
}  // namespace kerf
