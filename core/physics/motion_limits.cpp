#include "core/physics/motion_limits.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/physics/contact/mating.h"
#include "core/physics/contact/penetration.h"

namespace kerf {

namespace {

int widest_axis(std::span<const MovingBody> bodies) {
  Box corners;
  for (const MovingBody& b : bodies) corners.add(b.bounds.min);
  return corners.widest_axis();
}

// Returns true if the bounds of one body on its way overlap those of another in the frame of the other:
// tilted sheets have small bounds in their own frames and large ones in the world. Either may move or stay.
bool meets_in_frame_of(const MovingBody& other, const MovingBody& b) {
  KERF_ASSERT(other.margin >= 0 && b.margin >= 0);
  const double margin = std::min(other.margin, b.margin);
  Box way;
  for (const RigidMap* to : {&other.now, &other.next}) {
    for (const RigidMap* from : {&b.now, &b.next}) {
      way.add(moved(into(*to, *from), b.collider->bounds));
      if (way.wider(margin).overlaps(other.collider->bounds)) return true;
    }
  }
  return false;
}

bool can_touch(const MovingBody& a, const MovingBody& b) {
  return (a.moves() || b.moves()) && !(a.passes_fixed && b.fixed) && !(b.passes_fixed && a.fixed);
}

bool are_near(const MovingBody& a, const MovingBody& b) {
  return can_touch(a, b) && a.bounds.overlaps(b.bounds) && meets_in_frame_of(a, b) && meets_in_frame_of(b, a);
}

constexpr size_t kPairsAtATime = 4;  // pairs per task of a thread

std::pair<uint32_t, uint32_t> key(const TouchingPair& p) { return {p.first, p.second}; }

const PairMemory* memory_of(const ContactMemory& memory, BodyId first, BodyId second) {
  const auto at = std::ranges::lower_bound(memory, std::pair(first, second), {}, &PairMemory::bodies);
  return at != memory.end() && at->bodies() == std::pair(first, second) ? &*at : nullptr;
}

constexpr std::array kShares{1.0, 0.5, 0.25, 0.0};
constexpr double kMuchHeavier = 4;  // times as heavy
constexpr uint32_t kMaxBlock =
    kTicksPerSecond / 4;  // ticks after which the lighter one may intersect the other

Placement between(const MovingBody& b, double share) {
  KERF_ASSERT(share > 0 && share < 1);
  const Placement from = b.frame.in_world(b.start), to = b.frame.in_world(b.body->placement);
  const double sign = glm::dot(from.orientation, to.orientation) < 0 ? -1 : 1;
  return b.frame.body_at({glm::mix(from.position, to.position, share),
                          glm::normalize((1 - share) * from.orientation + sign * share * to.orientation)});
}

// Places a body elsewhere, and scales the velocity of its centre of mass and its spin.
void slow(const MovingBody& b, const Placement& to, double factor) {
  KERF_ASSERT(factor >= 0 && factor <= 1);
  Motion& motion = b.body->motion;
  Placement& placement = b.body->placement;
  const Vec3 velocity = motion.velocity_at(placement.to_world(b.frame.centre), placement);
  placement = to;
  motion.spin *= factor;
  motion.velocity = factor * velocity + glm::cross(motion.spin, to.position - to.to_world(b.frame.centre));
}

// Ways of all bodies and the shares of them that they move.
class Ways {
 public:
  explicit Ways(std::span<MovingBody> bodies)
      : bodies_(bodies), share_(bodies.size(), 0), keeps_speed_(bodies.size(), false) {}

