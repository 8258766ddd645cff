#include "ui/game/aim_help.h"

#include "core/base/angle.h"

namespace kerf {

namespace {

constexpr double kReach = 0.06;  // rad, from the aim
constexpr double kPull = 2.2;    // 1/s
constexpr double kFar = 45;      // m

}  // namespace

void help_aim(const Match& match, PlayerInput& input, double seconds) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  const Placement& chassis = match.world().body(own.chassis).placement;
  const Vec3 eye = chassis.to_world(own.what().turret.barrel.pivot), aim = input.direction(chassis);
  double nearest = kReach, left = 0, up = 0;
  for (size_t i = 1; i < match.vehicles().size(); ++i) {
    const Vehicle& enemy = match.vehicles()[i];
    if (!enemy.alive) continue;
    const Vec3 way = match.world().body(enemy.chassis).placement.to_world({0, 0.8, 0}) - eye;
    const double distance = glm::length(way);
    if (!(distance > 0) || distance > kFar) continue;
    const double turn = wrapped(heading_of(way) - heading_of(aim)),
                 rise = pitch_of(way / distance) - pitch_of(aim);
    const double off = glm::length(Vec2(turn, rise));
    if (off >= nearest) continue;
    nearest = off;
    left = turn;
    up = rise;
  }
  const double share = std::min(1.0, kPull * seconds);
  input.turn(left * share, up * share);
}

}  // namespace kerf
