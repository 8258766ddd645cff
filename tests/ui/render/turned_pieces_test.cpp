#include <gtest/gtest.h>

#include <string>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "core/graph/drawn_graph.h"
#include "tests/ui/render/shadow_oracle.h"
#include "tests/ui/render/shadow_scenes.h"
#include "tests/ui/render/stage.h"

namespace kerf {
namespace {

constexpr int kTurnedWidth = 240, kTurnedHeight = 180;

ViewOptions plainly_under(const Light& light) {
  ViewOptions options;
  options.show.shadows = Shadows::kAll;
  options.antialias = options.rim_glow = false;
  options.lights = {light};
  return options;
}

// A piece that a look turns and moves has to be drawn, and to cast its shadow, as it does where it stands
// there.
TEST(TurnedPieces, look_as_if_placed_at_their_display_transform) {
  Random random(11);
  const CameraView view = test::view_of_ball_and_ring(double{kTurnedWidth} / kTurnedHeight);
  for (const Light& light : {Light{}, test::lamp_at({1, 4, 1.5})}) {
    test::Stage stage = test::ball_and_ring();
    for (const BodyId id : stage.world().ids()) {
      for (uint32_t label = 0; label < stage.world().body(id).pieces.size(); ++label) {
        const Body& body = stage.world().body(id);
        if (body.pieces[label].faces == 0) continue;
        SCOPED_TRACE("piece " + std::to_string(label) + " of body " + std::to_string(id.slot));
        const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const glm::dquat turn = glm::angleAxis(random.uniform(0.2, 3), glm::normalize(axis));
        const Vec3 offset(random.uniform(-0.2, 0.2), 0.3, random.uniform(-0.2, 0.2));
        ViewOptions options = plainly_under(light);
        options.pieces[{id, label}].turn = turn;
        options.pieces[{id, label}].offset = offset;
        const Pixels shown = stage.draw(view, options, kTurnedWidth, kTurnedHeight);
        const Pixels before = stage.draw(view, plainly_under(light), kTurnedWidth, kTurnedHeight);
        stage.apply(MovePiece{{id, label}, {turn * body.placement.position + offset, turn}});
        const Pixels stands = stage.draw(view, plainly_under(light), kTurnedWidth, kTurnedHeight);
        EXPECT_LT(test::difference(shown, stands).changed, 0.003);
        EXPECT_GT(test::difference(shown, before).changed, 0.003);
        stage.apply(Undo{});
      }
    }
  }
}

TEST(TurnedPieces, have_the_normals_of_their_faces) {
  const CameraView view = test::view_of_ball_and_ring(double{kTurnedWidth} / kTurnedHeight);
  test::Stage stage = test::ball_and_ring();
  const PieceId ring{stage.world().ids().back(), 0};
  const glm::dquat turn = glm::angleAxis(0.7, glm::normalize(Vec3(1, 2, -1)));
  const Vec3 offset(-0.2, 0.9, 0.1);
  ViewOptions options = plainly_under(Light{});
  options.show.normals = true;
  const Pixels before = stage.draw(view, options, kTurnedWidth, kTurnedHeight);
  ViewOptions displaced = options;
  displaced.pieces[ring].turn = turn;
  displaced.pieces[ring].offset = offset;
  const Pixels shown = stage.draw(view, displaced, kTurnedWidth, kTurnedHeight);
  stage.apply(MovePiece{ring, {turn * stage.world().body(ring.body).placement.position + offset, turn}});
  const Pixels stands = stage.draw(view, options, kTurnedWidth, kTurnedHeight);
  EXPECT_LT(test::difference(shown, stands).changed, 0.003);
  EXPECT_GT(test::difference(shown, before).changed, 0.003);
}

// After a third of a turn about the centre of the plate, the middle of each of its two faces lies on the
// other.
TEST(TurnedPieces, have_the_numbers_the_graph_and_the_outline_of_their_faces) {
  World world;
  world.add(make_body("plate", test::build(test::plate(2))));
  test::Stage stage(std::move(world));
  const PieceId plate{stage.world().ids().front(), 0};
  const CameraView view = look_at({0.3, 6, 0.2}, {0, 0, 0}, double{kTurnedWidth} / kTurnedHeight);
  const glm::dquat turn = glm::angleAxis(2 * kPi / 3, Vec3(0, 1, 0));
  ViewOptions options = plainly_under(Light{});
  const Pixels plain = stage.draw(view, options, kTurnedWidth, kTurnedHeight);
  options.show.face_numbers = options.show.graph = true;
  options.mark_scale = 3;
  options.lit_face = FaceOfBody{plate.body, FaceId(0)};
  const CutGraph graph = cut_graph(stage.world(), {});
  options.graph = std::make_shared<DrawnGraph>(draw_graph(graph, traverse_cut(graph, 0), GraphScope::kWhole));
  ViewOptions displaced = options;
  displaced.pieces[plate].turn = turn;
  const Pixels shown = stage.draw(view, displaced, kTurnedWidth, kTurnedHeight);
  stage.apply(MovePiece{plate, {turn * stage.world().body(plate.body).placement.position, turn}});
  const Pixels stands = stage.draw(view, options, kTurnedWidth, kTurnedHeight);
  EXPECT_LT(test::difference(shown, stands).changed, 0.003);
  EXPECT_GT(test::difference(shown, plain).changed, 0.02);
}

TEST(TurnedPieces, cast_the_shadows_that_rays_find) {
  const CameraView view = test::view_of_ball_and_ring(double{kTurnedWidth} / kTurnedHeight);
  test::Stage stage = test::ball_and_ring();
  ViewOptions options = plainly_under(Light{});
  PieceLook& ring = options.pieces[{stage.world().ids().back(), 0}];
  ring.turn = glm::angleAxis(0.7, glm::normalize(Vec3(1, 2, -1)));
  ring.offset = {-0.2, 0.9, 0.1};
  Renderer& renderer = stage.renderer();
  ShadowReference traced =
      renderer.shadow_reference(stage.world(), view, options, 0, true, kTurnedWidth, kTurnedHeight);
  traced.trace(size_t{kTurnedWidth} * kTurnedHeight);
  const test::ShadowVerdict v =
      test::judge(renderer.shadow_counts(stage.world(), view, options, 0, ShadowMethod::kRobust, true,
                                         kTurnedWidth, kTurnedHeight),
                  traced);
  SCOPED_TRACE(v.summary());
  EXPECT_LT(v.wrong, v.hit / 1000);
  EXPECT_LT(v.hit - v.same_face, v.hit / 50);
  EXPECT_GT(v.in_shadow, v.hit / 100);
}

}  // namespace
}  // namespace kerf
