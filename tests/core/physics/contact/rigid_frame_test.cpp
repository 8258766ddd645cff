#include "core/physics/contact/rigid_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// Closed forms of thin shells of surface density s: a plate a x b, a tube of radius r and length l.
TEST(RigidFrame, has_the_mass_and_inertia_of_closed_forms) {
  World world;
  const BodyId plate = test::add(world, test::rectangle(0.6, 0.4, 3), {5, 6, 7});
  RigidFrame frame = rigid_frame(world.body(plate));
  const double m = 0.6 * 0.4 * 0.001 * 7850;
  EXPECT_NEAR(frame.mass, m, 1e-12);
  std::array<double, 3> inertia{frame.inertia.x, frame.inertia.y, frame.inertia.z};
  std::sort(inertia.begin(), inertia.end());
  EXPECT_NEAR(inertia[0], m * 0.16 / 12, 1e-12);
  EXPECT_NEAR(inertia[1], m * 0.36 / 12, 1e-12);
  EXPECT_NEAR(inertia[2], m * 0.52 / 12, 1e-12);
}

TEST(RigidFrame, gives_back_the_placement_it_was_put_in) {
  World world;
  const Soup soup = test::moved(test::rectangle(0.6, 0.4, 3), {3, -2, 8}, 1);
  const BodyId id = test::add(world, soup, {5, 6, 7}, glm::normalize(glm::dquat(1, 2, -1, 0.5)));
  const Body& body = world.body(id);
  const RigidFrame frame = rigid_frame(body);
  const Placement back = frame.body_at(frame.in_world(body.placement));
  EXPECT_LT(glm::length(back.position - body.placement.position), 1e-13);
  EXPECT_LT(glm::length(frame.in_world(body.placement).position - body.placement.to_world({3, -2, 8})),
            1e-12);
}

}  // namespace
}  // namespace kerf
