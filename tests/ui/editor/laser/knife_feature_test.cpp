#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/laser/knife_line.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

double height(const KnifePlane& plane, const Vec3& p) { return glm::dot(plane.normal, p) - plane.distance; }

TEST(KnifeLine, plane_contains_all_points_seen_on_the_line_and_no_others) {
  Random random(4);
  for (const double pull : {1.0, CameraView::kFarAway}) {
    const CameraView view = look_at({1, 2, 5}, {0, 0.5, 0}, 1.5).pulled(pull);
    for (int i = 0; i < 50; ++i) {
      const auto place = [&] { return Vec2(random.uniform(-1, 1), random.uniform(-1, 1)); };
      const Vec2 from = place(), to = place();
      const KnifePlane plane = plane_through(view, from, to);
      EXPECT_NEAR(glm::length(plane.normal), 1, 1e-12);
      const Vec2 on = glm::mix(from, to, random.uniform(-1, 2));
      const Pose ray = view.ray(on.x, on.y);
      const double far = view.focus, slack = 1e-9 * far;
      EXPECT_NEAR(height(plane, ray.origin + far * ray.direction), 0, slack);
      const Vec2 aside = on + Vec2(from.y - to.y, to.x - from.x);
      const Pose other = view.ray(aside.x, aside.y);
      EXPECT_GT(std::abs(height(plane, other.origin + far * other.direction)), slack) << "seed 4, case " << i;
    }
  }
}

TEST(KnifeLine, crosses_only_visible_bodies_on_both_sides) {
  World world;
  const BodyId ball = world.add(make_body("ball", test::build(test::sphere(12, 16, 1))));
  EXPECT_TRUE(crosses(world, {{0, 1, 0}, 0.9}));
  EXPECT_FALSE(crosses(world, {{0, 1, 0}, 1.1}));
  world.body(ball).placement.position = {0, 0.5, 0};
  EXPECT_TRUE(crosses(world, {{0, 1, 0}, 1.1}));
  world.body(ball).hidden = true;
  EXPECT_FALSE(crosses(world, {{0, 1, 0}, 0.9}));
}

TEST(KnifeFeature, cuts_at_the_section_plane_only_while_it_is_shown) {
  Workspace workspace;
  World world;
  world.add(make_body("ball", test::build(test::sphere(12, 16, 1))));
  workspace.session.document = Document(std::move(world));
  const auto knife = knife_feature(workspace);
  const std::vector<UserAction> actions = knife->actions();
  const UserAction* cut = find_action(actions, "section.cut");
  ASSERT_NE(cut, nullptr);
  EXPECT_NE(cut->objection(), nullptr);
  workspace.view.look.show.section = true;
  workspace.view.look.section = SectionPlane::facing({0, 5, 0}, {0, 1, 0});
  EXPECT_EQ(cut->objection(), nullptr);
  cut->run();
  EXPECT_FALSE(workspace.changes.has_requests());  // it crosses nothing
  workspace.view.look.section = SectionPlane::facing({0, 0.1, 0}, {0, 1, 0});
  cut->run();
  EXPECT_TRUE(workspace.changes.has_requests());
}

}  // namespace
}  // namespace kerf
