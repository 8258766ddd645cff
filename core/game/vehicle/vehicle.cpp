#include "core/game/vehicle/vehicle.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/joints/joined_parts.h"

namespace kerf {

size_t Vehicle::wheels_attached() const {
  return static_cast<size_t>(
      std::count_if(wheels.begin(), wheels.end(), [](const Wheel& w) { return w.attached; }));
}

bool Vehicle::can_drive() const {
  for (size_t i = 0; i < wheels.size(); ++i) {
    if (wheels[i].attached && what().wheels[i].driven) return true;
  }
  return false;
}

bool Vehicle::is_announcing() const {
  return alive && gun.works() && gun.warning_s > 0 && !gun.announced && !gun.firing;
}

bool Vehicle::has(BodyId body) const {
  if (body == chassis) return true;
  if (gun.turret_attached && body == gun.turret) return true;
  if (gun.turret_attached && gun.barrel_attached && body == gun.barrel) return true;
  return std::any_of(wheels.begin(), wheels.end(),
                     [&](const Wheel& w) { return w.attached && w.body == body; });
}

bool Vehicle::is_made_of(const Body& body) const {
  const BodyId id = body.loaded_as;
  return id == chassis || id == gun.turret || id == gun.barrel ||
         std::any_of(wheels.begin(), wheels.end(), [&](const Wheel& w) { return w.body == id; });
}

namespace {

Placement combined(const Placement& outer, const Placement& inner) {
  return {outer.to_world(inner.position), glm::normalize(outer.orientation * inner.orientation)};
}

Placement rotated_about(const Vec3& point, const glm::dquat& turn) { return {point - turn * point, turn}; }

BodyId add(World& world, const VehicleBody& model, const Placement& placement, uint32_t generation,
           Delta& delta) {
  const BodyId id = add_body(world, model, generation);
  world.body(id).placement = placement;
  delta.created.push_back(id);
  return id;
}

Placement wheel_placement(const Vehicle& vehicle, size_t i) {
  const Wheel& wheel = vehicle.wheels[i];
  const Vec3& hub = vehicle.what().wheels[i].hub;
  const glm::dquat turn = axis_angle({0, 1, 0}, wheel.steer) * axis_angle({1, 0, 0}, wheel.angle);
  Placement local = rotated_about(hub, turn);
  local.position.y += wheel.rise;
  return local;
}

Placement turret_placement(const Vehicle& vehicle) {
  return rotated_about(vehicle.what().turret.pivot, axis_angle({0, 1, 0}, vehicle.gun.yaw));
}

Placement barrel_placement(const Vehicle& vehicle) {
  const Vec3& pivot = vehicle.what().turret.barrel.pivot;
  return combined(turret_placement(vehicle), rotated_about(pivot, axis_angle({1, 0, 0}, -vehicle.gun.pitch)));
}

// `spin` [rad/s, in the world]: rotation of the body relative to the chassis, about a point of the world.
void place(World& world, BodyId id, const Body& chassis, const Placement& local, const Vec3& spin,
           const Vec3& about) {
  Body& body = world.body(id);
  body.placement = combined(chassis.placement, local);
  body.motion = chassis.motion;
  body.motion.spin += spin;
  body.motion.velocity = chassis.motion.velocity_at(body.placement.position, chassis.placement) +
                         glm::cross(spin, body.placement.position - about);
}

constexpr double kYawSpeed = 4.5, kPitchSpeed = 3;  // rad/s
constexpr double kMinEnergy = 0.05;                 // to switch the beam on

// How far a removed face may extend beyond the beam: in radii, and at least in metres.
constexpr double kTolerance = 1.2, kMinTolerance = 0.02;
constexpr double kHeatWidth = 0.025;  // m, next to a cut; a few faces

constexpr double kMaxBeamStep = 6;  // radii, maximum motion of a point of the beam in one move

CutSettings cut_settings(double radius, double length) {
  KERF_ASSERT(radius > 0 && length >= 0);
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
  std::vector<BeamMove> moves = subdivide(whole, kMaxBeamStep * radius, reach);
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

// The remaining area of the groups of a watch in a body.
class Rest {
 public:
  Rest(const World& world, BodyId id, const FaceWatch& watch)
      : watch_(watch), left_(watch.areas_in(world.body(id))) {}
  bool works(size_t group) const {
    KERF_ASSERT(group < left_.size());
    return left_[group] >= kMinPart * watch_.area(group);
  }
  double share(size_t group) const {
    KERF_ASSERT(group < left_.size() && watch_.area(group) > 0);
    return left_[group] / watch_.area(group);
  }

 private:
  const FaceWatch& watch_;
  std::vector<double> left_;
};

// Returns true if enough of a carried body and of its seat is left.
bool holds(const World& world, BodyId id, const VehicleBody& model) {
  const Rest rest(world, id, model.watch);
  return rest.works(VehicleModel::kAll) && rest.works(VehicleModel::kSeat);
}

void assess_wheels(const World& world, Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  const VehicleModel& model = *vehicle.model;
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    Wheel& wheel = vehicle.wheels[i];
    if (!wheel.attached) continue;
    const bool mounted = wheel.replaced || chassis.works(model.wheel_mount(i));
    if (mounted && holds(world, wheel.body, model.wheels[i])) continue;
    wheel.attached = wheel.grounded = false;
    damage.wheels.push_back(i);
  }
}

void assess_gun(const World& world, Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  const VehicleModel& model = *vehicle.model;
  Gun& gun = vehicle.gun;
  if (!gun.turret_attached) return;
  damage.turret = !chassis.works(model.turret_mount()) || !holds(world, gun.turret, model.turret);
  if (gun.barrel_attached) {
    const bool seat = Rest(world, gun.turret, model.turret.watch).works(VehicleModel::kBarrelSeat);
    damage.barrel = damage.turret || !seat || !holds(world, gun.barrel, model.barrel);
  }
  gun.turret_attached = !damage.turret;
  gun.barrel_attached = gun.barrel_attached && !damage.barrel;
  if (!gun.works()) gun.firing = false;
}

void assess_vitals(Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  KERF_ASSERT(vehicle.vital_left.size() == vehicle.vital_works.size());
  for (size_t i = 0; i < vehicle.vital_works.size(); ++i) {
    vehicle.vital_left[i] = chassis.share(vehicle.model->vital(i));
    if (!vehicle.vital_works[i] || vehicle.vital_left[i] >= vehicle.min_vital) continue;
    vehicle.vital_works[i] = false;
    damage.vitals.push_back(i);
  }
}

void assess_tank(Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  if (!vehicle.what().tank || !vehicle.tank_whole) return;
  vehicle.tank_whole = chassis.share(vehicle.model->tank()) >= kTankWhole;
  damage.tank = !vehicle.tank_whole;
}

constexpr double kReach = 0.8, kMoreReach = 0.07;  // m at kCrash, and m per m/s above it
constexpr double kMaxReach = 1.6;                  // m

}  // namespace

Vehicle add_vehicle(World& world, const std::shared_ptr<const VehicleModel>& model,
                    const Placement& placement, uint32_t generation, Delta& delta) {
  KERF_ASSERT(model);
  Vehicle vehicle;
  vehicle.model = model;
  vehicle.chassis = add(world, model->chassis, placement, generation, delta);
  for (const VehicleBody& wheel : model->wheels)
    vehicle.wheels.emplace_back().body = add(world, wheel, placement, generation, delta);
  vehicle.gun.turret = add(world, model->turret, placement, generation, delta);
  vehicle.gun.barrel = add(world, model->barrel, placement, generation, delta);
  vehicle.vital_works.assign(vehicle.what().vitals.size(), true);
  vehicle.vital_left.assign(vehicle.what().vitals.size(), 1);
  vehicle.controls.heading =
      static_cast<int32_t>(heading_of(placement.orientation * Vec3(0, 0, 1)) / Controls::kAimStep);
  place_carried(world, vehicle);
  return vehicle;
}

void replace_wheel(World& world, Vehicle& vehicle, size_t index, uint32_t generation, Delta& delta) {
  KERF_ASSERT(index < vehicle.wheels.size() && !vehicle.wheels[index].attached);
  Wheel& wheel = vehicle.wheels[index];
  wheel = {};
  wheel.replaced = true;
  wheel.body =
      add(world, vehicle.model->wheels[index], world.body(vehicle.chassis).placement, generation, delta);
  place_carried(world, vehicle);
}

std::vector<BodyId> carried_bodies(const Vehicle& vehicle) {
  std::vector<BodyId> ids;
  for (const Wheel& wheel : vehicle.wheels) {
    if (wheel.attached) ids.push_back(wheel.body);
  }
  if (vehicle.gun.turret_attached) {
    ids.push_back(vehicle.gun.turret);
    if (vehicle.gun.barrel_attached) ids.push_back(vehicle.gun.barrel);
  }
  return ids;
}

std::vector<BodyId> all_bodies(const Vehicle& vehicle) {
  std::vector<BodyId> ids = carried_bodies(vehicle);
  ids.push_back(vehicle.chassis);
  return ids;
}

void place_carried(World& world, const Vehicle& vehicle) {
  const Body& chassis = world.body(vehicle.chassis);
  const Vec3 axis = chassis.placement.orientation * Vec3(1, 0, 0);
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const Wheel& wheel = vehicle.wheels[i];
    if (!wheel.attached) continue;
    const Vec3 hub = chassis.placement.to_world(vehicle.what().wheels[i].hub + Vec3(0, wheel.rise, 0));
    place(world, wheel.body, chassis, wheel_placement(vehicle, i), wheel.rate * axis, hub);
  }
  const Gun& gun = vehicle.gun;
  if (!gun.turret_attached) return;
  place(world, gun.turret, chassis, turret_placement(vehicle), Vec3(0), Vec3(0));
  if (gun.barrel_attached) place(world, gun.barrel, chassis, barrel_placement(vehicle), Vec3(0), Vec3(0));
}

