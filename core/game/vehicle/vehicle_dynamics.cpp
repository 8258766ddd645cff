#include "core/game/vehicle/vehicle_dynamics.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/physics/contact/rigid_body.h"

namespace kerf {

RigidMotion::RigidMotion(const Body& body) {
  const RigidFrame frame = rigid_frame(body);
  KERF_ASSERT(frame.mass > 0);
  mass_ = frame.mass;
  const glm::dmat3 axes = glm::mat3_cast(body.placement.orientation * frame.axes);
  glm::dmat3 inverse(0.0);
  for (int k = 0; k < 3; ++k) inverse[k][k] = 1 / frame.inertia[k];
  inverse_inertia_ = axes * inverse * glm::transpose(axes);
  centre_ = body.placement.to_world(frame.centre);
  spin_ = body.motion.spin;
  velocity_ = body.motion.velocity_at(centre_, body.placement);
}

double RigidMotion::response(const Vec3& p, const Vec3& along) const {
  const Vec3 arm = p - centre_;
  return 1 / mass_ + glm::dot(glm::cross(inverse_inertia_ * glm::cross(arm, along), arm), along);
}

void RigidMotion::push(const Vec3& p, const Vec3& impulse) {
  velocity_ += impulse / mass_;
  spin_ += inverse_inertia_ * glm::cross(p - centre_, impulse);
}

void RigidMotion::store(Body& body) const {
  body.motion.spin = spin_;
  body.motion.velocity = velocity_ + glm::cross(spin_, body.placement.position - centre_);
}

namespace {

// The suspension, per kilogram of the vehicle and per wheel, after the vehicle of Bullet.
constexpr double kStiffness = 25;                      // 1/s^2
constexpr double kCompression = 3, kRelaxation = 4.5;  // 1/s, of the damper
constexpr double kBumpStop = 8;                        // times the stiffness, beyond the travel
constexpr double kMaxLoad = 40;                        // m/s^2, times the mass
constexpr double kGrip = 1.15;                         // coefficient of friction of a tyre
constexpr double kLockedGrip = 0.55;                   // across a wheel that the handbrake locks
constexpr double kStump = 0.5, kStumpGrip = 0.3;  // of a lost wheel: fractions of its radius and its load
constexpr double kRollingResistance = 0.018;      // of the load
constexpr double kBrake = 8;                      // m/s^2, times the share of a wheel in the mass
constexpr double kLeanLess = 0.75;                // of the height of the centre above the ground
constexpr double kSteeringSpeed = 2.4;            // rad/s
constexpr double kStandstill = 0.6;               // m/s, below which throttle backwards reverses
constexpr int kSweeps = 3;

constexpr double kBoost = 1.8, kBoostTop = 1.3;         // factors of force and top speed
constexpr double kBoostSeconds = 2, kBoostRefill = 10;  // s

// A grounded wheel with its axes in the world.
struct Standing {
  Wheel* wheel;
  Vec3 at, normal, forward, side;
  Body* below = nullptr;  // the movable body below it, if any
  Vec3 ground_velocity{0};
  double load = 0;                            // N s in the tick
  double drive = 0;                           // N s, wanted along `forward`
  double brake = 0;                           // N s, maximum
  double grip_across = 0, grip_along = 0;     // N s, maximum
  double across = 0, along = 0, braking = 0;  // N s, so far; braking is a part of `along`
};

class Drive {
 public:
  Drive(World& world, Vehicle& vehicle, const Sight& sight)
      : world_(world),
        vehicle_(vehicle),
        sight_(sight),
        chassis_(world.body(vehicle.chassis)),
        motion_(chassis_),
        up_(chassis_.placement.orientation * Vec3(0, 1, 0)),
        ahead_(chassis_.placement.orientation * Vec3(0, 0, 1)) {}

  void run() {
    speed_ = glm::dot(motion_.velocity(), ahead_);
    use_boost();
    steer();
    const double mass = vehicle_.what().mass;
    for (size_t i = 0; i < vehicle_.wheels.size(); ++i) {
      suspend(i, mass);
    }
    share_out_drive();
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (Standing& s : standing_) grip(s);
    }
    for (const Standing& s : standing_) push_back(s);
    roll();
    resist_air();
    motion_.store(chassis_);
  }

 private:
  const VehicleDescription& what() const { return vehicle_.what(); }
  double throttle() const {
    return vehicle_.alive ? static_cast<double>(vehicle_.controls.throttle) / Controls::kFull : 0;
  }
  bool handbrake() const { return vehicle_.controls.handbrake && vehicle_.alive; }

  void use_boost() {
    double& left = vehicle_.boost;
    boosts_ = vehicle_.controls.boost && throttle() > 0 && left > 0;
    left = std::clamp(left + kTick * (boosts_ ? -1 / kBoostSeconds : 1 / kBoostRefill), 0.0, 1.0);
  }

