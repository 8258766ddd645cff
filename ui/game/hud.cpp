#include "ui/game/hud.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <vector>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kPulses = 2.5;   // 1/s
constexpr double kFlyHeight = 3;  // em, of points
constexpr double kNearEye = 0.2;  // m

// Minimum size of the window [em]; in a smaller one the text is scaled down.
constexpr float kMinWide = 50, kMinHigh = 32;

constexpr ImU32 kEdge = IM_COL32(8, 10, 13, 200);

using Align = HudPaint::Align;

constexpr ImU32 kBad = IM_COL32(0xff, 0x6a, 0x4d, 255);
constexpr const char* kSkip = "Enter: skip tutorial";
constexpr ImU32 kText = colours::kPictureText, kSecondary = colours::kPictureSecondary;

std::string number(double x) { return std::to_string(static_cast<long>(std::lround(x))); }

// Returns the position of a world point on the screen; nullopt behind the eye.
std::optional<ImVec2> on_screen(const HudView& view, const HudPaint& paint, const Vec3& p) {
  const Vec3 seen = view.camera.project(p);
  if (!(seen.z > 0)) return std::nullopt;
  return ImVec2(paint.size().x * static_cast<float>(0.5 + 0.5 * seen.x),
                paint.size().y * static_cast<float>(0.5 - 0.5 * seen.y));
}

bool is_inside(const HudPaint& paint, ImVec2 at, float margin) {
  return at.x > margin && at.y > margin && at.x < paint.size().x - margin && at.y < paint.size().y - margin;
}

const Vehicle& own(const HudView& view) { return view.match.vehicles()[Match::kPlayer]; }

// A ring at the aim, and a dot at the direction of the barrel, which lags behind.
void draw_reticle(const HudView& view, const HudPaint& paint) {
  const ImVec2 middle(0.5f * paint.size().x, 0.5f * paint.size().y);
  const Vehicle& vehicle = own(view);
  const Vec3 aimed_at = place_aimed_at(view.match, view.sight, view.aim);
  const auto aimed = on_screen(view, paint, aimed_at);
  const ImVec2 at = aimed.value_or(middle);
  const float r = paint.em() * static_cast<float>(0.55 + 0.5 * view.width);
  const ImU32 colour = !vehicle.gun.works() || vehicle.gun.overheated ? kBad
                       : view.state.biting() > 0                      ? colours::accent()
                                                                      : kText;
  paint.circle(at, r, colour, view.state.biting() > 0 ? 1.0f : 1.5f);
  for (const auto& [x, y] : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)}) {
    paint.line({at.x + x * r, at.y + y * r},
               {at.x + x * (r + 0.4f * paint.em()), at.y + y * (r + 0.4f * paint.em())}, colour, 1.5f);
  }
  if (!vehicle.gun.works()) {
    paint.text({at.x, at.y + 2 * r}, "no laser", kBad, 1, Align::kMiddle);
    return;
  }
  const Placement& chassis = view.match.world().body(vehicle.chassis).placement;
  const Vec3 forward = direction_of(vehicle.gun.yaw, vehicle.gun.pitch);
  const Vec3 muzzle = chassis.to_world(vehicle.what().turret.barrel.pivot);
  const double length = glm::distance(muzzle, aimed_at);
  const auto points = on_screen(view, paint, muzzle + chassis.orientation * forward * length);
  if (points) paint.list().AddCircleFilled(*points, 0.16f * paint.em(), colour);
}

void draw_bars(const HudView& view, const HudPaint& paint) {
  const Gun& gun = own(view).gun;
  const float width = 12 * paint.em(), x = 0.5f * paint.size().x - 0.5f * width;
  const float y = paint.size().y - 3.6f * paint.em();
  paint.bar({x, y}, width, "energy", gun.energy, colours::kPictureText, false);
  paint.bar({x, y + 1.2f * paint.em()}, width, "heat", gun.heat, gun.overheated ? kBad : colours::accent(),
            true);
  const double boost = own(view).boost;
  if (boost < 1)
    paint.bar({x, y - 2.4f * paint.em()}, width, "boost", boost, colours::kPictureSecondary, true);
  if (view.steady != nullptr && view.steady->left() < 1)
    paint.bar({x, y - 1.2f * paint.em()}, width, "steady", view.steady->left(), colours::kPictureSecondary,
              false);
  if (gun.overheated)
    paint.text({x + width + 0.6f * paint.em(), y + 0.9f * paint.em()}, "OVERHEATED", kBad, 0.9f);
}

