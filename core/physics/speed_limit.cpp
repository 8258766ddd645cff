#include "core/physics/speed_limit.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kFastest = 300;      // m/s, of the points of any body
constexpr double kFastestSpin = 400;  // rad/s

double radius_of(const MovingBody& b) {
  return 0.5 * glm::length(b.collider->bounds.max - b.collider->bounds.min);
}

Vec3 velocity_of_centre(const MovingBody& b, const Vec3& centre) {
  return b.body->motion.velocity_at(centre, b.body->placement);
}

// An upper bound of the speed of all points of a body.
double speed(const MovingBody& b) {
  if (!b.moves()) return 0;
  const Vec3 centre = b.body->placement.to_world(b.frame.centre);
  return glm::length(velocity_of_centre(b, centre)) + radius_of(b) * glm::length(b.body->motion.spin);
}

double share_of(double value, double most) { return value > most ? most / value : 1; }

}  // namespace

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
