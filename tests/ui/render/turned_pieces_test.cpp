#include <gtest/gtest.h>

#include <string>

#include "core/base/random.h"
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

}  // namespace
}  // namespace kerf
