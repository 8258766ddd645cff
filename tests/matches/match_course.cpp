#include "tests/matches/match_course.h"

#include <algorithm>
#include <set>
#include <vector>

#include "core/base/ids.h"
#include "core/game/match/cut_motion.h"
#include "core/game/match/match.h"

namespace kerf {

namespace {

constexpr double kAway = 1;  // m

// How long a vehicle has wanted to drive and stayed where it was.
class Standstill {
 public:
  void follow(const Match& match) {
    const Vehicle& own = match.vehicles()[Match::kPlayer];
    const Vec3 at = match.world().body(own.chassis).placement.position;
    const bool wants = std::abs(own.controls.throttle) > Controls::kFull / 5 && own.can_drive() && own.alive;
    if (!anchor_ || !wants || glm::distance(*anchor_, at) > kAway) {
      anchor_ = at;
      since_ = 0;
    }
    since_ += kTick;
    longest_ = std::max(longest_, since_);
  }
  double longest() const { return longest_; }

 private:
  std::optional<Vec3> anchor_;
  double since_ = 0, longest_ = 0;
};

// Follows parts from the tick in which they came off.
class PartsOff {
 public:
  void follow(const Match& match, MatchCourse& course) {
    const World& world = match.world();
    const Ticks now = match.standing().ticks;
    note_touches(world);
    for (const Part& part : parts_) {
      if (part.due > now || !world.contains(part.id) || !world.contains(part.rest)) continue;
      MovedParts& parts = part.is_heavy ? course.heavy_parts : course.parts;
      const bool moved = glm::distance(place(world, part.id, part.rest), part.from) >= kMoved;
      ++parts.all;
      parts.moved += moved;
      parts.held += !moved && part.is_touched;
    }
    std::erase_if(parts_, [&](const Part& part) { return part.due <= now; });
    for (const Detached& d : match.delta().detached) {
      if (!world.contains(d.to) || !world.contains(d.from)) continue;
      const bool is_heavy = mass_of(world.body(d.to)) > kHeavyPart;
      parts_.push_back(
          {d.to, d.from, place(world, d.to, d.from), now + (is_heavy ? kHeavyDue : kDue), is_heavy});
    }
  }

 private:
  static constexpr double kMoved = 0.05;  // m
  static constexpr Ticks kDue = kTicksPerSecond * 3 / 10, kHeavyDue = 2 * kTicksPerSecond;
  struct Part {
    BodyId id, rest;
    Vec3 from;
    Ticks due;
    bool is_heavy;
    bool is_touched = false;  // whether another body or the ground touched the part since
  };
  // The centre of a body in the frame of another one.
  static Vec3 place(const World& world, BodyId part, BodyId rest) {
    const Body& body = world.body(part);
    return world.body(rest).placement.to_body(middle_of(body));
  }

  void note_touches(const World& world) {
    for (const PairMemory& pair : world.contact_memory()) {
      if (!pair.touching && pair.crossed == 0) continue;
      for (Part& part : parts_) part.is_touched |= part.id == pair.first || part.id == pair.second;
    }
  }

  std::vector<Part> parts_;
};

void record_events(const Match& match, double now, MatchCourse& course) {
  std::set<size_t> dying, beams;
  for (const Event& event : match.events()) {
    if (event.kind == Event::Kind::kVitalLost) {
      dying.insert(event.vehicle);
      beams.insert(event.by);
    }
    const bool own = event.vehicle == Match::kPlayer, enemy = !own && event.vehicle != Event::kNobody;
    const bool cuts = event.kind == Event::Kind::kCut && event.by == Match::kPlayer;
    if (enemy && cuts && !course.first_cut) course.first_cut = now;
    if (own && event.kind == Event::Kind::kCut && !course.first_hit) course.first_hit = now;
    if (own && event.kind == Event::Kind::kKilled && !course.first_death) course.first_death = now;
    const bool part = event.kind == Event::Kind::kPieceOff || event.kind == Event::Kind::kWheelLost;
    if (part && event.by == Match::kPlayer && !course.first_part) course.first_part = now;
  }
  if (beams.size() > 1) course.kills_at_once = std::max(course.kills_at_once, dying.size());
}

}  // namespace

bool outlives(const MatchCourse& course, double seconds) {
  return !course.first_hit || !course.first_death || *course.first_death - *course.first_hit >= seconds;
}

MatchCourse play_course(const MatchSetup& setup, MatchDriver driver, double seconds) {
  Match match(setup);
  BotPlayer bot(match);
  MatchCourse course;
  Standstill standstill;
  PartsOff parts_off;
  const auto ticks = static_cast<Ticks>(seconds * kTicksPerSecond);
  while (match.standing().ticks < ticks && !match.standing().over()) {
    match.tick(driver == MatchDriver::kBot ? bot.next(match) : Controls{});
    const double now = seconds_of_ticks(match.standing().ticks);
    if (match.strokes() > 0 && !course.first_beam) course.first_beam = now;
    record_events(match, now, course);
    standstill.follow(match);
    parts_off.follow(match, course);
  }
  const Standing& standing = match.standing();
  course.won = standing.phase == Standing::Phase::kWon;
  course.lost = standing.phase == Standing::Phase::kLost;
  course.seconds = seconds_of_ticks(standing.ticks);
  course.score = standing.score;
  course.enemies_destroyed = standing.enemies_destroyed;
  course.wave = standing.wave + 1;
  course.longest_without_way = standstill.longest();
  return course;
}

}  // namespace kerf
