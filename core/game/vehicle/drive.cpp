#include "core/game/vehicle/drive.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/tick.h"
#include "core/game/vehicle/rigid_motion.h"
#include "core/physics/contact/rigid_frame.h"

namespace kerf {

namespace {

// The suspension, for each kilogram of the vehicle and each wheel, after the vehicle of Bullet.
constexpr double kStiffness = 25;                      // 1/s^2
constexpr double kCompression = 3, kRelaxation = 4.5;  // 1/s, of the damper
constexpr double kBumpStop = 8;                        // times the stiffness, beyond the travel
constexpr double kMostLoad = 40;                       // m/s^2, times the mass
constexpr double kGrip = 1.15;                         // coefficient of friction of a tyre
constexpr double kLockedGrip = 0.55;                   // across a wheel that the handbrake locks
constexpr double kStump = 0.5, kStumpGrip = 0.3;  // where a wheel is gone: of its radius, and of its load
constexpr double kRollingResistance = 0.018;      // of the load
constexpr double kBrake = 8;                      // m/s^2, times the share of a wheel in the mass
constexpr double kLeanLess = 0.75;                // of the height of the centre over the ground
constexpr double kSteeringSpeed = 2.4;            // rad/s
constexpr double kStandstill = 0.6;               // m/s, below which throttle backwards reverses
constexpr int kSweeps = 3;

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

// A wheel that stands on something, with its axes in the world.
struct Standing {
  Wheel* wheel;
  Vec3 at, normal, forward, side;
  Body* below = nullptr;  // on which it stands, if that can move
  Vec3 ground_velocity{0};
  double load = 0;                            // N s in the tick
  double drive = 0;                           // N s, wanted along `forward`
  double brake = 0;                           // N s, at most
  double grip_across = 0, grip_along = 0;     // N s, at most
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

  void steer() {
    const double wanted =
        static_cast<double>(vehicle_.controls.steer) / Controls::kFull * full_lock(std::abs(speed_));
    for (size_t i = 0; i < vehicle_.wheels.size(); ++i) {
      Wheel& wheel = vehicle_.wheels[i];
      if (what().wheels[i].steers && vehicle_.alive)
        wheel.steer = towards(wheel.steer, wanted, kSteeringSpeed * kTick);
    }
  }

  // Where the ray of a wheel starts, above its hub.
  static constexpr double kAbove = 0.35;  // m

  // Whether a wheel stands on a body. The ray of a wheel begins above it, within the vehicle, where what came
  // off the vehicle may still be; and what the vehicle sweeps aside gets between wheel and chassis.
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
    wheel.load = mass * std::clamp(spring + damper, 0.0, kMostLoad);
    s.load = wheel.load * kTick;
    motion_.push(s.at, s.load * s.normal);
    const Vec3 axis = turn_about(up_, wheel.steer) * (chassis_.placement.orientation * Vec3(1, 0, 0));
    const Vec3 forward = glm::cross(axis, s.normal);
    const double length = glm::length(forward);
    if (!(length > 0.1)) return push_back(s);
    s.forward = forward / length;
    s.side = glm::cross(s.normal, s.forward);
    s.grip_across = s.grip_along = (wheel.attached ? kGrip : kStumpGrip) * s.load;
    standing_.push_back(s);
  }

  // Throttle against the motion brakes, as releasing it does a little.
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
    const double speed = std::abs(speed_);
    const double limit = speed_ < 0 ? 0.4 * engine.top_speed : engine.top_speed;
    if (speed >= limit) return 0;
    return std::min(engine.force, engine.power / std::max(speed, 1.0));
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

  // What a wheel stands on gets the opposite impulse.
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
  double speed_ = 0;  // m/s, forward
  std::vector<Standing> standing_;
};

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

}  // namespace kerf