// The plan of a vehicle on the screen, with its front up.
struct Plan {
  ImVec2 middle;
  float scale;  // pixels per metre
  ImVec2 operator()(double x, double z) const {
    return {middle.x - scale * static_cast<float>(x), middle.y - scale * static_cast<float>(z)};
  }
};

// Half the length and width [m] of wheels, laser and vital parts, with some margin.
Vec2 half_size(const Vehicle& vehicle) {
  Vec2 half(0.5, 1);
  for (const WheelDescription& w : vehicle.what().wheels) {
    half.x = std::max(half.x, std::abs(w.hub.x) + 0.08);
    half.y = std::max(half.y, std::abs(w.hub.z) + 0.8);
  }
  return half;
}

void box(const HudPaint& paint, ImVec2 a, ImVec2 b, ImU32 colour, bool works) {
  const ImVec2 low(std::min(a.x, b.x), std::min(a.y, b.y)), high(std::max(a.x, b.x), std::max(a.y, b.y));
  if (works) {
    paint.list().AddRectFilled(low, high, colour, 2);
    return;
  }
  paint.list().AddRect(low, high, kBad, 2);
  paint.line(low, high, kBad, 1.5f);
  paint.line({low.x, high.y}, {high.x, low.y}, kBad, 1.5f);
}

constexpr double kTankHalf = 0.13;  // m, of the square that stands for a fuel tank

// Draws a vehicle from above in a rectangle of height `height` around `middle`: its outline, wheels, laser,
// engine, driver and fuel tank. Lost parts are crossed out.
void draw_vehicle_sketch(const Vehicle& vehicle, const HudPaint& paint, ImVec2 middle, float height) {
  const Vec2 half = half_size(vehicle);
  const Plan plan{middle, height / static_cast<float>(2 * half.y)};
  const ImU32 works = colours::kPictureText, outline = vehicle.alive ? colours::kPictureSecondary : kBad;
  paint.list().AddRect(plan(half.x * 0.9, half.y), plan(-half.x * 0.9, -half.y), outline, height * 0.09f, 0,
                       2);
  const auto& wheels = vehicle.what().wheels;
  KERF_ASSERT(vehicle.wheels.size() == wheels.size());
  for (size_t i = 0; i < wheels.size(); ++i) {
    const Vec3& hub = wheels[i].hub;
    const double r = wheels[i].radius;
    box(paint, plan(hub.x - 0.11, hub.z - r), plan(hub.x + 0.11, hub.z + r), works,
        vehicle.wheels[i].attached);
  }
  const size_t vitals = vehicle.what().vitals.size();
  KERF_ASSERT(vehicle.vital_works.size() == vitals && vehicle.model->vital_centres.size() == vitals);
  for (size_t i = 0; i < vitals; ++i) {
    const Vec3& at = vehicle.model->vital_centres[i];
    const bool engine = vehicle.what().vitals[i].kind == VitalDescription::Kind::kEngine;
    const double left = vehicle.vital_works[i] ? std::sqrt(std::clamp(vehicle.vital_left[i], 0.0, 1.0)) : 1;
    const double w = left * (engine ? 0.34 : 0.2), l = left * (engine ? 0.24 : 0.22);
    box(paint, plan(at.x - w, at.z - l), plan(at.x + w, at.z + l), colours::kPictureSecondary,
        vehicle.vital_works[i]);
  }
  if (vehicle.what().tank) {
    const Vec3& at = vehicle.model->tank_centre;
    box(paint, plan(at.x - kTankHalf, at.z - kTankHalf), plan(at.x + kTankHalf, at.z + kTankHalf),
        colours::accent(), vehicle.tank_whole);
  }
  const Vec3& pivot = vehicle.what().turret.pivot;
  const float radius = 0.17f * plan.scale;
  const ImU32 laser = vehicle.gun.works() ? colours::accent() : kBad;
  paint.circle(plan(pivot.x, pivot.z), radius, laser, 2);
  const double yaw = vehicle.gun.yaw;
  const Vec2 along(std::sin(yaw), std::cos(yaw));
  if (vehicle.gun.works())
    paint.line(plan(pivot.x, pivot.z), plan(pivot.x + 0.55 * along.x, pivot.z + 0.55 * along.y), laser, 2);
}

