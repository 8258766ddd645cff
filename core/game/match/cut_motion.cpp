#include "core/game/match/cut_motion.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/base/assert.h"
#include "core/game/vehicle/vehicle.h"

namespace kerf {

namespace {

constexpr double kMemory = 0.9;                            // of the motion of a cut, per tick with a cut
constexpr double kAcross = 0.8, kAlong = 0.4;              // m/s
constexpr double kTurn = 1.5, kHeavyTurn = 0.5, kTip = 1;  // rad/s
constexpr double kPop = 2, kPopTurn = 4;                   // m/s and rad/s
constexpr double kPopUp = 0.35;                            // fraction of the speed
constexpr double kFoot = 0.1;                              // m, above which a part supports nothing
constexpr double kLies = 0.5;  // sine of the tilt from which a long, thin body lies rather than stands

Vec3 unit_or_zero(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vec3(0);
}

// The centre of mass, roughly: exact sums may lag behind the cuts.
Vec3 centre_of(const Body& body) {
  const Bounds box = body.bounds();
  return body.placement.to_world(0.5 * (box.min + box.max));
}

// Height of the lowest corner of the box [m].
double lowest_of(const Body& body) {
  const Bounds box = body.bounds();
  double lowest = std::numeric_limits<double>::max();
  for (int corner = 0; corner < 8; ++corner) {
    const auto at = [&](int k) { return corner >> k & 1 ? box.max[k] : box.min[k]; };
    lowest = std::min(lowest, body.placement.to_world({at(0), at(1), at(2)}).y);
  }
  return lowest;
}

// Normal of the plane that the beam swept, towards the part. Without a stroke the parts move apart as their
// centres lie.
Vec3 across_cut(const Vec3& apart, const CutTrail* trail) {
  const Vec3 normal = trail ? unit_or_zero(glm::cross(trail->direction, trail->along)) : Vec3(0);
  const double side = glm::dot(normal, apart);
  if (side != 0) return side > 0 ? normal : -normal;
  const Vec3 way = unit_or_zero(apart);
  return way != Vec3(0) ? way : Vec3(0, 1, 0);
}

// The direction from the rest to a part across the cut between them.
Vec3 across_between(const Body& rest, const Body& part, const CutTrail* trail) {
  const Vec3 from = rest.tree.leaf_count() > 0 ? centre_of(rest) : trail ? trail->at : centre_of(part);
  return across_cut(centre_of(part) - from, trail);
}

// Returns the horizontal direction in which a heavy, upright body topples that is at least twice as long as
// wide: at right angles to its length, on the side of stroke and beam. Returns nullopt for other bodies.
std::optional<Vec3> side_to_tip(const Body& body, const CutTrail* trail) {
  const Vec3 size = body.bounds().max - body.bounds().min;
  const bool is_thin_in_x = 2 * size.x <= size.z, is_thin_in_z = 2 * size.z <= size.x;
  if (!trail || mass_of(body) <= kHeavyPart || is_thin_in_x == is_thin_in_z) return std::nullopt;
  const Vec3 thin = body.placement.orientation * (is_thin_in_x ? Vec3(1, 0, 0) : Vec3(0, 0, 1));
  if (std::abs(thin.y) > kLies) return std::nullopt;
  const Vec3 side = horizontal(thin);
  return glm::dot(side, unit_or_zero(trail->along) + trail->direction) < 0 ? -side : side;
}

// Turns a body about a place below it, with its top to the side (unit). Another cut does not turn it faster.
void tip_over(Body& body, const Vec3& about, const Vec3& side) {
  KERF_ASSERT(is_unit(side));
  if (glm::dot(body.motion.spin, glm::cross(Vec3(0, 1, 0), side)) >= 0.5 * kTip) return;
  const Vec3 arm = centre_of(body) - body.placement.position;
  const double height = std::max(0.0, centre_of(body).y - about.y);
  body.motion.wake();
  body.motion.spin = kTip * glm::cross(Vec3(0, 1, 0), side);
  body.motion.velocity = kTip * height * side - glm::cross(body.motion.spin, arm);
}

// Changes the velocity of the centre of mass, and turns the top of a body into the same direction.
void add_motion(Body& body, const Vec3& change, double turn) {
  const Vec3 spin = turn * unit_or_zero(glm::cross(Vec3(0, 1, 0), change));
  body.motion.wake();
  body.motion.velocity += change - glm::cross(spin, centre_of(body) - body.placement.position);
  body.motion.spin += spin;
}

}  // namespace

Vec3 horizontal(const Vec3& v) { return unit_or_zero({v.x, 0, v.z}); }

void CutTrails::record(BodyId body, const Vec3& at, const Vec3& direction) {
  KERF_ASSERT(is_unit(direction));
  const auto [found, is_new] = trails_.try_emplace(body, CutTrail{at, direction, Vec3(0)});
  if (is_new) return;
  CutTrail& trail = found->second;
  const Vec3 way = at - trail.at;
  trail.along = kMemory * trail.along + way - glm::dot(way, direction) * direction;
  trail.at = at;
  trail.direction = direction;
}

const CutTrail* CutTrails::of(BodyId body) const {
  const auto found = trails_.find(body);
  return found == trails_.end() ? nullptr : &found->second;
}

Vec3 part_at_cut(Body& rest, Body& part, const CutTrail* trail, bool moves_rest) {
  if (part.tree.leaf_count() == 0) return {0, 1, 0};
  const Vec3 across = across_between(rest, part, trail);
  const Vec3 along = trail ? unit_or_zero(trail->along) : Vec3(0);
  Vec3 change = kAcross * across + kAlong * along;
  const bool heavy = mass_of(part) > kHeavyPart;
  if (heavy) change = kAcross * horizontal(change);
  add_motion(part, change, heavy ? kHeavyTurn : kTurn);
  if (moves_rest && !rest.pinned && rest.tree.leaf_count() > 0 && mass_of(rest) <= kHeavyPart)
    add_motion(rest, -change, kTurn);
  return across;
}

Vec3 topple(Body& rest, Body& part, const CutTrail* trail) {
  if (part.tree.leaf_count() == 0 || rest.tree.leaf_count() == 0)
    return part_at_cut(rest, part, trail, false);
  const bool is_upper = centre_of(part).y >= centre_of(rest).y;
  // A chip from the middle of a body did not support it.
  if (!is_upper && lowest_of(part) > lowest_of(rest) + kFoot) return part_at_cut(rest, part, trail, false);
  Body &upper = is_upper ? part : rest, &lower = is_upper ? rest : part;
  Vec3 across;
  if (const auto side = side_to_tip(upper, trail)) {
    across = across_between(lower, upper, trail);
    tip_over(upper, trail->at, *side);
  } else {
    across = part_at_cut(lower, upper, trail, mass_of(upper) < kHeavyProp);
  }
  return is_upper ? across : -across;
}

void pop_off(Body& part, const Vec3& outward, const CutTrail* trail) {
  KERF_ASSERT(is_unit(outward));
  if (part.tree.leaf_count() == 0) return;
  const Vec3 along = trail ? unit_or_zero(trail->along) : Vec3(0);
  const Vec3 way = unit_or_zero(outward + Vec3(0, kPopUp, 0) + 0.5 * along);
  add_motion(part, kPop * way, kPopTurn);
}

}  // namespace kerf