  void steer() {
    const double wanted =
        static_cast<double>(vehicle_.controls.steer) / Controls::kFull * full_lock(std::abs(speed_));
    for (size_t i = 0; i < vehicle_.wheels.size(); ++i) {
      Wheel& wheel = vehicle_.wheels[i];
      if (what().wheels[i].steers && vehicle_.alive)
        wheel.steer = towards(wheel.steer, wanted, kSteeringSpeed * kTick);
    }
  }

  // Height of the start of the ray of a wheel above its hub.
  static constexpr double kAbove = 0.35;  // m

  // Returns true if a body can carry a wheel. The ray of a wheel starts above it, within the vehicle, where
  // detached parts of the vehicle may still be; and loose bodies can get between wheel and chassis.
  bool carries(BodyId id) const {
    const Body& body = world_.body(id);
    if (vehicle_.is_made_of(body)) return false;
    return body.pinned || rigid_frame(body).mass >= kLightBody * what().mass;
  }

  void suspend(size_t i, double mass) {
    Wheel& wheel = vehicle_.wheels[i];
    const WheelDescription& w = what().wheels[i];
    const double half = 0.5 * w.travel, radius = wheel.attached ? w.radius : kStump * w.radius;
    const Pose ray{chassis_.placement.to_world(w.hub + Vec3(0, half + kAbove, 0)), -up_};
    const auto hit = sight_.nearest(ray, kAbove + w.travel + radius, [&](BodyId id) { return carries(id); });
    wheel.grounded = hit && glm::dot(hit->normal, up_) > 0.2;
    wheel.load = wheel.slip = 0;
    if (!wheel.grounded) {
      wheel.rise = towards(wheel.rise, -half, 1.5 * kTick);
      return;
    }
    const double rise = half + kAbove + radius - hit->length;
    wheel.rise = std::min(rise, half);
    wheel.contact = ray.origin - hit->length * up_;
    stand(wheel, w, *hit, rise, mass);
  }

  void stand(Wheel& wheel, const WheelDescription& w, const SightHit& hit, double rise, double mass) {
    const double wheels = static_cast<double>(vehicle_.wheels.size());
    Standing s{&wheel, wheel.contact, hit.normal, {}, {}};
    if (hit.body.valid() && !world_.body(hit.body).pinned) {
      s.below = &world_.body(hit.body);
      s.ground_velocity = s.below->motion.velocity_at(s.at, s.below->placement);
    }
    const double sinking = -glm::dot(motion_.velocity_at(s.at) - s.ground_velocity, s.normal);
    const double at_rest = glm::length(world_.environment().gravity) / (kStiffness * wheels);
    double spring = kStiffness * (rise + at_rest);
    if (rise > 0.5 * w.travel) spring += kBumpStop * kStiffness * (rise - 0.5 * w.travel);
    const double damper = sinking * (sinking > 0 ? kCompression : kRelaxation);
    wheel.load = mass * std::clamp(spring + damper, 0.0, kMaxLoad);
    s.load = wheel.load * kTick;
    motion_.push(s.at, s.load * s.normal);
    const Vec3 axis = axis_angle(up_, wheel.steer) * (chassis_.placement.orientation * Vec3(1, 0, 0));
    const Vec3 forward = glm::cross(axis, s.normal);
    const double length = glm::length(forward);
    if (!(length > 0.1)) return push_back(s);
    s.forward = forward / length;
    s.side = glm::cross(s.normal, s.forward);
    s.grip_across = s.grip_along = (wheel.attached ? kGrip : kStumpGrip) * s.load;
    standing_.push_back(s);
  }

  // Throttle against the motion brakes, and releasing it brakes a little.
  void share_out_drive() {
    size_t driven = 0;
    for (const Standing& s : standing_) driven += is_driven(s);
    const double wanted = throttle();
    const bool against = wanted * speed_ < 0 && std::abs(speed_) > kStandstill;
    const double share = vehicle_.what().mass / static_cast<double>(vehicle_.wheels.size()) * kTick;
    for (Standing& s : standing_) {
      if (against) {
        s.brake = kBrake * std::abs(wanted) * share;
      } else if (is_driven(s)) {
        s.drive = wanted * force() / static_cast<double>(driven) * kTick;
      }
      const double coasting = vehicle_.alive ? (wanted == 0 ? 0.4 : 0) : 1.5;  // m/s^2
      s.brake = std::max(s.brake, coasting * share);
      s.brake += kRollingResistance * s.load;
      if (!s.wheel->attached) s.brake = s.load;
      if (handbrake() && !steers(s)) {
        s.brake = kBrake * share + s.load;
        s.grip_across = kLockedGrip * s.load;
      }
    }
  }

