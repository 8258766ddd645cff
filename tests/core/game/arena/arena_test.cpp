#include "core/game/arena/arena.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "tests/support/random_edits.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

// An arena of the same plate twice: one stands fast, the other may be cut.
class ArenaOfPlates : public testing::Test {
 protected:
  ArenaOfPlates() {
    test::write_text(mesh(), test::kPlateObj);
    described_.bodies.resize(2);
    described_.bodies[0].body.name = "floor";
    described_.bodies[1].body.name = "drum";
    described_.bodies[1].body.placement.position = {3, 1, 0};
    described_.bodies[1].body.sheet.thickness = 0.004;
    described_.bodies[1].cuttable = true;
    for (ArenaBody& body : described_.bodies) body.body.mesh = mesh();
  }
  std::filesystem::path mesh() const { return folder_ / "plate.obj"; }

  test::TemporaryFolder folder_;
  ArenaDescription described_;
};

TEST_F(ArenaOfPlates, pins_fixed_bodies_and_puts_cuttable_ones_to_sleep) {
  const auto arena = load_arena(described_);
  ASSERT_TRUE(arena) << arena.error().message;
  ASSERT_EQ(arena->bodies.size(), 2u);
  const Body &floor = arena->bodies[0].body, &drum = arena->bodies[1].body;
  EXPECT_TRUE(floor.pinned && !floor.motion.asleep);
  EXPECT_TRUE(!drum.pinned && drum.motion.asleep);
  EXPECT_EQ(floor.own_name(), "floor");
  EXPECT_EQ(drum.own_name(), "drum");
  EXPECT_EQ(drum.placement, described_.bodies[1].body.placement);
  EXPECT_EQ(drum.sheet.thickness, 0.004);
  EXPECT_EQ(drum.mesh.live_faces(), 2u);
}

TEST_F(ArenaOfPlates, names_a_mesh_that_is_missing_or_does_not_fit_a_joint) {
  JointDescription joint;
  joint.parts = {"door", "frame"};
  described_.bodies[1].body.joints = {joint};
  const auto without_parts = load_arena(described_);
  ASSERT_FALSE(without_parts);
  EXPECT_NE(without_parts.error().message.find(mesh().string()), std::string::npos);
  described_.bodies[0].body.mesh = folder_ / "gone.obj";
  const auto missing = load_arena(described_);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("gone.obj"), std::string::npos) << missing.error().message;
}

TEST(Start, faces_its_heading) {
  const Placement placement = Start{{1, 2, 3}, kPi / 2}.placement();
  EXPECT_EQ(placement.position, Vec3(1, 2, 3));
  EXPECT_NEAR(glm::distance(placement.orientation * Vec3(0, 0, 1), Vec3(1, 0, 0)), 0, 1e-12);
}

}  // namespace
}  // namespace kerf