void draw_own_vehicle(const HudView& view, const HudPaint& paint) {
  const float em = paint.em(), height = 7.5f * em;
  const ImVec2 middle(4.2f * em, paint.size().y - 1.6f * em - 0.5f * height);
  paint.shade({middle.x - 3.2f * em, middle.y - 0.5f * height - 0.7f * em},
              {middle.x + 3.2f * em, middle.y + 0.5f * height + 0.7f * em});
  draw_vehicle_sketch(own(view), paint, middle, height);
  const Body& chassis = view.match.world().body(own(view).chassis);
  const double speed = glm::length(chassis.motion.velocity) * 3.6;
  const ImVec2 at(middle.x + 3.9f * em, paint.size().y - 3.6f * em);
  paint.text(at, number(speed), kText, 2);
  paint.text({at.x + paint.width_of(number(speed), 2) + 0.3f * em, at.y + 0.9f * em}, "km/h", kSecondary,
             0.9f);
}

std::string words_on_wave(const Match& match) {
  const Standing& standing = match.standing();
  if (match.rules().description.targets) return "Dismantle the target";
  std::string words =
      "Wave " + std::to_string(standing.wave + 1) + "/" + std::to_string(match.rules().waves.size());
  if (standing.cars_left == 0) return words + ", last car";
  return words + ", " + std::to_string(standing.cars_left) +
         (standing.cars_left == 1 ? " car left" : " cars left");
}

void draw_score(const HudView& view, const HudPaint& paint) {
  const Standing& standing = view.match.standing();
  const float em = paint.em();
  paint.plate_text({1.2f * em, 0.9f * em}, number(standing.score), kText, 2);
  const size_t waves = view.match.rules().waves.size();
  if (waves == 0 || view.task) return;
  paint.plate_text({1.2f * em, 3.1f * em}, words_on_wave(view.match), kSecondary, 0.95f);
  const double left = view.match.seconds_left();
  paint.plate_text({paint.size().x - 1.2f * em, 0.9f * em}, clock_text(left), left < 30 ? kBad : kText, 2,
                   Align::kRight);
  size_t enemies = 0;
  for (size_t i = 1; i < view.match.vehicles().size(); ++i) enemies += view.match.vehicles()[i].alive;
  paint.plate_text({paint.size().x - 1.2f * em, 3.1f * em},
                   std::to_string(enemies) + (enemies == 1 ? " enemy" : " enemies"), kSecondary, 0.95f,
                   Align::kRight);
}

void draw_state(const HudView& view, const HudPaint& paint) {
  const float em = paint.em();
  if (!view.machine.empty()) paint.plate_text({1.2f * em, 4.4f * em}, view.machine, kSecondary, 0.8f);
  if (view.match.standing().phase == Standing::Phase::kPause && !view.match.has_upgraded())
    paint.plate_text({0.5f * paint.size().x, 0.42f * paint.size().y},
                     view.gamepad
                         ? "Upgrade with the D-pad: left cooler laser, up faster charging, right armour"
                         : "Upgrade: 1 cooler laser, 2 faster charging, 3 armour",
                     kText, 1.3f, Align::kMiddle);
  const std::string hint =
      give_up_hint(view.match, control_label(GameAction::kNextCar, view.keys, view.gamepad));
  if (!hint.empty())
    paint.plate_text({0.5f * paint.size().x, 0.42f * paint.size().y}, hint, kBad, 1.4f, Align::kMiddle);
}