  size_t index_of(const Standing& s) const { return static_cast<size_t>(s.wheel - vehicle_.wheels.data()); }
  bool is_driven(const Standing& s) const { return s.wheel->attached && what().wheels[index_of(s)].driven; }
  bool steers(const Standing& s) const { return what().wheels[index_of(s)].steers; }

  double force() const {
    const EngineDescription& engine = what().engine;
    const double speed = std::abs(speed_), more = boosts_ ? kBoost : 1;
    const double limit = speed_ < 0 ? 0.4 * engine.top_speed
                         : boosts_  ? kBoostTop * engine.top_speed
                                    : engine.top_speed;
    if (speed >= limit) return 0;
    return more * std::min(engine.force, engine.power / std::max(speed, 1.0));
  }

  void grip(Standing& s) {
    const Vec3 at = s.at + kLeanLess * glm::dot(motion_.centre() - s.at, up_) * up_;
    const Vec3 velocity = motion_.velocity_at(s.at) - s.ground_velocity;
    const double wanted_across = s.across - glm::dot(velocity, s.side) / motion_.response(at, s.side);
    const double forward = glm::dot(velocity, s.forward);
    s.braking = std::clamp(s.braking - forward / motion_.response(s.at, s.forward), -s.brake, s.brake);
    double along = s.drive + s.braking;
    double across = std::clamp(wanted_across, -s.grip_across, s.grip_across);
    const double most = s.grip_along;
    along = std::clamp(along, -most, most);
    const double both = std::sqrt(along * along + across * across);
    if (both > most) {
      along *= most / both;
      across *= most / both;
    }
    motion_.push(at, (across - s.across) * s.side);
    motion_.push(s.at, (along - s.along) * s.forward);
    s.across = across;
    s.along = along;
  }

  void push_back(const Standing& s) const {
    if (!s.below) return;
    s.below->motion.asleep = false;
    s.below->motion.quiet = 0;
    RigidMotion motion(*s.below);
    motion.push(s.at, -(s.load * s.normal + s.across * s.side + s.along * s.forward));
    motion.store(*s.below);
  }

  void roll() {
    for (Standing& s : standing_) {
      const Vec3 velocity = motion_.velocity_at(s.at) - s.ground_velocity;
      const double forward = glm::dot(velocity, s.forward), radius = what().wheels[index_of(s)].radius;
      const bool locked = handbrake() && !steers(s);
      s.wheel->rate = locked ? 0 : forward / radius;
      s.wheel->slip = std::abs(glm::dot(velocity, s.side)) + (locked ? std::abs(forward) : 0);
    }
    for (Wheel& wheel : vehicle_.wheels) wheel.angle = wrapped(wheel.angle + kTick * wheel.rate);
  }

  void resist_air() {
    const double drag = 0.0006 * glm::length(motion_.velocity());  // 1/s
    motion_.push(-kTick * drag * motion_.mass() * motion_.velocity());
  }

  World& world_;
  Vehicle& vehicle_;
  const Sight& sight_;
  Body& chassis_;
  RigidMotion motion_;
  const Vec3 up_, ahead_;
  bool boosts_ = false;
  double speed_ = 0;  // m/s, forward
  std::vector<Standing> standing_;
};

constexpr double kUpright = 0.5;       // the cosine of the lean
constexpr double kBall = 0.42;         // m, the radius of the balls
constexpr double kAboveGround = 0.12;  // m, of the balls above the lowest point
constexpr double kApart = 0.8;         // m, between balls
constexpr double kFriction = 0.2;
constexpr double kRebound = 0.15;
constexpr double kSlop = 0.005;  // m, allowed penetration of balls
constexpr int kPasses = 2;

struct Extent {
  double left, right, low, back, front;  // m, in the frame of the vehicle
};

// The extent of the rest of the chassis and of the wheels.
Extent extent_of(const Body& chassis, const Vehicle& vehicle) {
  const Bounds box = chassis.bounds();
  Extent e{box.max.x, box.min.x, box.min.y, box.min.z, box.max.z};
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (!vehicle.wheels[i].attached) continue;
    const WheelDescription& wheel = vehicle.what().wheels[i];
    e.left = std::max(e.left, wheel.hub.x + 0.1);
    e.right = std::min(e.right, wheel.hub.x - 0.1);
    e.back = std::min(e.back, wheel.hub.z - 0.7 * wheel.radius);
    e.front = std::max(e.front, wheel.hub.z + 0.7 * wheel.radius);
  }
  return e;
}

