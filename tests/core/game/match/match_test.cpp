#include "core/game/match/match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "core/game/match/recording.h"
#include "core/game/vehicle/vehicle.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

std::filesystem::path standard() { return test::checkout() / "assets/games/standard.json"; }

// Lets the bot play and returns its controls.
std::vector<Controls> play(Match& match, double seconds) {
  BotPlayer bot(match);
  std::vector<Controls> all;
  for (int t = 0; t < seconds * static_cast<double>(kTicksPerSecond); ++t) {
    all.push_back(bot.next(match));
    match.tick(all.back());
  }
  return all;
}

uint64_t hash_after(uint64_t seed, double seconds) {
  Match match({test::flat_rules(1, 1), seed, Difficulty::kNormal});
  play(match, seconds);
  return state_hash(match.world());
}

TEST(Match, the_world_is_deterministic_per_seed) {
  const uint64_t hash = hash_after(1, 4);
  EXPECT_EQ(hash_after(1, 4), hash);
  EXPECT_NE(hash_after(2, 4), hash);
}

TEST(Match, is_played_in_the_selected_arena) {
  const auto depot = test::checkout() / "assets/arenas/depot.json";
  const auto rules = load_rules(standard(), nullptr, {}, depot);
  ASSERT_TRUE(rules) << rules.error().message;
  EXPECT_EQ((*rules)->description.name, "standard, depot") << "it has high scores of its own";
  EXPECT_EQ((*rules)->arena_file, depot);
  Match match({*rules, 1, Difficulty::kNormal});
  play(match, 2);
  const Vec3 start = (*rules)->arena.description.player.position;
  EXPECT_GT(glm::distance(match.world().body(match.vehicles()[0].chassis).placement.position, start), 1);
  const auto same = load_rules(standard(), nullptr, {}, test::checkout() / "assets/arenas/yard.json");
  ASSERT_TRUE(same);
  EXPECT_TRUE((*same)->arena_file.empty()) << "the arena of the rules";
  EXPECT_EQ((*same)->description.name, "standard");
}

TEST(Match, a_recording_replays_to_the_same_world) {
  const auto rules = load_rules(standard());
  ASSERT_TRUE(rules) << rules.error().message;
  Match match({*rules, 3, Difficulty::kHard});
  const auto files = hash_of_files(standard(), (*rules)->description);
  ASSERT_TRUE(files);
  Recording recording;
  recording.rules = standard();
  recording.files = *files;
  recording.seed = 3;
  recording.difficulty = Difficulty::kHard;
  recording.controls = play(match, 2.5);
  recording.hash = state_hash(match.world());
  recording.machine = "here";
  test::TemporaryFolder folder;
  const auto text = recording_text(recording, folder.path());
  ASSERT_TRUE(text);
  test::write_text(folder / "match.kerf", *text + "{\"inputs\":[[1,0");
  ASSERT_TRUE(is_recording(folder / "match.kerf"));
  const auto read = read_recording(folder / "match.kerf");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NE(read->damage, "") << "the last line is torn";
  EXPECT_EQ(read->controls, recording.controls);
  EXPECT_EQ(read->files, *files);
  EXPECT_TRUE(std::filesystem::equivalent(read->rules, standard()));
  Match again({*rules, read->seed, read->difficulty});
  for (const Controls& controls : read->controls) again.tick(controls);
  EXPECT_EQ(state_hash(again.world()), read->hash);
}

TEST(Match, a_bot_keeps_playing_and_nothing_leaves_the_arena) {
  const auto rules = load_rules(standard());
  ASSERT_TRUE(rules) << rules.error().message;
  Match match({*rules, 1, Difficulty::kEasy});
  BotPlayer bot(match);
  const Vec2 half = 0.5 * (*rules)->arena.description.size;
  const Ticks all = runs(60) * kTicksPerSecond;  // a minute in the long run
  for (Ticks t = 0; t < all && !match.standing().over(); ++t) {
    match.tick(bot.next(match));
    for (const Vehicle& vehicle : match.vehicles()) {
      const Vec3 p = match.world().body(vehicle.chassis).placement.position;
      ASSERT_TRUE(std::abs(p.x) <= half.x && std::abs(p.z) <= half.y && p.y > -1 && p.y < 30) << "tick " << t;
    }
  }
  if (runs(60) == 1) return;  // too short for a hit
  EXPECT_GT(match.standing().score, 0);
  EXPECT_GT(match.standing().pieces, 3u);
  EXPECT_GT(match.standing().faces_removed, 100u);
}