// An arrow on a circle around the middle, pointing to an off-screen place.
void draw_arrow(const HudView& view, const HudPaint& paint, const Vec3& to, ImU32 colour,
                const std::string& text) {
  const Vec3 way = to - view.camera.eye;
  const double right = glm::dot(way, view.camera.right), ahead = glm::dot(way, view.camera.forward);
  const double angle = std::atan2(right, ahead);
  const float sine = static_cast<float>(std::sin(angle)), cosine = static_cast<float>(std::cos(angle));
  const float radius = 0.32f * std::min(paint.size().x, paint.size().y), em = paint.em();
  const ImVec2 middle(0.5f * paint.size().x, 0.5f * paint.size().y);
  const ImVec2 tip(middle.x + sine * radius, middle.y - cosine * radius);
  const ImVec2 base(middle.x + sine * (radius - 0.9f * em), middle.y - cosine * (radius - 0.9f * em));
  const ImVec2 side(cosine * 0.45f * em, sine * 0.45f * em);
  paint.list().AddTriangleFilled(tip, {base.x + side.x, base.y + side.y}, {base.x - side.x, base.y - side.y},
                                 colour);
  paint.plate_text({base.x - sine * 1.2f * em, base.y + cosine * 1.2f * em - 0.5f * em}, text, colour, 0.8f,
                   Align::kMiddle);
}

// A triangle over an enemy with its distance; an outline if something hides the enemy.
void draw_marker(const HudPaint& paint, ImVec2 tip, const std::string& text, bool seen) {
  const float em = paint.em();
  const ImVec2 left(tip.x - 0.35f * em, tip.y - 0.55f * em), right(tip.x + 0.35f * em, tip.y - 0.55f * em);
  if (seen) {
    paint.list().AddTriangleFilled(tip, left, right, kBad);
  } else {
    paint.line(tip, left, kBad, 1.5f);
    paint.line(left, right, kBad, 1.5f);
    paint.line(right, tip, kBad, 1.5f);
  }
  paint.plate_text({tip.x, tip.y - 1.9f * em}, text, seen ? kText : kSecondary, 0.8f, Align::kMiddle);
}

void draw_enemies(const HudView& view, const HudPaint& paint) {
  for (size_t i = 1; i < view.match.vehicles().size(); ++i) {
    const Vehicle& enemy = view.match.vehicles()[i];
    if (!enemy.alive) continue;
    const Vec3 at = view.match.world().body(enemy.chassis).placement.to_world({0, 1, 0});
    const double distance = glm::length(at - view.camera.eye);
    const std::string text = number(distance) + " m";
    const auto seen = on_screen(view, paint, at);
    if (!seen || !is_inside(paint, *seen, 2 * paint.em())) {
      draw_arrow(view, paint, at, kBad, text);
      continue;
    }
    if (view.sighted && view.sighted->vehicle == i) continue;
    if (const auto above = on_screen(view, paint, at + Vec3(0, 1.4, 0)))
      draw_marker(paint, *above, text, sees_vehicle(view.match, view.sight, view.camera.eye, i));
  }
}

// Thin lines along the lasers that are about to fire for the first time.
void draw_warnings(const HudView& view, const HudPaint& paint) {
  const double range = view.match.rules().description.laser.range;
  for (size_t i = 1; i < view.match.vehicles().size(); ++i) {
    const Vehicle& enemy = view.match.vehicles()[i];
    if (!enemy.is_announcing()) continue;
    const Pose pose = muzzle_pose(view.match.world(), enemy);
    const auto hit = view.sight.nearest(pose, range, [&](BodyId id) { return !enemy.has(id); });
    const double length = hit ? hit->length : range;
    // The part before the eye: depth along the line is linear.
    const double depth = glm::dot(pose.origin - view.camera.eye, view.camera.forward);
    const double deeper = glm::dot(pose.direction, view.camera.forward);
    double from = 0, to = length;
    if (depth + from * deeper < kNearEye) from = deeper > 0 ? (kNearEye - depth) / deeper : length;
    if (depth + to * deeper < kNearEye) to = deeper < 0 ? (kNearEye - depth) / deeper : 0;
    if (!(from < to)) continue;
    const auto a = on_screen(view, paint, pose.origin + from * pose.direction);
    const auto b = on_screen(view, paint, pose.origin + to * pose.direction);
    if (a && b) paint.line(*a, *b, kBad, 1.5f);
  }
}

