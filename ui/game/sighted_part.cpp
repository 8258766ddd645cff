#include "ui/game/sighted_part.h"

#include "core/base/assert.h"
#include "core/game/vehicle/vehicle_bodies.h"
#include "ui/game/match_words.h"

namespace kerf {

namespace {

constexpr double kPartWithin = 0.5;          // m, of a place on the chassis to the part that it is named after
constexpr double kMiddleHeight = 0.8;  // m, of a vehicle over its origin

// The name of a place on the chassis (m, in its frame), after the nearest part that hangs on it there.
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
    offer(what.wheels[i].hub, vehicle.wheels[i].attached, "mount of the " + name_of_wheel(what, i));
  offer(what.turret.pivot, vehicle.gun.turret_attached, "mount of the laser");
  return name;
}

std::string name_of_part(const World& world, const Vehicle& vehicle, BodyId body, const Vec3& at) {
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (vehicle.wheels[i].body == body) return name_of_wheel(vehicle.what(), i);
  }
  if (body != vehicle.chassis) return "laser";
  return name_on_chassis(vehicle, world.body(body).placement.to_body(at));
}

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
  const auto hit = sight.nearest({from, aim}, range, [&](BodyId id) { return !own.has(id); });
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

}  // namespace kerf