// Ten waves of one enemy that neither drives nor fires.
std::shared_ptr<const Rules> ten_easy_waves() {
  auto rules = std::make_shared<Rules>(*test::flat_rules(10, 1));
  rules->description.times.match = 1000;
  rules->description.times.between_waves = 0;
  rules->description.laser.radius = {0.03, 0.06};
  rules->description.laser.drain = rules->description.laser.heating = 0;
  for (EnemySkill& skill : rules->description.skills) {
    skill.speed = 0;
    skill.max_firing = 0;
  }
  return rules;
}

// What a world holds; the highest slot tells how many bodies it has ever had.
struct Held {
  size_t bodies = 0, slots = 0, bytes = 0, joints = 0, contacts = 0, colliders = 0;
  friend bool operator==(const Held&, const Held&) = default;
};

Held held_by(const Match& match) {
  const World& world = match.world();
  Held held;
  for (const BodyId id : world.ids()) {
    ++held.bodies;
    held.slots = std::max<size_t>(held.slots, id.slot + 1);
    held.bytes += world.body(id).bytes();
  }
  held.joints = world.joints().all.size();
  held.contacts = world.contact_memory().size();
  held.colliders = match.physics().colliders().size();
  return held;
}

TEST(Match, uses_no_more_memory_after_ten_waves_than_after_one) {
  Match match({ten_easy_waves(), 1, Difficulty::kEasy});
  BotPlayer bot(match);
  const Held first = held_by(match);
  EXPECT_EQ(first.bodies, first.slots);
  size_t waves = 1, most_slots = 0;
  for (Ticks t = 0; t < 200 * kTicksPerSecond && !match.standing().over(); ++t) {
    match.tick(bot.next(match));
    most_slots = std::max(most_slots, held_by(match).slots);
    if (!match.delta().replaced) continue;
    ++waves;
    EXPECT_EQ(held_by(match), first) << "wave " << waves;
  }
  EXPECT_EQ(match.standing().phase, Standing::Phase::kWon);
  EXPECT_EQ(waves, 10u);
  EXPECT_GT(most_slots, first.slots + 20) << "pieces come off in a wave";
}

// How far the centre of mass of a vehicle has risen by its motion since it was lowest.
class Rise {
 public:
  void follow(const World& world, const Vehicle& vehicle) {
    const Body& chassis = world.body(vehicle.chassis);
    const Vec3 centre = rigid_frame(chassis).centre;
    if (before_) height_ += chassis.placement.to_world(centre).y - before_->to_world(centre).y;
    lowest_ = std::min(lowest_, height_);
    before_ = chassis.placement;
  }
  double metres() const { return height_ - lowest_; }

 private:
  std::optional<Placement> before_;
  double height_ = 0, lowest_ = 0;
};

constexpr double kAway = 20;  // m

// An enemy that neither drives nor fires stands before the player.
std::shared_ptr<const Rules> target_practice(double heading) {
  auto rules = std::make_shared<Rules>(*ten_easy_waves());
  rules->waves.resize(1);
  rules->description.laser.radius = {0.01, 0.03};
  rules->arena.description.enemies = {{{0, 0, kAway}, heading}};
  return rules;
}

// The controls that aim from one place at another.
Controls aimed(const Vec3& from, const Vec3& at) {
  const Vec3 way = glm::normalize(at - from);
  Controls controls;
  controls.heading = static_cast<int32_t>(std::lround(heading_of(way) / Controls::kAimStep));
  controls.pitch = static_cast<int32_t>(std::lround(std::asin(way.y) / Controls::kAimStep));
  return controls;
}