// Names the sighted part next to the reticle, and draws its vehicle with its damage at the right.
void draw_sighted(const HudView& view, const HudPaint& paint) {
  if (!view.sighted) return;
  const float em = paint.em(), height = 6 * em;
  const Vehicle& enemy = view.match.vehicles()[view.sighted->vehicle];
  if (const auto at = on_screen(view, paint, view.sighted->at)) {
    const std::string distance = number(glm::distance(view.sighted->at, view.camera.eye)) + " m";
    paint.plate_text({at->x + 1.6f * em, at->y - 0.5f * em}, view.sighted->name, kText, 1);
    paint.text({at->x + 1.6f * em, at->y + 0.6f * em}, distance, kSecondary, 0.8f);
  }
  const ImVec2 middle(paint.size().x - 4.2f * em, 5.6f * em + 0.5f * height);
  paint.shade({middle.x - 3.2f * em, middle.y - 0.5f * height - 0.6f * em},
              {middle.x + 3.2f * em, middle.y + 0.5f * height + 1.8f * em});
  draw_vehicle_sketch(enemy, paint, middle, height);
  paint.text({middle.x, middle.y + 0.5f * height + 0.4f * em}, enemy.what().name, kSecondary, 0.9f,
             Align::kMiddle);
}

// An arc around the reticle on the side of an attacker; `angle` is to the right of the view [rad].
void draw_hit_ring(const HudPaint& paint, double angle, ImU32 colour) {
  const ImVec2 middle(0.5f * paint.size().x, 0.5f * paint.size().y);
  const auto towards = static_cast<float>(angle - 0.5 * kPi), half = 0.5f;
  ImDrawList& list = paint.list();
  list.PathArcTo(middle, 4 * paint.em(), towards - half, towards + half, 24);
  list.PathStroke(colour, 0, 0.5f * paint.em());
}

// Highlights the border of the screen in the direction of the hit.
void draw_hurt(const HudView& view, const HudPaint& paint) {
  if (!(view.state.hurt() > 0)) return;
  const ImU32 colour = HudPaint::faded(kBad, 0.5 * view.state.hurt()), none = HudPaint::faded(kBad, 0);
  const ImVec2 size = paint.size();
  const float wide = 4 * paint.em();
  const Vec3 way = view.state.hurt_from() - view.camera.eye;
  const double right = glm::dot(way, view.camera.right), ahead = glm::dot(way, view.camera.forward);
  ImDrawList& list = paint.list();
  if (std::abs(right) < std::abs(ahead)) {
    const float y = ahead > 0 ? 0 : size.y - wide;
    const ImU32 top = ahead > 0 ? colour : none, bottom = ahead > 0 ? none : colour;
    list.AddRectFilledMultiColor({0, y}, {size.x, y + wide}, top, top, bottom, bottom);
  } else {
    const float x = right > 0 ? size.x - wide : 0;
    const ImU32 at_left = right > 0 ? none : colour, at_right = right > 0 ? colour : none;
    list.AddRectFilledMultiColor({x, 0}, {x + wide, size.y}, at_left, at_right, at_right, at_left);
  }
  draw_hit_ring(paint, std::atan2(right, ahead), HudPaint::faded(kBad, view.state.hurt()));
}

// Pulses around the parts of enemies that a steady aim can reach.
void draw_pulses(const HudView& view, const HudPaint& paint) {
  if (view.steady == nullptr || !view.steady->is_on()) return;
  const double range = view.match.rules().description.laser.range;
  const double beat = 0.5 + 0.5 * std::sin(2 * kPi * kPulses * view.state.clock());
  const ImU32 colour = HudPaint::faded(colours::accent(), 0.4 + 0.6 * beat);
  for (size_t i = 1; i < view.match.vehicles().size(); ++i) {
    const Vehicle& enemy = view.match.vehicles()[i];
    if (!enemy.alive || !sees_vehicle(view.match, view.sight, view.camera.eye, i)) continue;
    for (const Vec3& part : parts_to_cut(enemy)) {
      const Vec3 place = in_world(view.match.world(), enemy, part);
      const auto at = on_screen(view, paint, place);
      if (!at || glm::distance(place, view.camera.eye) > range) continue;
      paint.circle(*at, paint.em() * static_cast<float>(0.35 + 0.2 * beat), colour, 2);
    }
  }
}