Pose muzzle_pose(const World& world, const Vehicle& vehicle) {
  KERF_ASSERT(vehicle.gun.works());
  const Placement& placement = world.body(vehicle.gun.barrel).placement;
  return {placement.to_world(vehicle.what().turret.barrel.muzzle),
          glm::normalize(placement.orientation * Vec3(0, 0, 1))};
}

Pose moved_aside(Pose pose, double aside) {
  if (aside == 0) return pose;
  const Vec3 right = glm::cross(pose.direction, Vec3(0, 1, 0));
  const double length = glm::length(right);
  if (length > 0) pose.origin += aside / length * right;
  return pose;
}

Vec3 in_world(const World& world, const Vehicle& vehicle, const Vec3& point) {
  return world.body(vehicle.chassis).placement.to_world(point);
}

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

std::map<BodyId, StepResult> fire(World& world, Vehicle& vehicle, const Sight& sight,
                                  const std::function<bool(BodyId)>& cuttable, const LaserRules& rules,
                                  const PlacementsBefore& before, double aside) {
  Gun& gun = vehicle.gun;
  KERF_ASSERT(gun.firing && gun.works());
  const Pose muzzle = muzzle_pose(world, vehicle);
  const Pose now = moved_aside(muzzle, aside), last = moved_aside(gun.last.value_or(muzzle), aside);
  const auto wall = sight.nearest(now, rules.range, [&](BodyId id) { return !cuttable(id); });
  const double length = wall ? wall->length : rules.range;
  const CutSettings settings = cut_settings(gun.radius, length);
  std::map<BodyId, StepResult> cut;
  for (const Sight::Near& near : sight.bodies()) {
    if (vehicle.has(near.id) || !cuttable(near.id) || near.body->mesh.live_faces() > kMaxFacesOfTarget)
      continue;
    const auto then = before.find(near.id);
    const Placement& was = gun.last && then != before.end() ? then->second : near.body->placement;
    const std::vector<BeamMove> moves = moves_through(near, last, was, now, settings);
    if (moves.empty()) continue;
    Result<StepResult> done = cut_without_separation(world, settings, near.id, moves);
    if (!done) done = unknown_change(near.id);
    if (!done->delta.empty()) cut.emplace(near.id, std::move(*done));
  }
  if (aside != 0) return cut;
  gun.length = length;
  gun.last = now;
  return cut;
}