// Two points in the plane of the middle of the enemy between which a beam cuts.
std::pair<Vec3, Vec3> random_stroke(Random& random, bool at_wheels) {
  if (at_wheels) {
    const double x = (random.below(2) ? 1 : -1) * random.uniform(0.6, 0.7);
    return {{x, 0.05, kAway}, {x, random.uniform(0.5, 0.9), kAway}};
  }
  const auto somewhere = [&] { return Vec3(random.uniform(-2, 2), random.uniform(0.1, 1.2), kAway); };
  const Vec3 from = somewhere();
  return {from, somewhere()};
}

TEST(Match, a_vehicle_cut_at_rest_does_not_rise) {
  size_t wheels = 0, pieces = 0;
  for (uint64_t seed = 1; seed <= runs(12); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const bool along = seed % 2 == 1;
    Match match({target_practice(along ? 0 : 0.5 * kPi), seed, Difficulty::kEasy});
    Rise rise;
    bool righted = false;
    for (int stroke = 0; stroke < 8; ++stroke) {
      const auto [from, to] = random_stroke(random, along && stroke % 2 == 0);
      const int aiming = 120, cutting = 20 + static_cast<int>(random.below(60));
      for (int t = 0; t < aiming + cutting && !righted; ++t) {
        const double share = std::max(0.0, static_cast<double>(t - aiming) / cutting);
        Controls controls =
            aimed(in_world(match.world(), match.vehicles()[0], {0, 1.6, 0}), from + share * (to - from));
        controls.fire = t >= aiming;
        match.tick(controls);
        for (const Event& event : match.events()) {
          righted = righted || event.kind == Event::Kind::kRighted;
          wheels += event.kind == Event::Kind::kWheelLost;
        }
        rise.follow(match.world(), match.vehicles()[1]);
        ASSERT_LT(rise.metres(), 0.2) << "stroke " << stroke << ", tick " << t;
      }
    }
    pieces += match.standing().pieces;
  }
  EXPECT_GE(wheels, runs(4));
  EXPECT_GE(pieces, runs(24));
}

TEST(Match, is_lost_when_time_runs_out) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  rules->description.times.match = 0.5;
  Match match({rules, 1, Difficulty::kNormal});
  for (int t = 0; t < 100; ++t) match.tick({});
  EXPECT_EQ(match.standing().phase, Standing::Phase::kLost);
  EXPECT_EQ(match.standing().ticks, 60u);
}

TEST(Match, without_enemies_ends_neither_won_nor_lost) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(0, 0));
  rules->description.times.match = 0.5;
  Match match({rules, 1, Difficulty::kNormal});
  for (int t = 0; t < 100; ++t) match.tick({});
  EXPECT_TRUE(match.standing().over());
  EXPECT_EQ(match.standing().phase, Standing::Phase::kEnded);
  EXPECT_EQ(match.standing().ticks, 60u);
}

// Waves of one enemy that neither drives nor fires.
std::shared_ptr<Rules> waves_of_one(size_t waves, double pause) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(waves, 1));
  rules->description.times.between_waves = pause;
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  return rules;
}

TEST(Match, ends_on_the_last_tick_and_not_before) {
  auto rules = waves_of_one(1, 1);
  rules->description.times.match = 1;
  Match match({rules, 1, Difficulty::kNormal});
  for (Ticks t = 0; t + 1 < kTicksPerSecond; ++t) match.tick({});
  EXPECT_FALSE(match.standing().over());
  EXPECT_NEAR(match.seconds_left(), kTick, 1e-9);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Standing::Phase::kLost);
  const Ticks ticks = match.standing().ticks;
  match.tick({});
  EXPECT_EQ(match.standing().ticks, ticks) << "nothing happens any more";
}