void draw_notices(const HudView& view, const HudPaint& paint) {
  const float em = paint.em();
  float y = 0.36f * paint.size().y, y_large = 0.2f * paint.size().y;
  for (const Notice& n : view.state.notices() | std::views::reverse) {
    const double opacity = std::min(1.0, 3 * (n.large ? 2.2 - n.age : 3.2 - n.age));
    const ImU32 colour = HudPaint::faded(n.good ? kText : kBad, opacity);
    const std::string times = n.times > 1 ? "  x" + std::to_string(n.times) : "";
    const std::string points = times + (n.points > 0 ? "  +" + number(n.points) : "");
    if (n.large) {
      paint.plate_text({0.5f * paint.size().x, y_large}, n.text + points, colour, 2.4f, Align::kMiddle);
      y_large += 3.1f * em;
      continue;
    }
    paint.plate_text({paint.size().x - 1.2f * em, y}, n.text + points, colour, 1, Align::kRight);
    y += 1.6f * em;
  }
}

void draw_points(const HudView& view, const HudPaint& paint) {
  for (const FlyingPoints& p : view.state.points()) {
    const auto at = on_screen(view, paint, p.at);
    if (!at) continue;
    const double share = p.age / FlyingPoints::kSeconds;
    const ImU32 colour = HudPaint::faded(colours::accent(), std::min(1.0, 3 * (1 - share)));
    const std::string combo = p.combo > 1 ? "  x" + std::to_string(p.combo) : "";
    const auto rise = static_cast<float>(kFlyHeight * share * (2 - share)) * paint.em();
    paint.text({at->x, at->y - rise}, "+" + number(p.points) + combo, colour, 1.5f, Align::kMiddle);
  }
}

// The place of a task with its text, and a line on how to skip the tutorial.
void draw_task(const HudView& view, const HudPaint& paint) {
  if (!view.task) return;
  const float em = paint.em();
  const ImU32 colour = colours::accent();
  const float width = std::max(paint.width_of(view.task->text, 1.3f), paint.width_of(kSkip, 0.9f));
  const ImVec2 top(0.5f * paint.size().x, 5 * em);
  paint.shade({top.x - 0.5f * width - em, top.y - 0.6f * em}, {top.x + 0.5f * width + em, top.y + 3.6f * em});
  paint.text(top, view.task->text, kText, 1.3f, Align::kMiddle);
  paint.text({top.x, top.y + 2.1f * em}, kSkip, kSecondary, 0.9f, Align::kMiddle);
  const std::string distance = number(glm::distance(view.task->at, view.camera.eye)) + " m";
  const auto at = on_screen(view, paint, view.task->at);
  if (!at || !is_inside(paint, *at, 2 * em)) return draw_arrow(view, paint, view.task->at, colour, distance);
  paint.circle(*at, 1.6f * em, colour, 2.5f);
  paint.list().AddTriangleFilled({at->x, at->y - 2 * em}, {at->x - 0.5f * em, at->y - 2.8f * em},
                                 {at->x + 0.5f * em, at->y - 2.8f * em}, colour);
  paint.text({at->x, at->y - 4.2f * em}, distance, kText, 0.9f, Align::kMiddle);
}

void draw_guide(const HudPaint& paint, const std::vector<std::string>& lines) {
  static constexpr float kLine = 1.45f;  // em
  const float em = paint.em();
  float width = 0;
  for (const std::string& line : lines) width = std::max(width, paint.width_of(line, 1));
  const float x = 0.5f * paint.size().x, y = 1.5f * em;
  const ImVec2 from(x - 0.5f * width - em, y - 0.6f * em),
      to(x + 0.5f * width + em, y + (kLine * static_cast<float>(lines.size()) + 0.2f) * em);
  paint.shade(from, to);
  mark_area("help", {{from.x, from.y}, {to.x - from.x, to.y - from.y}});
  for (size_t i = 0; i < lines.size(); ++i)
    paint.text({x, y + kLine * em * static_cast<float>(i)}, lines[i], kText, 1, Align::kMiddle);
}

// Enlarged text would be blurred.
ImFont* font_of(float scale) { return scale > 1.2f ? &large_font() : ImGui::GetFont(); }

}  // namespace