double area_of(const Body& body) {
  double area = 0;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) area += body.pieces[p].area;
  return area;
}

Damage assess_damage(const World& world, Vehicle& vehicle) {
  KERF_ASSERT(vehicle.model && vehicle.model->chassis_area > 0);
  Damage damage;
  const Rest chassis(world, vehicle.chassis, vehicle.model->chassis.watch);
  assess_wheels(world, vehicle, chassis, damage);
  assess_gun(world, vehicle, chassis, damage);
  assess_vitals(vehicle, chassis, damage);
  assess_tank(vehicle, chassis, damage);
  vehicle.whole = area_of(world.body(vehicle.chassis)) / vehicle.model->chassis_area;
  const bool dead = !damage.vitals.empty() || vehicle.whole < kMinChassis;
  damage.died = vehicle.alive && dead;
  if (dead) vehicle.alive = vehicle.gun.firing = false;
  return damage;
}

Damage knock_off(const World& world, Vehicle& vehicle, const Vec3& at, double reach) {
  KERF_ASSERT(reach >= 0);
  Damage damage;
  const Vec3 place = world.body(vehicle.chassis).placement.to_body(at);
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    Wheel& wheel = vehicle.wheels[i];
    if (!wheel.attached || glm::distance(vehicle.what().wheels[i].hub, place) > reach) continue;
    wheel.attached = wheel.grounded = false;
    damage.wheels.push_back(i);
  }
  Gun& gun = vehicle.gun;
  if (!gun.turret_attached || glm::distance(vehicle.what().turret.pivot, place) > reach) return damage;
  damage.turret = true;
  damage.barrel = gun.barrel_attached;
  gun.turret_attached = gun.barrel_attached = gun.firing = false;
  return damage;
}

