#include "core/game/match/rules.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

class Counted : public testing::Test {
 protected:
  Counted() { tally.begin_wave(3); }

  // The beam of a vehicle removes a face of another one.
  void cut(size_t shooter, size_t victim) {
    StepResult cut;
    cut.delta.removed_faces = 1;
    tally.record_cut(shooter, victim, stage.vehicle.chassis, chassis(), cut);
  }
  const Body& chassis() const { return stage.world.body(stage.vehicle.chassis); }
  Damage death() const {
    Damage damage;
    damage.died = true;
    return damage;
  }

  test::LoneVehicle stage;
  Scores scores{.wheel = 1, .kill = 100, .at_a_stroke = 1000};
  Tally tally{scores, {}, 0};
};

TEST_F(Counted, points_are_for_what_the_player_cut_last) {
  cut(1, 2);
  tally.record_damage(stage.world, 2, stage.vehicle, death());
  EXPECT_EQ(tally.standing().score, 0);
  EXPECT_EQ(tally.standing().enemies_destroyed, 1u);

  tally.count_stroke();
  tally.count_stroke();
  cut(Tally::kPlayer, 1);
  tally.count_stroke();
  cut(Tally::kPlayer, 1);
  tally.record_damage(stage.world, 1, stage.vehicle, death());
  EXPECT_EQ(tally.standing().score, 100);
  EXPECT_EQ(tally.events().back().by, Tally::kPlayer);
  EXPECT_EQ(tally.events().back().points, 100);
}

TEST_F(Counted, who_is_killed_in_the_stroke_that_cut_it_first_counts_more) {
  tally.count_stroke();
  cut(Tally::kPlayer, 1);
  tally.record_damage(stage.world, 1, stage.vehicle, death());
  EXPECT_EQ(tally.standing().score, 1100);
}

TEST_F(Counted, wheels_of_the_player_are_counted_and_give_no_points) {
  Damage damage;
  damage.wheels = {0, 1};
  cut(Tally::kPlayer, Tally::kPlayer);
  tally.record_damage(stage.world, Tally::kPlayer, stage.vehicle, damage);
  EXPECT_EQ(tally.standing().wheels_lost, 2u);
  EXPECT_EQ(tally.standing().score, 0);
}

TEST_F(Counted, a_vehicle_is_assessed_at_once_where_a_piece_came_off_and_soon_where_it_was_cut) {
  EXPECT_FALSE(tally.takes_assessment(1));
  tally.record_piece({stage.vehicle.chassis, 1, stage.vehicle.chassis, false}, chassis(), 1, &stage.vehicle,
                     false);
  EXPECT_TRUE(tally.takes_assessment(1));
  EXPECT_FALSE(tally.takes_assessment(1));

  cut(Tally::kPlayer, 2);
  size_t assessed = 0;
  for (int t = 0; t < 12; ++t, ++tally.standing().ticks) assessed += tally.takes_assessment(2);
  EXPECT_EQ(assessed, 1u);
}

TEST_F(Counted, a_quarter_of_a_chassis_that_came_off_is_told_as_halves) {
  cut(Tally::kPlayer, 1);
  tally.begin_tick();
  tally.record_piece({stage.vehicle.chassis, 1, stage.vehicle.chassis, false}, chassis(), 1, &stage.vehicle,
                     false);
  ASSERT_EQ(tally.events().size(), 2u);
  EXPECT_EQ(tally.events()[0].kind, Event::Kind::kPieceOff);
  EXPECT_EQ(tally.events()[1].kind, Event::Kind::kInHalves);
  EXPECT_EQ(tally.standing().pieces, 1u);
}

}  // namespace
}  // namespace kerf
