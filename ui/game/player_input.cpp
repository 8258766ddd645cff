#include "ui/game/player_input.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/game/vehicle/vehicle.h"
#include "ui/game/hud.h"

namespace kerf {

namespace {

constexpr double kPartWithin = 0.5;    // m, from a place on the chassis to the part that names it
constexpr double kMiddleHeight = 0.8;  // m, of a vehicle over its origin

// Names a place on the chassis (m, in its frame) after the nearest part attached there.
std::string name_on_chassis(const Vehicle& vehicle, const Vec3& at) {
  const VehicleDescription& what = vehicle.what();
  std::string name = "body";
  double nearest = kPartWithin;
  const auto offer = [&](const Vec3& part, bool works, const std::string& called) {
    const double distance = glm::distance(part, at);
    if (!works || distance >= nearest) return;
    nearest = distance;
    name = called;
  };
  for (size_t i = 0; i < what.vitals.size(); ++i)
    offer(vehicle.model->vital_centres[i], vehicle.vital_works[i], name_of_vital(what, i));
  for (size_t i = 0; i < what.wheels.size(); ++i)
    offer(what.wheels[i].hub, vehicle.wheels[i].attached, "hub of the " + name_of_wheel(what, i));
  offer(what.turret.pivot, vehicle.gun.turret_attached, "laser mount");
  if (what.tank) offer(vehicle.model->tank_centre, vehicle.tank_whole, kTankName);
  return name;
}

std::string name_of_part(const World& world, const Vehicle& vehicle, BodyId body, const Vec3& at) {
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (vehicle.wheels[i].body == body) return name_of_wheel(vehicle.what(), i);
  }
  if (body != vehicle.chassis) return "laser";
  return name_on_chassis(vehicle, world.body(body).placement.to_body(at));
}

constexpr double kRadiansPerPixel = 0.0022;
constexpr double kWidthPerNotch = 0.1;
constexpr double kWidthSpeed = 0.6;  // 1/s, of a held button
constexpr double kSteadyRate = 14;   // 1/s
constexpr double kDeadZone = 0.16;   // of a stick
constexpr double kStickSpeed = 1.8;  // rad/s, of a fully deflected stick
constexpr double kHelpReach = 0.06;  // rad, from the aim
constexpr double kHelpPull = 2.2;    // 1/s
constexpr double kHelpFar = 45;      // m
constexpr double kPartReach = 0.04;  // rad, from the aim to a part that slows it down on a gamepad

double without_dead_zone(double x) {
  const double over = std::abs(x) - kDeadZone;
  return over > 0 ? std::copysign(over / (1 - kDeadZone), x) : 0;
}

std::optional<GameAction> action_of_button(int button) {
  for (size_t i = 0; i < kGameActions; ++i) {
    if (action_keys(static_cast<GameAction>(i)).button == button) return static_cast<GameAction>(i);
  }
  return std::nullopt;
}

// The holders of actions (see ActionLatch): keys by their places, mouse buttons, and the gamepad.
constexpr int kPadHolder = -100;
int holder_of_button(int button) { return -1 - button; }
int holder_of(const InputEvent& event, bool is_key) {
  return is_key ? event.place : holder_of_button(event.button);
}

// By digit, from 1.
constexpr std::array kViews{SwitchId::kBoxes,         SwitchId::kSizes,        SwitchId::kWire,
                            SwitchId::kPieces,        SwitchId::kGraph,        SwitchId::kContacts,
                            SwitchId::kShadowVolumes, SwitchId::kShadowCounts, SwitchId::kSilhouette};
static_assert(kViews.size() <= 9);

}  // namespace