// A match in which the player's vehicle falls when it is over.
TEST(Match, continues_after_its_end_until_falling_bodies_land) {
  auto rules = waves_of_one(1, 1);
  rules->description.times.match = 0.1;
  WaveStart start;
  start.player.position = {0, 2, 0};
  Match match({rules, 1, Difficulty::kNormal}, start);
  Controls full;
  full.throttle = Controls::kFull;
  full.fire = true;
  while (!match.standing().over()) match.tick(full);
  const Standing end = match.standing();
  const double height = match.world().body(match.vehicles()[Match::kPlayer].chassis).placement.position.y;
  EXPECT_GT(height, 1);
  for (Ticks t = 0; t < Match::kAftermath; ++t) {
    EXPECT_FALSE(match.settled());
    match.tick(full);
    EXPECT_FALSE(match.vehicles()[Match::kPlayer].gun.firing);
  }
  EXPECT_TRUE(match.settled());
  EXPECT_LT(match.world().body(match.vehicles()[Match::kPlayer].chassis).placement.position.y, height - 1);
  EXPECT_EQ(match.standing().ticks, end.ticks);
  EXPECT_EQ(match.standing().score, end.score);
  EXPECT_EQ(match.standing().pieces, end.pieces);
  EXPECT_EQ(match.standing().phase, end.phase);
  const uint64_t hash = state_hash(match.world());
  match.tick(full);
  EXPECT_EQ(state_hash(match.world()), hash);
}

TEST(Match, ticks_after_its_end_replay_exactly_from_controls) {
  auto rules = waves_of_one(1, 1);
  rules->description.times.match = 1.5;
  const MatchSetup setup{rules, 5, Difficulty::kHard};
  Match match(setup);
  const std::vector<Controls> controls = play(match, 3);
  ASSERT_TRUE(match.standing().over());
  const auto again = match_at(setup, Match(setup).wave_start(), controls, controls.size());
  EXPECT_EQ(again->standing().elapsed(), controls.size());
  EXPECT_EQ(state_hash(again->world()), state_hash(match.world()));
}

// The vehicle is changed behind the back of the match, as no beam does it so quickly.
TEST(Match, is_lost_immediately_when_a_disabled_player_gives_up) {
  Match match({waves_of_one(1, 1), 1, Difficulty::kNormal});
  auto& own = const_cast<Vehicle&>(match.vehicles()[Match::kPlayer]);
  Controls controls;
  controls.give_up = true;
  for (Wheel& wheel : own.wheels) wheel.attached = false;
  EXPECT_FALSE(match.is_disabled()) << "it still fires";
  match.tick(controls);
  EXPECT_FALSE(match.standing().over());
  own.gun.turret_attached = false;
  EXPECT_TRUE(match.is_disabled());
  match.tick(controls);
  EXPECT_EQ(match.standing().phase, Standing::Phase::kLost);
}

TEST(Match, reports_the_start_of_a_wave) {
  Match match({waves_of_one(2, 1), 1, Difficulty::kNormal});
  ASSERT_EQ(match.events().size(), 1u);
  EXPECT_EQ(match.events()[0].kind, Event::Kind::kWaveBegins);
  EXPECT_EQ(match.events()[0].part, 0u);
  EXPECT_TRUE(match.delta().replaced);
  match.tick({});
  EXPECT_TRUE(match.events().empty());
}

TEST(Match, resumes_from_the_start_of_a_wave) {
  const auto rules = waves_of_one(3, 1);
  WaveStart start;
  start.standing.wave = 2;
  start.standing.ticks = 100;
  start.standing.score = 7;
  start.player.position = {3, 0, 4};
  const Match match({rules, 1, Difficulty::kNormal}, start);
  EXPECT_EQ(match.standing().wave, 2u);
  EXPECT_EQ(match.standing().ticks, 100u);
  EXPECT_EQ(match.standing().score, 7);
  EXPECT_EQ(match.world().body(match.vehicles()[Match::kPlayer].chassis).placement.position, Vec3(3, 0, 4));
}

TEST(Match, an_enemy_aims_for_a_while_before_its_first_beam) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  for (EnemySkill& skill : rules->description.skills) skill = {.reaction = 0.1, .fire = 1, .max_firing = 1};
  rules->description.laser.range = 100;
  Match match({rules, 1, Difficulty::kNormal});
  std::optional<double> announced;
  const Gun& gun = match.vehicles()[1].gun;
  while (!gun.firing && match.standing().ticks < 60 * kTicksPerSecond) {
    match.tick({});
    if (match.vehicles()[1].is_announcing() && !announced)
      announced = seconds_of_ticks(match.standing().ticks);
  }
  ASSERT_TRUE(announced && gun.firing);
  EXPECT_NEAR(seconds_of_ticks(match.standing().ticks) - *announced, Match::kWarning, 0.02);
}

}  // namespace
}  // namespace kerf