  // Returns true if two bodies intersect or pass through each other on the shares of their ways.
  bool cross(uint32_t i, uint32_t j) const {
    return (goes(i) || goes(j)) && PairGeometry(bodies_[i], bodies_[j]).pass_through();
  }
  bool shorten(uint32_t i) {
    MovingBody& b = bodies_[i];
    if (!b.moves() || share_[i] + 1 == kShares.size()) return false;
    const double share = kShares[++share_[i]];
    KERF_ASSERT(share < kShares[share_[i] - 1]);
    b.next = share > 0 ? map_of(between(b, share)) : b.now;
    return true;
  }
  // Returns which of two crossing bodies must be shortened: both, or only a much lighter one while it moves
  // at all, so that a seat does not stop a car.
  std::vector<uint32_t> to_shorten(uint32_t i, uint32_t j) const {
    KERF_ASSERT(bodies_[i].moves() || bodies_[j].moves());
    const uint32_t light = bodies_[i].frame.mass < bodies_[j].frame.mass ? i : j;
    if (is_uneven(i, j) && kShares[share_[light]] > 0) return {light};
    return {i, j};
  }
  // Returns true if one of two bodies is much lighter than the other, and both can move.
  bool is_uneven(uint32_t i, uint32_t j) const {
    const MovingBody &a = bodies_[i], &b = bodies_[j];
    const auto [light, heavy] = std::minmax(a.frame.mass, b.frame.mass);
    return a.moves() && b.moves() && kMuchHeavier * light < heavy;
  }
  // Returns true if two bodies may intersect: one is too light to stop the other, or must leave the ground.
  bool may_cross(uint32_t i, uint32_t j) const {
    const auto yields = [](const MovingBody& light, const MovingBody& heavy) {
      return !light.fixed && light.frame.mass < heavy.ignored_mass;
    };
    const auto is_sunk = [](const MovingBody& b) {
      return b.moves() && b.sunk > kContactLengths.ground_skin * b.scale;
    };
    const MovingBody &a = bodies_[i], &b = bodies_[j];
    return yields(a, b) || yields(b, a) || is_sunk(a) || is_sunk(b);
  }
  // Keeps the velocity of a body for the next tick, which detects the obstacle.
  void keep_speed(uint32_t i) { keeps_speed_[i] = true; }
  // Applies the final positions. Returns the number of bodies that did not move all of their way.
  size_t finish() {
    size_t held = 0;
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
      if (share_[i] == 0) continue;
      MovingBody& b = bodies_[i];
      const double share = kShares[share_[i]];
      slow(b, share > 0 ? between(b, share) : b.start, keeps_speed_[i] ? 1 : 0.25 + 0.75 * share);
      ++held;
    }
    return held;
  }

 private:
  bool goes(uint32_t i) const { return bodies_[i].moves() && kShares[share_[i]] > 0; }

  std::span<MovingBody> bodies_;
  std::vector<size_t> share_;
  std::vector<bool> keeps_speed_;
};

using Pair = std::pair<uint32_t, uint32_t>;

// Returns for each pair whether `test` holds. Multithreaded.
template <typename Test>
std::vector<uint8_t> test_each(std::span<const Pair> pairs, const Test& test) {
  constexpr size_t kAtATime = 2;
  std::vector<uint8_t> holds(pairs.size());
  for_each_range(pairs.size(), kAtATime, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) holds[p] = test(pairs[p]) ? 1 : 0;
  });
  return holds;
}

template <typename Test>
void keep_only(std::vector<Pair>& pairs, const Test& test) {
  const std::vector<uint8_t> holds = test_each(pairs, test);
  std::vector<Pair> kept;
  for (size_t p = 0; p < pairs.size(); ++p) {
    if (holds[p] != 0) kept.push_back(pairs[p]);
  }
  pairs = std::move(kept);
}

// Holds back the bodies of a tick. After crossing pairs are separated, tests the pairs of shortened bodies
// again.
class Holding {
 public:
  Holding(std::span<MovingBody> bodies, ContactSearch& search)
      : bodies_(bodies), search_(search), ways_(bodies), pairs_(search.pairs_apart()) {}

  size_t hold() {
    std::vector<Pair> crossing = pairs_;
    find_crossing(crossing);
    remember(crossing);
    while (!crossing.empty()) {
      const std::vector<bool> shortened = part(crossing);
      std::erase_if(crossing = pairs_,
                    [&](const Pair& p) { return !shortened[p.first] && !shortened[p.second]; });
      find_crossing(crossing);
    }
    return ways_.finish();
  }

 private:
  // Keeps only the pairs that cross on their ways and must not. Pairs that may cross are not tested again.
  void find_crossing(std::vector<Pair>& pairs) {
    keep_only(pairs, [&](const Pair& p) { return ways_.cross(p.first, p.second); });
    const std::vector<uint8_t> must_not = test_each(pairs, [&](const Pair& p) {
      return !ways_.may_cross(p.first, p.second) &&
             !PairGeometry(bodies_[p.first], bodies_[p.second]).cross();
    });
    std::vector<Pair> let;
    for (size_t p = 0; p < pairs.size(); ++p) {
      if (must_not[p] == 0) let.push_back(pairs[p]);
    }
    for (const Pair& p : let) search_.allow_intersection(p.first, p.second);
    const auto is_let = [&](const Pair& p) { return std::ranges::binary_search(let, p); };
    std::erase_if(pairs, is_let);
    if (!let.empty()) std::erase_if(pairs_, is_let);
  }

  void remember(const std::vector<Pair>& crossing) {
    const std::vector<uint8_t> keeps_speed = search_.remember_piercing(crossing);
    KERF_ASSERT(keeps_speed.size() == crossing.size());
    for (size_t p = 0; p < crossing.size(); ++p) {
      if (keeps_speed[p] == 0) continue;
      ways_.keep_speed(crossing[p].first);
      ways_.keep_speed(crossing[p].second);
    }
  }