std::vector<Vec3> balls_of(const Extent& e) {
  const double y = std::max(e.low, 0.0) + kAboveGround + kBall;
  const double back = std::min(e.back + kBall, 0.5 * (e.back + e.front)), front = e.back + e.front - back;
  const double right = std::min(e.right + kBall, 0.5 * (e.right + e.left)), left = e.right + e.left - right;
  const int rows = 1 + static_cast<int>(std::ceil((front - back) / kApart));
  std::vector<Vec3> balls;
  for (int i = 0; i < rows; ++i) {
    const double z = back + (front - back) * i / std::max(rows - 1, 1);
    balls.insert(balls.end(), {{left, y, z}, {right, y, z}});
  }
  return balls;
}

// Removes the velocity of a point against a unit normal, and some of that across it.
void stop(RigidMotion& motion, const Vec3& at, const Vec3& normal) {
  KERF_ASSERT(is_unit(normal));
  const double against = -glm::dot(motion.velocity_at(at), normal);
  if (against <= 0) return;
  const double impulse = (1 + kRebound) * against / motion.response(at, normal);
  motion.push(at, impulse * normal);
  const Vec3 velocity = motion.velocity_at(at), across = velocity - glm::dot(velocity, normal) * normal;
  const double speed = glm::length(across);
  if (!(speed > 0)) return;
  const Vec3 along = across / speed;
  motion.push(at, -std::min(kFriction * impulse, speed / motion.response(at, along)) * along);
}

constexpr double kPatience = 0.9;            // s
constexpr double kFirst = 0.9, kMore = 0.3;  // s, of backing off, and increment per attempt
constexpr double kHere = 1, kElsewhere = 6;  // m
constexpr int kMaxTimes = 2;                 // near the same place
constexpr int kWants = Controls::kFull / 5;  // of the throttle

int direction_of(const Controls& controls) {
  return controls.throttle > kWants ? 1 : controls.throttle < -kWants ? -1 : 0;
}

}  // namespace

double full_lock(double speed) { return 0.62 / (1 + speed * speed / 90); }

void drive(World& world, Vehicle& vehicle, const Sight& sight) {
  Body& chassis = world.body(vehicle.chassis);
  if (vehicle.alive) {
    chassis.motion.asleep = false;
    chassis.motion.quiet = 0;
  }
  if (chassis.mesh.live_faces() > 0 && !chassis.motion.asleep) Drive(world, vehicle, sight).run();
}

bool is_upright(const World& world, const Vehicle& vehicle) {
  return (world.body(vehicle.chassis).placement.orientation * Vec3(0, 1, 0)).y > kUpright;
}

void glide_along(World& world, const Vehicle& vehicle, const Obstacles& obstacles) {
  Body& chassis = world.body(vehicle.chassis);
  if (chassis.mesh.live_faces() == 0 || chassis.motion.asleep || !is_upright(world, vehicle)) return;
  const std::vector<Vec3> balls = balls_of(extent_of(chassis, vehicle));
  for (int sweep = 0; sweep < kPasses; ++sweep) {
    for (const Vec3& ball : balls) {
      const Vec3 centre = chassis.placement.to_world(ball);
      const auto touch = obstacles.touched_by(centre, kBall);
      if (!touch) continue;
      const Vec3 way(centre.x - touch->at.x, 0, centre.z - touch->at.z);
      const double length = glm::length(way);
      if (!(length > 0)) continue;
      const Vec3 normal = way / length;
      RigidMotion motion(chassis);
      stop(motion, touch->at, normal);
      motion.store(chassis);
      chassis.placement.position += std::max(0.0, kBall - touch->distance - kSlop) * normal;
    }
  }
}

Controls backed_off(const World& world, Vehicle& vehicle, const Controls& wanted) {
  BackOff& b = vehicle.back_off;
  const Vec3 here = world.body(vehicle.chassis).placement.position;
  if (!vehicle.alive || !vehicle.can_drive()) return wanted;
  if (b.left_s > 0) {
    b.left_s -= kTick;
    b.held_s = 0;
    Controls out = wanted;
    out.throttle = static_cast<int8_t>(-b.direction * Controls::kFull);
    out.steer = static_cast<int8_t>(b.side * Controls::kFull);
    out.handbrake = false;
    return out;
  }
  const int direction = direction_of(wanted);
  if (direction == 0 || direction != b.direction || glm::distance(here, b.anchor) > kHere) {
    b.direction = direction;
    b.anchor = here;
    b.held_s = 0;
  }
  if (glm::distance(here, b.place) > kElsewhere) b.times = 0;
  if (direction == 0 || wanted.handbrake) return wanted;
  b.held_s += kTick;
  if (b.held_s < kPatience) return wanted;
  b.wedged = b.times == kMaxTimes;
  if (b.wedged) return wanted;
  if (b.times == 0) b.place = here;
  b.side = b.times == 0 && wanted.steer != 0 ? (wanted.steer > 0 ? -1 : 1) : -b.side;
  b.left_s = kFirst + kMore * b.times;
  ++b.times;
  return wanted;
}

}  // namespace kerf
