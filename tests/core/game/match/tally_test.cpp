#include "core/game/match/rules.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

class TallyTest : public testing::Test {
 protected:
  TallyTest() { tally.begin_wave(3); }

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
  Scores scores{.wheel = 1, .turret = 10, .kill = 100, .at_a_stroke = 1000, .medals = {}};
  Tally tally{scores, {}, 0};
};

TEST_F(TallyTest, points_are_awarded_for_the_last_cut_of_the_player) {
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

TEST_F(TallyTest, a_laser_scores_once_also_if_another_vehicle_cut_its_barrel_off) {
  Damage barrel, turret;
  barrel.barrel = turret.turret = true;
  cut(1, 2);
  tally.record_damage(stage.world, 2, stage.vehicle, barrel);
  EXPECT_EQ(tally.standing().score, 0);
  cut(Tally::kPlayer, 2);
  tally.record_damage(stage.world, 2, stage.vehicle, turret);
  EXPECT_EQ(tally.standing().score, scores.turret);
  tally.record_damage(stage.world, 2, stage.vehicle, barrel);
  EXPECT_EQ(tally.standing().score, scores.turret);
}

TEST_F(TallyTest, a_kill_in_the_first_stroke_scores_more) {
  tally.count_stroke();
  cut(Tally::kPlayer, 1);
  tally.record_damage(stage.world, 1, stage.vehicle, death());
  EXPECT_EQ(tally.standing().score, 1100);
}

TEST_F(TallyTest, lost_wheels_of_the_player_are_counted_without_points) {
  Damage damage;
  damage.wheels = {0, 1};
  cut(Tally::kPlayer, Tally::kPlayer);
  tally.record_damage(stage.world, Tally::kPlayer, stage.vehicle, damage);
  EXPECT_EQ(tally.standing().wheels_lost, 2u);
  EXPECT_EQ(tally.standing().score, 0);
}

TEST_F(TallyTest, a_vehicle_is_assessed_soon_after_a_cut_and_at_once_if_a_piece_is_off) {
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

TEST_F(TallyTest, a_quarter_of_a_chassis_coming_off_is_reported_as_cut_in_half) {
  cut(Tally::kPlayer, 1);
  tally.begin_tick();
  tally.record_piece({stage.vehicle.chassis, 1, stage.vehicle.chassis, false}, chassis(), 1, &stage.vehicle,
                     false);
  ASSERT_EQ(tally.events().size(), 2u);
  EXPECT_EQ(tally.events()[0].kind, Event::Kind::kPieceOff);
  EXPECT_EQ(tally.events()[1].kind, Event::Kind::kInHalves);
  EXPECT_EQ(tally.standing().pieces, 1u);
}

TEST_F(TallyTest, only_pieces_that_the_player_cut_off_others_count_as_cut) {
  const Detached piece{stage.vehicle.chassis, 1, stage.vehicle.chassis, false};
  cut(1, Tally::kPlayer);
  tally.record_piece(piece, chassis(), Tally::kPlayer, &stage.vehicle, false);
  tally.record_piece(piece, chassis(), 2, &stage.vehicle, false);
  EXPECT_EQ(tally.standing().pieces_cut, 0u);
  cut(Tally::kPlayer, 2);
  tally.record_piece(piece, chassis(), 2, &stage.vehicle, false);
  EXPECT_EQ(tally.standing().pieces_cut, 1u);
}

TEST_F(TallyTest, different_parts_within_four_seconds_multiply_their_points) {
  const auto lose = [&](size_t wheel) {
    Damage damage;
    damage.wheels = {wheel};
    tally.record_damage(stage.world, 1, stage.vehicle, damage);
    return tally.events().back();
  };
  cut(Tally::kPlayer, 1);
  EXPECT_EQ(lose(0).points, 1);
  EXPECT_EQ(lose(0).combo, 1u) << "the same part of another car";
  EXPECT_EQ(lose(1).points, 2);
  tally.standing().ticks += 3 * kTicksPerSecond;
  EXPECT_EQ(lose(2).points, 3);
  tally.standing().ticks += 5 * kTicksPerSecond;
  EXPECT_EQ(lose(3).points, 1);
}

}  // namespace
}  // namespace kerf
