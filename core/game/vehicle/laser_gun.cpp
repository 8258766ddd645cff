#include "core/game/vehicle/laser_gun.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/tick.h"
#include "core/cut/cut_step.h"
#include "core/game/vehicle/vehicle.h"

namespace kerf {

namespace {

constexpr double kYawSpeed = 4.5, kPitchSpeed = 3;  // rad/s
constexpr double kMinEnergy = 0.05;                 // to switch the beam on

}  // namespace

void aim(const World& world, Vehicle& vehicle) {
  if (!vehicle.alive || !vehicle.gun.works()) return;
  Gun& gun = vehicle.gun;
  const TurretDescription& turret = vehicle.what().turret;
  const Vec3 wanted = direction_of(vehicle.controls.heading * Controls::kAimStep,
                                   vehicle.controls.pitch * Controls::kAimStep);
  const Vec3 local = glm::conjugate(world.body(vehicle.chassis).placement.orientation) * wanted;
  const double yaw = std::clamp(heading_of(local), turret.yaw.low, turret.yaw.high);
  const bool all_around = turret.yaw.high - turret.yaw.low > 2 * kPi - 1e-3;
  const double way = all_around ? wrapped(yaw - gun.yaw) : yaw - gun.yaw;
  gun.yaw += std::clamp(way, -kYawSpeed * kTick, kYawSpeed * kTick);
  if (all_around) gun.yaw = wrapped(gun.yaw);
  const double pitch = std::clamp(pitch_of(local), turret.barrel.pitch.low, turret.barrel.pitch.high);
  gun.pitch += std::clamp(pitch - gun.pitch, -kPitchSpeed * kTick, kPitchSpeed * kTick);
}

bool trigger(Vehicle& vehicle, double speed, const LaserRules& rules) {
  Gun& gun = vehicle.gun;
  const double width = static_cast<double>(vehicle.controls.width) / Controls::kFull;
  const double least = gun.firing ? 0 : kMinEnergy;
  gun.firing = vehicle.alive && vehicle.controls.fire && gun.works() && !gun.overheated && gun.energy > least;
  if (!gun.firing) gun.last.reset();
  gun.radius = rules.radius.low + width * (rules.radius.high - rules.radius.low);
  const double effort = gun.firing ? 0.6 + 0.8 * width : 0;
  const double driving = std::min(speed / LaserRules::kDriving, 1.0);
  const double charge = rules.charge + driving * (rules.charge_driving - rules.charge);
  gun.energy += kTick * (gun.firing ? -rules.drain * effort : charge);
  gun.heat += kTick * (gun.firing ? rules.heating * effort : -rules.cooling);
  gun.energy = std::clamp(gun.energy, 0.0, 1.0);
  gun.heat = std::clamp(gun.heat, 0.0, 1.0);
  if (gun.overheated && gun.heat < rules.cooled) gun.overheated = false;
  if (gun.heat < 1 || gun.overheated) return false;
  gun.overheated = true;
  return true;
}

namespace {

// How far a removed face may extend beyond the beam: in radii, and at least in metres.
constexpr double kTolerance = 1.2, kMinTolerance = 0.02;
constexpr double kHeatWidth = 0.025;  // m, next to a cut; a few faces
constexpr double kStep = 6;           // radii, maximum motion of a point of the beam in one move

CutSettings cut_settings(double radius, double length) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, length};
  settings.resolution.scheme = Scheme::kLongestEdge;
  settings.resolution.rule = Resolution::Rule::kTolerance;
  settings.resolution.tolerance = std::max(kTolerance * radius, kMinTolerance);
  settings.max_faces = kMaxFacesOfTarget;
  settings.heat_width = kHeatWidth;
  return settings;
}

// Returns a move along the same beams with the advanced origin slid back along its beam until it is level
// with the other one. The ends of a beam that moves along itself and sideways at once are wider for
// touching than for removing (see SweptCylinder): faces there would be split endlessly. So the beam ends
// slightly before a wall.
BeamMove without_advance(BeamMove move) {
  const Vec3 axis = glm::normalize(move.from.direction + move.to.direction);
  const double advance = glm::dot(move.to.origin - move.from.origin, axis);
  Pose& front = advance > 0 ? move.to : move.from;
  front.origin -= std::abs(advance) / glm::dot(front.direction, axis) * front.direction;
  return move;
}

// The moves of the beam through a body, in its frame, without those that miss it.
std::vector<BeamMove> moves_through(const Sight::Near& near, const Pose& from, const Placement& then,
                                    const Pose& to, const CutSettings& settings) {
  const Placement& now = near.body->placement;
  const BeamMove whole{then.to_body(from), now.to_body(to), 0};
  const Vec3 centre = now.to_body(near.centre);
  const double radius = settings.laser.radius, range = settings.laser.range.high;
  const double reach = std::min(range, glm::distance(whole.to.origin, centre) + near.radius);
  const auto passes_by = [&](const BeamMove& m) {
    const double drift =
        glm::distance(m.from.origin, m.to.origin) + reach * glm::distance(m.from.direction, m.to.direction);
    return !passes_near(m.from, range, centre, near.radius, drift + radius);
  };
  if (passes_by(whole)) return {};
  std::vector<BeamMove> moves = subdivide(whole, kStep * radius, reach);
  std::erase_if(moves, passes_by);
  for (BeamMove& move : moves) move = without_advance(move);
  return moves;
}

// The change of a body by a failed cut: its delta is lost, so that observers must reload the world.
StepResult unknown_change(BodyId id) {
  StepResult result;
  result.delta.replaced = true;
  result.delta.bodies.emplace_back().body = id;
  return result;
}

}  // namespace

std::map<BodyId, StepResult> fire(World& world, Vehicle& vehicle, const Sight& sight,
                                  const std::function<bool(BodyId)>& cuttable, const LaserRules& rules,
                                  const PlacementsBefore& before) {
  Gun& gun = vehicle.gun;
  KERF_ASSERT(gun.firing && gun.works());
  const Pose now = muzzle_pose(world, vehicle), last = gun.last.value_or(now);
  const auto wall = sight.nearest(now, rules.range, [&](BodyId id) { return !cuttable(id); });
  gun.length = wall ? wall->length : rules.range;
  const CutSettings settings = cut_settings(gun.radius, gun.length);
  std::map<BodyId, StepResult> cut;
  for (const Sight::Near& near : sight.bodies()) {
    if (vehicle.has(near.id) || !cuttable(near.id) || near.body->mesh.live_faces() > kMaxFacesOfTarget)
      continue;
    const auto then = before.find(near.id);
    const Placement& was = gun.last && then != before.end() ? then->second : near.body->placement;
    const std::vector<BeamMove> moves = moves_through(near, last, was, now, settings);
    if (moves.empty()) continue;
    Result<StepResult> done = cut_apart(world, settings, near.id, moves);
    if (!done) done = unknown_change(near.id);
    if (!done->delta.empty()) cut.emplace(near.id, std::move(*done));
  }
  gun.last = now;
  return cut;
}

}  // namespace kerf