std::optional<SightedPart> sighted_part(const Match& match, const Sight& sight, const Vec3& aim) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  const Vec3 from = in_world(match.world(), own, own.what().turret.barrel.pivot);
  const double range = match.rules().description.laser.range;
  const auto hit = sight.nearest({from, aim}, range, [&](BodyId id) { return !own.has(id); });
  if (!hit || !hit->body.valid()) return std::nullopt;
  const size_t vehicle = match.vehicle_of(hit->body);
  if (vehicle == Event::kNobody || !match.vehicles()[vehicle].alive) return std::nullopt;
  const Vec3 at = from + hit->length * aim;
  return SightedPart{vehicle, hit->body, at,
                     name_of_part(match.world(), match.vehicles()[vehicle], hit->body, at)};
}

Vec3 place_aimed_at(const Match& match, const Sight& sight, const Vec3& aim) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  const Vec3 from = in_world(match.world(), own, own.what().turret.barrel.pivot);
  const double range = match.rules().description.laser.range;
  const auto hit = sight.nearest(
      {from, aim}, range, [&](BodyId id) { return !own.has(id) && !own.is_made_of(match.world().body(id)); });
  return from + (hit ? hit->length : range) * aim;
}

bool sees_vehicle(const Match& match, const Sight& sight, const Vec3& from, size_t vehicle) {
  KERF_ASSERT(vehicle < match.vehicles().size());
  const Vec3 middle =
      match.world().body(match.vehicles()[vehicle].chassis).placement.to_world({0, kMiddleHeight, 0});
  const double distance = glm::distance(from, middle);
  if (!(distance > 0)) return true;
  const auto hit = sight.nearest({from, (middle - from) / distance}, distance,
                                 [&](BodyId id) { return match.is_wall(id); });
  return !hit || !hit->body.valid();
}

std::vector<Vec3> parts_to_cut(const Vehicle& vehicle) {
  const VehicleDescription& what = vehicle.what();
  std::vector<Vec3> parts;
  for (size_t i = 0; i < what.wheels.size(); ++i) {
    if (vehicle.wheels[i].attached) parts.push_back(what.wheels[i].hub);
  }
  for (size_t i = 0; i < what.vitals.size(); ++i) {
    if (vehicle.vital_works[i]) parts.push_back(vehicle.model->vital_centres[i]);
  }
  if (vehicle.gun.turret_attached) parts.push_back(what.turret.pivot);
  if (what.tank && vehicle.tank_whole) parts.push_back(vehicle.model->tank_centre);
  return parts;
}

void SteadyAim::advance(bool held, double seconds) {
  KERF_ASSERT(seconds >= 0);
  spent_ = held && (spent_ || left_ <= 0);
  on_ = held && !spent_;
  left_ = std::clamp(left_ + seconds * (on_ ? -1 / kSeconds : 1 / kRefill), 0.0, 1.0);
  const double share = 1 - std::exp(-kSteadyRate * seconds);
  share_ += share * ((on_ ? 1 : 0) - share_);
}

bool is_near_part(const Match& match, const Sight& sight, const Vec3& aim) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  const Vec3 eye = in_world(match.world(), own, own.what().turret.barrel.pivot);
  for (size_t i = 1; i < match.vehicles().size(); ++i) {
    const Vehicle& enemy = match.vehicles()[i];
    if (!enemy.alive || !sees_vehicle(match, sight, eye, i)) continue;
    for (const Vec3& part : parts_to_cut(enemy)) {
      const Vec3 way = in_world(match.world(), enemy, part) - eye;
      const double distance = glm::length(way);
      if (distance > 0 && glm::length(way / distance - aim) < kPartReach) return true;
    }
  }
  return false;
}

void PlayerInput::handle_motion(const InputEvent& event, const GameSettings& settings) {
  if (has_pointer_ && event.at != pointer_) {
    const Vec2 way = (event.at - pointer_) * (kRadiansPerPixel * settings.sensitivity);
    turn(-way.x, settings.invert ? way.y : -way.y);
    still_s_ = 0;
    on_pad_ = false;
  }
  has_pointer_ = true;
  pointer_ = event.at;
}