  // Shortens the ways of bodies until none of the pairs crosses. Returns the shortened bodies.
  std::vector<bool> part(std::vector<Pair> crossing) {
    std::vector<bool> shortened(bodies_.size(), false);
    while (!crossing.empty()) {
      shorten_once(crossing, shortened);
      keep_only(crossing, [&](const Pair& p) { return ways_.cross(p.first, p.second); });
    }
    return shortened;
  }

  // Shortens the ways of each pair unless one was just shortened for another. Removes pairs that do not
  // move.
  void shorten_once(std::vector<Pair>& crossing, std::vector<bool>& shortened) {
    std::vector<bool> just_now(bodies_.size(), false);
    std::erase_if(crossing, [&](const Pair& p) {
      const auto [i, j] = p;
      if (just_now[i] || just_now[j]) return false;
      for (const uint32_t body : ways_.to_shorten(i, j)) {
        if (ways_.shorten(body)) shortened[body] = just_now[body] = true;
      }
      return !just_now[i] && !just_now[j];
    });
  }

  std::span<MovingBody> bodies_;
  ContactSearch& search_;
  Ways ways_;
  std::vector<Pair> pairs_;  // sorted
};

constexpr double kFastest = 300;      // of the points of any body [m/s]
constexpr double kFastestSpin = 400;  // rad/s

double radius_of(const MovingBody& b) {
  return 0.5 * glm::length(b.collider->bounds.max - b.collider->bounds.min);
}

Vec3 velocity_of_centre(const MovingBody& b, const Vec3& centre) {
  return b.body->motion.velocity_at(centre, b.body->placement);
}

// Returns an upper bound of the speed of all points of a body.
double speed(const MovingBody& b) {
  if (!b.moves()) return 0;
  const Vec3 centre = b.body->placement.to_world(b.frame.centre);
  return glm::length(velocity_of_centre(b, centre)) + radius_of(b) * glm::length(b.body->motion.spin);
}

