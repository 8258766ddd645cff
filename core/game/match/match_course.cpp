#include <algorithm>

#include "core/base/angle.h"
#include "core/game/match/match.h"
#include "core/game/match/recover.h"
#include "core/game/vehicle/vehicle_bodies.h"

namespace kerf {

namespace {

constexpr size_t kMostLoose = 200;  // bodies, those of the arena among them
constexpr Ticks kClearEvery = kTicksPerSecond / 10;

}  // namespace

void Match::recover() {
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    if (!recover_vehicle(world_, vehicles_[v], space_, rules().description.times)) continue;
    Delta moved;
    moved.moved = all_bodies(vehicles_[v]);
    follow(std::move(moved));
    tell({Event::Kind::kRighted, v, Event::kNobody, 0, vehicles_[v].chassis,
          world_.body(vehicles_[v].chassis).placement.position});
  }
}

// Where too much lies about, the smallest pieces that lie still go, but nothing of the arena.
void Match::clear_debris() {
  if (standing_.ticks % kClearEvery != 0) return;
  struct Resting {
    double size;
    BodyId id;
  };
  std::vector<Resting> resting;
  size_t all = 0;
  for (const BodyId id : world_.ids()) {
    const Body& body = world_.body(id);
    if (body.pinned || vehicle_of(id) != Event::kNobody) continue;
    ++all;
    if (std::find(arena_.begin(), arena_.end(), id) != arena_.end()) continue;
    const AabbTree::Box box = body.tree.bounds();
    if (body.motion.asleep) resting.push_back({glm::length(box.max - box.min), id});
  }
  if (all <= kMostLoose) return;
  const size_t going = std::min(all - kMostLoose, resting.size());
  std::stable_sort(resting.begin(), resting.end(),
                   [](const Resting& a, const Resting& b) { return a.size < b.size; });
  std::vector<BodyId> ids;
  for (size_t i = 0; i < going; ++i) ids.push_back(resting[i].id);
  remove(ids);
}

void Match::remove(const std::vector<BodyId>& bodies) {
  if (bodies.empty()) return;
  for (const BodyId id : bodies) world_.remove(id);
  Delta change;
  change.went = bodies;
  follow(std::move(change));
}

void Match::judge() {
  using Phase = Standing::Phase;
  if (standing_.phase == Phase::kPause) {
    if (--standing_.pause_left > 0) return;
    const Body& chassis = world_.body(vehicles_[kPlayer].chassis);
    return begin_wave(standing_.wave + 1, upright(chassis.placement, rules().arena.description.ground));
  }
  if (!vehicles_[kPlayer].alive || seconds_left() <= 0) {
    const bool sandbox = rules().waves.empty() && vehicles_[kPlayer].alive;
    standing_.phase = sandbox ? Phase::kEnded : Phase::kLost;
    if (!sandbox) tell({Event::Kind::kLost});
    return;
  }
  const auto lives = [&](size_t v) { return vehicles_[v].alive; };
  if (enemies_.empty() || std::any_of(enemies_.begin(), enemies_.end(), lives)) return;
  tell({Event::Kind::kWaveCleared, Event::kNobody, Event::kNobody, standing_.wave});
  if (standing_.wave + 1 == rules().waves.size()) {
    standing_.phase = Phase::kWon;
    return tell({Event::Kind::kWon});
  }
  standing_.phase = Phase::kPause;
  standing_.pause_left = static_cast<Ticks>(rules().description.times.between_waves * kTicksPerSecond) + 1;
}

}  // namespace kerf