void PlayerInput::handle_events(std::span<const InputEvent> events, const GameSettings& settings) {
  using Kind = InputEvent::Kind;
  for (const InputEvent& event : events) {
    const bool is_key = event.kind == Kind::kKey || event.kind == Kind::kKeyUp;
    const auto action = is_key ? action_of_key(event.place, settings.keys) : action_of_button(event.button);
    switch (event.kind) {
      case Kind::kMove:
        handle_motion(event, settings);
        break;
      case Kind::kWheel:
        width_ = std::clamp(width_ + kWidthPerNotch * event.wheel, 0.0, 1.0);
        break;
      case Kind::kPress:
      case Kind::kKey:
        if (action && !event.again) latch(*action).press(holder_of(event, is_key));
        break;
      case Kind::kRelease:
      case Kind::kKeyUp:
        if (action) latch(*action).release(holder_of(event, is_key));
        break;
      case Kind::kText:
        break;
    }
  }
}

void PlayerInput::take_held_controls(const Window& window, const KeyBindings& bindings) {
  for (size_t i = 0; i < kGameActions; ++i) {
    const ActionKeys& keys = action_keys(static_cast<GameAction>(i));
    for (const int key : {bindings[i], keys.other_key}) {
      if (key != 0 && window.is_key_held(key)) latches_[i].hold(key);
    }
    if (keys.button >= 0 && window.is_button_held(keys.button))
      latches_[i].hold(holder_of_button(keys.button));
  }
}

void PlayerInput::apply_gamepad(const GamepadState& pad, double seconds, const GameSettings& settings,
                                bool friction) {
  for (size_t i = 0; i < kGameActions; ++i) {
    const auto action = static_cast<GameAction>(i);
    const int button = action_keys(action).pad;
    if (pad.is_pressed(button) == pad_.is_pressed(button)) continue;
    pad.is_pressed(button) ? latch(action).press(kPadHolder) : latch(action).release(kPadHolder);
  }
  if (pad.buttons[GLFW_GAMEPAD_BUTTON_LEFT_BUMPER]) width_ = std::max(0.0, width_ - kWidthSpeed * seconds);
  if (pad.buttons[GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER]) width_ = std::min(1.0, width_ + kWidthSpeed * seconds);
  pad_ = pad;
  const auto axis = [&](int a) { return without_dead_zone(pad.axes[static_cast<size_t>(a)]); };
  steer_ = -axis(GLFW_GAMEPAD_AXIS_LEFT_X);
  throttle_ = -axis(GLFW_GAMEPAD_AXIS_LEFT_Y);
  const double left = -axis(GLFW_GAMEPAD_AXIS_RIGHT_X), up = -axis(GLFW_GAMEPAD_AXIS_RIGHT_Y);
  if (left == 0 && up == 0) return;
  const double way = kStickSpeed * settings.sensitivity * seconds * (friction ? kFriction : 1);
  turn(left * way, (settings.invert ? -up : up) * way);
  still_s_ = 0;
  on_pad_ = true;
}

void PlayerInput::release_all() {
  throttle_ = steer_ = 0;
  latches_.fill({});
  pad_ = {};
  has_pointer_ = false;
}

void PlayerInput::reset() {
  release_all();
  yaw_ = pitch_ = 0;
}

void PlayerInput::turn(double left, double up) {
  yaw_ += left;
  const bool all_around = yaw_limits_.high - yaw_limits_.low >= 2 * kPi - 1e-3;
  yaw_ = all_around ? wrapped(yaw_) : std::clamp(yaw_, yaw_limits_.low, yaw_limits_.high);
  pitch_ = std::clamp(pitch_ + up, pitch_limits_.low, pitch_limits_.high);
}