double share_of(double value, double most) { return value > most ? most / value : 1; }

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies) {
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  if (bodies.empty()) return pairs;
  const int axis = widest_axis(bodies);
  std::vector<uint32_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return bodies[a].bounds.min[axis] < bodies[b].bounds.min[axis];
  });
  for (size_t i = 0; i < order.size(); ++i) {
    const MovingBody& a = bodies[order[i]];
    for (size_t j = i + 1; j < order.size() && bodies[order[j]].bounds.min[axis] <= a.bounds.max[axis]; ++j) {
      if (are_near(a, bodies[order[j]])) pairs.push_back(std::minmax(order[i], order[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TouchingPair ContactSearch::start(uint32_t first, uint32_t second) const {
  KERF_ASSERT(first < second && first < bodies_.size());
  KERF_ASSERT(second < bodies_.size() || second == TouchingPair::kGround);
  const BodyId a = bodies_[first].id, b = second == TouchingPair::kGround ? BodyId{} : bodies_[second].id;
  const PairMemory* old = memory_of(before_, a, b);
  TouchingPair pair{first, second, {}, old ? *old : PairMemory{a, b, {}, {}, {}}};
  if (pair.memory.held > 0) --pair.memory.held;
  if (second != TouchingPair::kGround && (!old || old->crossed))
    pair.memory.crossed = PairGeometry(bodies_[first], bodies_[second]).cross() ? pair.memory.crossed + 1 : 0;
  return pair;
}

const TouchingPair* ContactSearch::find(uint32_t first, uint32_t second) const {
  const auto at = std::ranges::lower_bound(pairs_, std::pair(first, second), {}, key);
  return at != pairs_.end() && key(*at) == std::pair(first, second) ? &*at : nullptr;
}

TouchingPair& ContactSearch::pair_of(uint32_t first, uint32_t second) {
  KERF_ASSERT(first < second && second < bodies_.size());
  const auto at = std::ranges::lower_bound(pairs_, std::pair(first, second), {}, key);
  if (at != pairs_.end() && key(*at) == std::pair(first, second)) return *at;
  return *pairs_.insert(at, start(first, second));
}

void ContactSearch::find() {
  KERF_ASSERT(std::is_sorted(bodies_.begin(), bodies_.end(),
                             [](const MovingBody& a, const MovingBody& b) { return a.id < b.id; }));
  std::vector<TouchingPair> found = pairs_to_test();
  for_each_range(found.size(), kPairsAtATime, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) look_at(found[i]);
  });
  std::erase_if(
      found, [](const TouchingPair& p) { return p.second == TouchingPair::kGround && p.contacts.empty(); });
  const auto known = static_cast<ptrdiff_t>(pairs_.size());
  pairs_.insert(pairs_.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  std::ranges::inplace_merge(pairs_, pairs_.begin() + known, {}, key);
}

std::vector<TouchingPair> ContactSearch::pairs_to_test() {
  const std::vector<std::pair<uint32_t, uint32_t>> near = near_pairs(bodies_);
  candidates_ += near.size();
  std::vector<TouchingPair> pairs;
  auto next = near.begin();
  for (uint32_t i = 0; i < bodies_.size(); ++i) {
    for (; next != near.end() && next->first == i; ++next) {
      if (!find(i, next->second) && !are_joined(joints_, i, next->second))
        pairs.push_back({i, next->second, {}, {}});
    }
    if (bodies_[i].moves() && !find(i, TouchingPair::kGround))
      pairs.push_back({i, TouchingPair::kGround, {}, {}});
  }
  KERF_ASSERT(next == near.end());
  return pairs;
}

void ContactSearch::look_at(TouchingPair& pair) const {
  pair = start(pair.first, pair.second);
  const MovingBody& first = bodies_[pair.first];
  pair.contacts = pair.second == TouchingPair::kGround
                      ? find_ground_contacts(first, around_, kContactLengths, pair.memory)
                      : PairGeometry(first, bodies_[pair.second]).contacts(pair.memory);
}

std::vector<std::pair<uint32_t, uint32_t>> ContactSearch::pairs_apart() const {
  std::vector<std::pair<uint32_t, uint32_t>> pairs = near_pairs(bodies_);
  std::erase_if(pairs, [&](const std::pair<uint32_t, uint32_t>& p) {
    const TouchingPair* pair = find(p.first, p.second);
    return (pair && pair->memory.crossed > 0) || are_joined(joints_, p.first, p.second);
  });
  return pairs;
}

std::vector<uint8_t> ContactSearch::remember_piercing(std::span<const std::pair<uint32_t, uint32_t>> pairs) {
  for (const auto& [first, second] : pairs) pair_of(first, second);
  std::vector<uint8_t> any_new(pairs.size());
  for_each_range(pairs.size(), kPairsAtATime, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) any_new[p] = remember_piercing(pairs[p].first, pairs[p].second);
  });
  return any_new;
}

bool ContactSearch::remember_piercing(uint32_t first, uint32_t second) {
  PairMemory& memory = pair_of(first, second).memory;
  const PairGeometry pair(bodies_[first], bodies_[second]);
  const MovingBody &a = pair.first(), &b = pair.second();
  const bool of_first = remember_piercing_points(a, b, memory.points_of_first);
  const bool of_second = remember_piercing_points(b, a, memory.points_of_second);
  remember_passing_guards(a, b, memory.points_of_first);
  remember_passing_guards(b, a, memory.points_of_second);
  const bool held_before = memory.held > 0;
  memory.held = 2;
  return (of_first || of_second) && !held_before;
}

size_t limit_penetration(std::span<MovingBody> bodies, ContactSearch& search) {
  return Holding(bodies, search).hold();
}

SpeedLimit::SpeedLimit(std::span<const MovingBody> bodies, std::span<const TouchingPair> pairs,
                       std::span<const BodyJoint> joints, double gain) {
  KERF_ASSERT(gain >= 0);
  std::vector<double> before;
  for (const MovingBody& b : bodies) before.push_back(speed(b));
  most_ = before;
  const auto meet = [&](uint32_t a, uint32_t b) {
    most_[a] = std::max(most_[a], before[b]);
    most_[b] = std::max(most_[b], before[a]);
  };
  for (const TouchingPair& p : pairs) {
    if (p.second != TouchingPair::kGround && !p.contacts.empty()) meet(p.first, p.second);
  }
  for (const BodyJoint& j : joints) meet(j.first, j.second);
  for (size_t i = 0; i < bodies.size(); ++i) most_[i] = std::min(most_[i] + gain, kFastest * bodies[i].metre);
}

void SpeedLimit::apply(std::span<MovingBody> bodies) const {
  KERF_ASSERT(bodies.size() == most_.size());
  for (size_t i = 0; i < bodies.size(); ++i) {
    const MovingBody& b = bodies[i];
    if (!b.moves()) continue;
    Motion& motion = b.body->motion;
    const Vec3 centre = b.body->placement.to_world(b.frame.centre);
    Vec3 velocity = velocity_of_centre(b, centre);
    velocity *= share_of(glm::length(velocity), most_[i]);
    const double spin = glm::length(motion.spin);
    motion.spin *= share_of(spin, std::min(2 * most_[i] / radius_of(b), kFastestSpin));
    motion.velocity = velocity + glm::cross(motion.spin, b.body->placement.position - centre);
  }
}

}  // namespace kerf
