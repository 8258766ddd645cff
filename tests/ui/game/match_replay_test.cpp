#include "ui/game/match_picture.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/game/match/match.h"
#include "core/world/world.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

TEST(MatchReplay, replays_the_moment_exactly_with_the_vehicles_in_view) {
  const MatchSetup setup{test::flat_rules(1, 1), 1, Difficulty::kEasy};
  Match match(setup);
  const WaveStart start = match.wave_start();
  BotPlayer bot(match);
  std::vector<Controls> controls;
  while (match.standing().ticks < 300 && !match.standing().over()) {
    controls.push_back(bot.next(match));
    match.tick(controls.back());
  }
  const MatchMoment moment{start, controls.size() / 3, 2 * controls.size() / 3, 1};
  const uint64_t end = state_hash(match_at(setup, start, controls, moment.to)->world());
  MatchReplay replay(setup, moment, controls);
  while (replay.state() == MatchReplay::State::kPreparing)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(replay.match().standing().ticks, moment.from);
  while (replay.state() == MatchReplay::State::kPlaying) {
    replay.tick();
    replay.move_camera(seconds_of_ticks(1));
    const CameraView view = replay.camera().view(16.0 / 9, 50);
    const Vec3 seen =
        view.project(replay.match().world().body(replay.match().vehicles()[1].chassis).placement.position);
    ASSERT_TRUE(seen.z > 0 && std::abs(seen.x) < 1 && std::abs(seen.y) < 1)
        << replay.match().standing().ticks;
  }
  EXPECT_EQ(replay.match().standing().ticks, moment.to);
  EXPECT_EQ(state_hash(replay.match().world()), end);
}

TEST(MatchReplay, cancelled_during_preparation_stops_early) {
  const MatchSetup setup{test::flat_rules(1, 1), 1, Difficulty::kEasy};
  const MatchMoment moment{Match(setup).wave_start(), 1'000'000, 1'000'000, 1};
  const MatchReplay replay(setup, moment, std::vector<Controls>(1'000'000));
}

}  // namespace
}  // namespace kerf