double mass_of(const Body& body) { return area_of(body) * body.sheet.thickness * body.sheet.density; }

bool is_clean(const Body& piece, const Body& loaded) {
  const LoadedComponents& components = loaded.components;
  if (components.of_base.empty()) return false;
  std::vector<double> areas(components.left.size(), 0);
  double all = 0;
  for (uint32_t slot = 0; slot < piece.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!piece.mesh.is_live(f)) continue;
    const double area = triangle_area(piece.mesh.triangle(f));
    areas[components.of_base[piece.loaded_face(piece.loaded_base(f)).index]] += area;
    all += area;
  }
  if (all < kMinCleanArea) return false;
  for (uint32_t c = 0; c < areas.size(); ++c) {
    if (areas[c] > 0 && areas[c] < kCleanShare * components.left[c].area) return false;
  }
  return true;
}

Vec3 pushed_at(const Body& chassis, const Vec3& change) {
  const Bounds box = chassis.bounds();
  const Vec3 middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
  const Vec3 way = glm::conjugate(chassis.placement.orientation) * -change;
  double share = 1e300;  // of `way`, from the middle to the side
  for (const int axis : {0, 2}) {
    if (way[axis] != 0) share = std::min(share, half[axis] / std::abs(way[axis]));
  }
  if (share == 1e300) share = 0;
  return chassis.placement.to_world(middle + share * Vec3(way.x, 0, way.z));
}

bool release_joints_near(World& world, const Vehicle& vehicle, const Vec3& at, double change) {
  KERF_ASSERT(change >= kCrash);
  KERF_ASSERT(vehicle.model);
  Body& chassis = world.body(vehicle.chassis);
  const Vec3 place = chassis.placement.to_body(at);
  const double reach = std::min(kMaxReach, kReach + kMoreReach * (change - kCrash));
  const std::vector<bool>& breaks = vehicle.model->breaks;
  Joints joints = world.joints();
  size_t own = 0;
  bool any = false;
  for (Joint& joint : joints.all) {
    if (joint.body != chassis.loaded_as) continue;
    KERF_ASSERT(own < breaks.size());
    const bool near = glm::distance(joint.anchor, place) <= reach && !joint.sides[0].faces.empty();
    if (!breaks[own++] || !near) continue;
    joint.sides[0].faces.clear();
    joint.sides[1].faces.clear();
    any = true;
  }
  if (!any) return false;
  world.set_joints(std::move(joints));
  request_joints(world, chassis, {}, true);
  return true;
}

}  // namespace kerf
