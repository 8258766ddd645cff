#include "core/game/match/recording.h"

#include <gtest/gtest.h>

#include <map>

#include "core/game/match/match.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// A match that the bot played, with what a log of it must find.
struct Played {
  std::unique_ptr<Match> match;
  std::vector<Controls> controls;
  ScoreLog log;
  struct Points {
    double sum;
    size_t wave;
  };
  std::map<Ticks, Points> points;  // by tick
};

Played play(const MatchSetup& setup, double seconds) {
  Played played{std::make_unique<Match>(setup), {}, {}, {}};
  BotPlayer bot(*played.match);
  while (seconds_of_ticks(played.match->standing().ticks) < seconds && !played.match->standing().over()) {
    played.controls.push_back(bot.next(*played.match));
    played.match->tick(played.controls.back());
    played.log.on_tick(*played.match);
    for (const Event& e : played.match->events()) {
      if (e.points <= 0) continue;
      Played::Points& points = played.points[played.match->standing().ticks];
      points = {points.sum + e.points, played.match->standing().wave};
    }
  }
  return played;
}

double points_between(const Played& played, Ticks from, Ticks to, size_t wave) {
  double sum = 0;
  for (const auto& [tick, points] : played.points)
    sum += tick > from && tick <= to && points.wave == wave ? points.sum : 0;
  return sum;
}

MatchSetup duel(uint64_t seed) { return {test::flat_rules(2, 1), seed, Difficulty::kEasy}; }

TEST(ScoreLog, finds_the_ten_highest_scoring_seconds_for_replay) {
  const MatchSetup setup = duel(1);
  const Played played = play(setup, 30);
  ASSERT_FALSE(played.points.empty()) << "the bot scored nothing";
  const auto best = played.log.best();
  ASSERT_TRUE(best);
  EXPECT_LE(best->to - best->from, ScoreLog::kMoment);
  EXPECT_EQ(points_between(played, best->from, best->to, best->start.standing.wave), best->points);
  for (const auto& [last, points] : played.points) {
    const Ticks to = last + ScoreLog::kAfterwards, from = to - std::min(to, ScoreLog::kMoment);
    EXPECT_LE(points_between(played, from, last, points.wave), best->points);
  }
  const auto before = match_at(setup, best->start, played.controls, best->from);
  const auto after = match_at(setup, best->start, played.controls, best->to);
  EXPECT_EQ(after->standing().score - before->standing().score, best->points);
}

TEST(ScoreLog, a_match_started_at_a_later_wave_equals_the_whole_match) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const MatchSetup setup = duel(seed);
    const Played played = play(setup, 60);
    const WaveStart& start = played.match->wave_start();
    if (start.standing.wave == 0) continue;
    const auto again = match_at(setup, start, played.controls, played.match->standing().ticks);
    EXPECT_EQ(state_hash(again->world()), state_hash(played.match->world())) << "seed " << seed;
    EXPECT_EQ(again->standing().score, played.match->standing().score);
    EXPECT_EQ(again->strokes(), played.match->strokes());
    return;
  }
  FAIL() << "no seed came to the second wave";
}

TEST(ScoreLog, the_best_moment_is_the_last_one_without_points) {
  Match match({test::flat_rules(0, 0), 1, Difficulty::kEasy});
  ScoreLog log;
  EXPECT_FALSE(log.best());
  for (int t = 0; t < 1500; ++t) {
    match.tick({});
    log.on_tick(match);
  }
  const auto best = log.best();
  ASSERT_TRUE(best);
  EXPECT_EQ(best->to, 1500u);
  EXPECT_EQ(best->from, 300u);
}

TEST(ScoreLog, points_before_the_first_tick_of_a_wave_belong_to_no_moment) {
  Match match({test::flat_rules(0, 0), 1, Difficulty::kEasy});
  auto& events = const_cast<std::vector<Event>&>(match.events());
  events.assign(1, {.kind = Event::Kind::kCut, .vehicle = 1, .points = 10});
  ScoreLog log;
  log.on_tick(match);
  match.tick({});
  log.on_tick(match);
  const auto best = log.best();
  ASSERT_TRUE(best);
  EXPECT_EQ(best->points, 0);
}

TEST(ScoreLog, a_cancelled_search_returns_no_match) {
  const MatchSetup setup = duel(1);
  const std::vector<Controls> controls(10);
  EXPECT_EQ(match_at(setup, Match(setup).wave_start(), controls, 10, [] { return true; }), nullptr);
}

}  // namespace
}  // namespace kerf
