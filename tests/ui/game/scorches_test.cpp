#include "ui/game/match_picture.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

// Beams from above onto flat ground, far from any vehicle.
class ScorchedGround : public testing::Test {
 protected:
  void burn(double x, double height = 0) {
    BeamPicture beam;
    beam.from = {x, 3, -80};
    beam.to = {x, height, -80};
    beam.radius = 0.02;
    scorches_.burn(match_, beam, Sight(match_.world()));
  }
  std::vector<Scorch> places() const {
    Effects effects;
    scorches_.append_to(effects);
    return effects.scorches;
  }

  Match match_{{test::flat_rules(0, 0), 1, Difficulty::kNormal}};
  Scorches scorches_;
};

TEST_F(ScorchedGround, is_marked_where_a_beam_ends_on_it) {
  burn(5);
  ASSERT_EQ(places().size(), 1u);
  EXPECT_EQ(places()[0].at, Vec3(5, 0, -80));
  EXPECT_NEAR(glm::dot(places()[0].normal, Vec3(0, 1, 0)), 1, 1e-12);
  EXPECT_EQ(places()[0].heat, 1);
}

TEST_F(ScorchedGround, is_not_marked_by_a_beam_that_ends_in_the_air) {
  burn(5, 1);
  EXPECT_TRUE(places().empty());
}

TEST_F(ScorchedGround, glows_again_when_burnt_twice) {
  burn(5);
  scorches_.advance(0.7);
  EXPECT_NEAR(places()[0].heat, 0.5, 1e-9);
  burn(5.01);
  ASSERT_EQ(places().size(), 1u);
  EXPECT_EQ(places()[0].heat, 1);
  scorches_.advance(100);
  EXPECT_EQ(places()[0].heat, 0) << "it stays as a mark";
}

TEST_F(ScorchedGround, keeps_only_the_latest_marks) {
  for (size_t i = 0; i < Scorches::kMost + 10; ++i) burn(-40 + 0.1 * static_cast<double>(i));
  ASSERT_EQ(places().size(), Scorches::kMost);
  EXPECT_NEAR(places().front().at.x, -39, 1e-9);
  scorches_.clear();
  EXPECT_TRUE(places().empty());
}

}  // namespace
}  // namespace kerf