HudPaint::HudPaint() : list_(*ImGui::GetBackgroundDrawList()), size_(ImGui::GetIO().DisplaySize) {
  em_ = std::min({ImGui::GetFontSize(), size_.x / kMinWide, size_.y / kMinHigh});
}

ImU32 HudPaint::faded(ImU32 colour, double opacity) {
  const auto alpha =
      static_cast<ImU32>(std::clamp(opacity, 0.0, 1.0) * ((colour >> IM_COL32_A_SHIFT) & 0xff));
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

void HudPaint::plate_text(ImVec2 at, const std::string& text, ImU32 colour, float scale, Align align) const {
  const float width = width_of(text, scale), height = em_ * scale, pad = 0.3f * em_;
  const float left = at.x - width * (align == Align::kLeft ? 0.0f : align == Align::kMiddle ? 0.5f : 1.0f);
  const double opacity = ((colour >> IM_COL32_A_SHIFT) & 0xff) / 255.0;
  list_.AddRectFilled({left - pad, at.y - 0.3f * pad}, {left + width + pad, at.y + height + 0.3f * pad},
                      faded(colours::kPictureShade, opacity), 4);
  this->text({left, at.y}, text, colour, scale);
}

float HudPaint::width_of(const std::string& text, float scale) const {
  return font_of(scale)->CalcTextSizeA(em_ * scale, FLT_MAX, 0, text.c_str()).x;
}

void HudPaint::text(ImVec2 at, const std::string& text, ImU32 colour, float scale, Align align) const {
  if (align != Align::kLeft) at.x -= width_of(text, scale) * (align == Align::kMiddle ? 0.5f : 1.0f);
  const ImU32 edge = faded(kEdge, ((colour >> IM_COL32_A_SHIFT) & 0xff) / 255.0);
  const float off = std::max(1.0f, em_ * scale / 16);
  for (const ImVec2 by : {ImVec2(off, 0), ImVec2(-off, 0), ImVec2(0, off), ImVec2(0, -off)})
    list_.AddText(font_of(scale), em_ * scale, {at.x + by.x, at.y + by.y}, edge, text.c_str());
  list_.AddText(font_of(scale), em_ * scale, at, colour, text.c_str());
}

void HudPaint::bar(ImVec2 at, float width, const char* name, double share, ImU32 colour, bool striped) const {
  const float height = 0.55f * em_, scale = 0.9f;
  text({at.x - 0.6f * em_, at.y + 0.5f * (height - scale * em_)}, name, colours::kPictureText, scale,
       Align::kRight);
  list_.AddRectFilled({at.x - 2, at.y - 2}, {at.x + width + 2, at.y + height + 2}, kEdge, 3);
  const float end = at.x + width * static_cast<float>(std::clamp(share, 0.0, 1.0));
  list_.AddRectFilled(at, {end, at.y + height}, colour, 2);
  for (float x = at.x; striped && x + height < end; x += 1.1f * height)
    list_.AddLine({x, at.y + height}, {x + height, at.y}, kEdge, 2);
}

void HudPaint::line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const {
  list_.AddLine(from, to, kEdge, width + 2);
  list_.AddLine(from, to, colour, width);
}

void HudPaint::circle(ImVec2 at, float radius, ImU32 colour, float width) const {
  list_.AddCircle(at, radius, kEdge, 0, width + 2);
  list_.AddCircle(at, radius, colour, 0, width);
}

void HudPaint::shade(ImVec2 from, ImVec2 to) const {
  list_.AddRectFilled(from, to, colours::kPictureShade, 4);
}

void draw_hud(const HudView& view) {
  const HudPaint paint;
  // After a wreck another camera shows its cause: directions to enemies would point at nothing.
  if (own(view).alive) {
    draw_hurt(view, paint);
    if (!view.task) draw_enemies(view, paint);
    draw_warnings(view, paint);
    draw_pulses(view, paint);
    draw_sighted(view, paint);
    draw_reticle(view, paint);
    draw_bars(view, paint);
  }
  draw_own_vehicle(view, paint);
  draw_score(view, paint);
  draw_state(view, paint);
  draw_points(view, paint);
  draw_notices(view, paint);
  draw_task(view, paint);
  if (!view.guide.empty() && !view.task) draw_guide(paint, view.guide);
}

}  // namespace kerf