void PlayerInput::help(const Match& match, const Sight& sight, double seconds) {
  still_s_ += seconds;
  if (on_pad_ || still_s_ < kAimRest || latch(GameAction::kFire).is_held()) return;
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  const Placement& chassis = match.world().body(own.chassis).placement;
  const Vec3 eye = chassis.to_world(own.what().turret.barrel.pivot), aim = direction(chassis);
  double nearest = kHelpReach, left = 0, up = 0;
  for (size_t i = 1; i < match.vehicles().size(); ++i) {
    const Vehicle& enemy = match.vehicles()[i];
    if (!enemy.alive) continue;
    const Vec3 way = match.world().body(enemy.chassis).placement.to_world({0, 0.8, 0}) - eye;
    const double distance = glm::length(way);
    if (!(distance > 0) || distance > kHelpFar) continue;
    const double aside = wrapped(heading_of(way) - heading_of(aim)),
                 rise = pitch_of(way / distance) - pitch_of(aim);
    const double off = glm::length(Vec2(aside, rise));
    if (off >= nearest || !sees_vehicle(match, sight, eye, i)) continue;
    nearest = off;
    left = aside;
    up = rise;
  }
  const double share = std::min(1.0, kHelpPull * seconds);
  turn(left * share, up * share);
}

void PlayerInput::limit(const Interval& yaw, const Interval& pitch) {
  KERF_ASSERT(yaw.low <= yaw.high && pitch.low <= pitch.high);
  yaw_limits_ = yaw;
  pitch_limits_ = pitch;
  turn(0, 0);
}

double PlayerInput::heading(const Placement& chassis) const {
  return wrapped(heading_of(chassis.orientation * Vec3(0, 0, 1)) + yaw_);
}

Vec3 PlayerInput::direction(const Placement& chassis) const { return direction_of(heading(chassis), pitch_); }

Controls PlayerInput::controls(const Placement& chassis) {
  const auto share = [](double x) { return static_cast<int8_t>(std::lround(x * Controls::kFull)); };
  const auto steps = [](double angle) {
    return static_cast<int32_t>(std::lround(angle / Controls::kAimStep));
  };
  const auto on = [&](GameAction action) { return latch(action).next(); };
  const double throttle = throttle_ + on(GameAction::kForward) - on(GameAction::kBackward);
  const double steer = steer_ + on(GameAction::kLeft) - on(GameAction::kRight);
  Controls c;
  c.throttle = share(std::clamp(throttle, -1.0, 1.0));
  c.steer = share(std::clamp(steer, -1.0, 1.0));
  c.handbrake = on(GameAction::kHandbrake);
  c.fire = on(GameAction::kFire);
  c.spawn = on(GameAction::kSpawn);
  c.give_up = on(GameAction::kNextCar);
  c.boost = on(GameAction::kBoost);
  c.upgrade = std::exchange(upgrade_, uint8_t{0});
  c.width = static_cast<uint8_t>(std::lround(width_ * Controls::kFull));
  c.heading = steps(heading(chassis));
  c.pitch = steps(pitch_);
  return c;
}

bool is_debug_view(const ViewSwitch& s) {
  switch (s.id) {
    case SwitchId::kShadows:
    case SwitchId::kAntialias:
    case SwitchId::kSection:
    case SwitchId::kSparks:
      return false;
    default:
      return s.is_two_state() && s.label[0] != '\0';
  }
}

std::optional<char> digit_of(SwitchId view) {
  const auto at = std::find(kViews.begin(), kViews.end(), view);
  if (at == kViews.end()) return std::nullopt;
  return static_cast<char>('1' + (at - kViews.begin()));
}

std::string press_digit(char digit, ViewOptions& look) {
  if (digit == '0') {
    for (const ViewSwitch& s : view_switches()) {
      if (is_debug_view(s)) s.set(look, s.get(ViewOptions()));
    }
    return "Debug views off";
  }
  const auto index = static_cast<size_t>(digit - '1');
  if (digit < '1' || index >= kViews.size()) return {};
  const ViewSwitch& s = view_switch(kViews[index]);
  s.flip(look);
  return std::string(s.label) + " " + s.states[s.get(look)];
}

}  // namespace kerf
