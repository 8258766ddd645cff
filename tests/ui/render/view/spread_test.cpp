#include "ui/render/view/view_options.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/ui/render/shadow_oracle.h"
#include "tests/ui/render/shadow_scenes.h"
#include "tests/ui/render/stage.h"

namespace kerf {
namespace {

constexpr int kSpreadWidth = 160, kSpreadHeight = 120;
constexpr double kSpread = 0.6;

CameraView spread_view() { return look_at({2.4, 2.6, 3.6}, {0, 0, 0}, double{kSpreadWidth} / kSpreadHeight); }

ViewOptions spread_under_lamp() {
  ViewOptions options;
  options.show.shadows = Shadows::kAll;
  options.antialias = false;
  options.rim_glow = false;
  options.lights = {test::lamp_at({1, 4, 1.5})};
  return options;
}

const Soup kSheet = test::grid(40, 2);
const Soup kLeft = test::moved(test::sphere(10, 16, 0.15), {-0.6, 0.4, 0.2}, 1);
const Soup kRight = test::moved(test::sphere(10, 16, 0.15), {0.7, 0.3, -0.4}, 1);

void cut_in_two(test::Stage& stage) {
  stage.cut({{0, 3, -1.3}, {0, -1, 0}}, {{0, 3, 1.3}, {0, -1, 0}}, 0.02);
}

// The offset of the piece of the sheet that lies on this side.
Vec3 offset_at(const World& world, const ViewOptions& look, double side) {
  const BodyId id = world.ids().front();
  const Body& body = world.body(id);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    if (t[0].y == 0 && t[1].y == 0 && side * t[0].x > 0.5)
      return look.pieces.at({id, body.mesh.data(FaceId(f)).piece}).offset;
  }
  ADD_FAILURE() << "no face of the sheet there";
  return Vec3(0);
}

struct Drawn {
  Pixels apart, together;
  ShadowCounts shadow;  // apart
};

Drawn draw(test::Stage& stage, const ViewOptions& apart, const ViewOptions& together) {
  Drawn drawn;
  drawn.apart = stage.draw(spread_view(), apart, kSpreadWidth, kSpreadHeight);
  drawn.shadow = stage.renderer().shadow_counts(stage.world(), spread_view(), apart, 0, ShadowMethod::kRobust,
                                                true, kSpreadWidth, kSpreadHeight);
  drawn.together = stage.draw(spread_view(), together, kSpreadWidth, kSpreadHeight);
  return drawn;
}

// The looks of the sheet's pieces, and the offsets of those on the left and on the right.
struct Halves {
  std::map<uint32_t, PieceLook> looks;
  Vec3 left, right;
};

// A sheet with two balls that are loose parts of it.
Drawn draw_loose(Halves& halves) {
  test::Stage stage(test::world_of_all({test::both(test::both(kSheet, kLeft), kRight)}));
  cut_in_two(stage);
  ViewOptions look = spread_under_lamp();
  spread_pieces(stage.world(), kSpread, look);
  for (const auto& [id, piece] : look.pieces) halves.looks[id.label] = piece;
  halves.left = offset_at(stage.world(), look, -1);
  halves.right = offset_at(stage.world(), look, 1);
  ViewOptions together = look;
  spread_pieces(stage.world(), 0, together);
  return draw(stage, look, together);
}

// The same with balls that are bodies of their own, moved by hand to where the halves are.
Drawn draw_bodies(const Halves& halves) {
  test::Stage stage(test::world_of_all({kSheet, kLeft, kRight}));
  cut_in_two(stage);
  ViewOptions look = spread_under_lamp();
  const std::vector<BodyId> ids = stage.world().ids();
  for (const auto& [label, piece] : halves.looks) look.pieces[{ids[0], label}] = piece;
  look.pieces[{ids[1], 0}].offset = halves.left;
  look.pieces[{ids[2], 0}].offset = halves.right;
  return draw(stage, look, spread_under_lamp());
}

TEST(Spread, loose_parts_are_drawn_and_shaded_with_the_nearer_half) {
  Halves halves;
  const Drawn loose = draw_loose(halves), bodies = draw_bodies(halves);
  EXPECT_LT(test::difference(loose.apart, bodies.apart).changed, 0.002);
  EXPECT_LT(test::difference(loose.together, bodies.together).changed, 0.002);
  EXPECT_GT(test::difference(loose.together, loose.apart).changed, 0.05);
  size_t other = 0;
  for (size_t i = 0; i < loose.shadow.stencil.size(); ++i)
    other += loose.shadow.stencil[i] != bodies.shadow.stencil[i];
  EXPECT_LT(other, loose.shadow.stencil.size() / 500);
}

TEST(Spread, shadows_of_loose_parts_match_traced_rays) {
  test::Stage stage(test::world_of_all({test::both(test::both(kSheet, kLeft), kRight)}));
  cut_in_two(stage);
  ViewOptions options = spread_under_lamp();
  spread_pieces(stage.world(), kSpread, options);
  const ShadowCounts drawn = stage.renderer().shadow_counts(
      stage.world(), spread_view(), options, 0, ShadowMethod::kRobust, true, kSpreadWidth, kSpreadHeight);
  ShadowReference traced = stage.renderer().shadow_reference(stage.world(), spread_view(), options, 0, true,
                                                             kSpreadWidth, kSpreadHeight);
  traced.trace(size_t{kSpreadWidth} * kSpreadHeight);
  const test::ShadowVerdict verdict = test::judge(drawn, traced);
  EXPECT_EQ(verdict.wrong, 0u) << verdict.summary();
  EXPECT_GT(verdict.in_shadow, 50u);
}

}  // namespace
}  // namespace kerf
