#include "core/physics/hold_back.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/assert.h"
#include "core/physics/contact/crossing_sheets.h"

namespace kerf {

namespace {

constexpr std::array kShares{1.0, 0.5, 0.25, 0.0};
constexpr double kMuchHeavier = 4;  // times as heavy

Placement between(const MovingBody& b, double share) {
  KERF_ASSERT(share > 0 && share < 1);
  const Placement from = b.frame.in_world(b.start), to = b.frame.in_world(b.body->placement);
  const double sign = glm::dot(from.orientation, to.orientation) < 0 ? -1 : 1;
  return b.frame.body_at({glm::mix(from.position, to.position, share),
                          glm::normalize((1 - share) * from.orientation + sign * share * to.orientation)});
}

// Puts a body somewhere else, and multiplies the velocity of its centre of mass and its spin.
void slow(const MovingBody& b, const Placement& to, double factor) {
  Motion& motion = b.body->motion;
  Placement& placement = b.body->placement;
  const Vec3 velocity = motion.velocity_at(placement.to_world(b.frame.centre), placement);
  placement = to;
  motion.spin *= factor;
  motion.velocity = factor * velocity + glm::cross(motion.spin, to.position - to.to_world(b.frame.centre));
}

// The ways of all bodies and how much of them they go.
class Ways {
 public:
  explicit Ways(std::span<MovingBody> bodies)
      : bodies_(bodies), share_(bodies.size(), 0), keeps_speed_(bodies.size(), false) {}

  bool cross(uint32_t i, uint32_t j) const { return get_through(bodies_[i], bodies_[j]); }
  bool is_short(uint32_t i) const { return share_[i] > 0; }
  bool shorten(uint32_t i) {
    MovingBody& b = bodies_[i];
    if (!b.moves() || share_[i] + 1 == kShares.size()) return false;
    const double share = kShares[++share_[i]];
    KERF_ASSERT(share < kShares[share_[i] - 1]);
    b.next = share > 0 ? map_of(between(b, share)) : b.now;
    return true;
  }
  // Which of two bodies that cross is to go less far: both, or only one that is much lighter while it goes at
  // all, so that a seat does not hold a car.
  std::vector<uint32_t> to_shorten(uint32_t i, uint32_t j) const {
    KERF_ASSERT(bodies_[i].moves() || bodies_[j].moves());
    for (const auto& [light, heavy] : {std::pair(i, j), std::pair(j, i)}) {
      const MovingBody &a = bodies_[light], &b = bodies_[heavy];
      if (a.moves() && b.moves() && kMuchHeavier * a.frame.mass < b.frame.mass && kShares[share_[light]] > 0)
        return {light};
    }
    return {i, j};
  }
  // Whether one of two bodies is too light to stop the other one.
  bool sweeps_aside(uint32_t i, uint32_t j) const {
    const auto yields = [](const MovingBody& light, const MovingBody& heavy) {
      return !light.fixed && light.frame.mass < heavy.sweeps_aside;
    };
    return yields(bodies_[i], bodies_[j]) || yields(bodies_[j], bodies_[i]);
  }
  // Leaves the velocity of a body to the next tick, which knows what stops it.
  void keep_speed(uint32_t i) { keeps_speed_[i] = true; }
  // Lets the bodies be where they got to. Returns how many did not go all of their way.
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
  std::span<MovingBody> bodies_;
  std::vector<size_t> share_;
  std::vector<bool> keeps_speed_;
};

}  // namespace

size_t hold_back(std::span<MovingBody> bodies, ContactSearch& search) {
  Ways ways(bodies);
  const std::vector<std::pair<uint32_t, uint32_t>> pairs = search.pairs_apart();
  std::vector<bool> changed(bodies.size(), true);
  while (std::find(changed.begin(), changed.end(), true) != changed.end()) {
    std::vector<bool> shortened(bodies.size(), false);
    for (const auto& [i, j] : pairs) {
      if (!changed[i] && !changed[j] && !shortened[i] && !shortened[j]) continue;
      if (!ways.cross(i, j) || !search.were_apart(i, j)) continue;
      if (ways.sweeps_aside(i, j)) {
        search.let_cross(i, j);
        continue;
      }
      if (!ways.is_short(i) && !ways.is_short(j) && search.remember_piercing(i, j)) {
        ways.keep_speed(i);
        ways.keep_speed(j);
      }
      bool goes_on = true;
      while (goes_on && ways.cross(i, j)) {
        goes_on = false;
        for (const uint32_t body : ways.to_shorten(i, j)) {
          if (!ways.shorten(body)) continue;
          shortened[body] = true;
          goes_on = true;
        }
      }
    }
    changed = std::move(shortened);
  }
  return ways.finish();
}

}  // namespace kerf
