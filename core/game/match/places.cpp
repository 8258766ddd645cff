#include "core/game/match/places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/angle.h"
#include "core/game/driver/route.h"

namespace kerf {

namespace {

constexpr double kStartsAway = 30;  // m, of the way of enemies to the player
constexpr double kGap = 2.5;        // m, between a vehicle that comes and other things

double length_of(const std::vector<Vec3>& way) {
  double length = 0;
  for (size_t i = 1; i < way.size(); ++i) length += glm::distance(way[i - 1], way[i]);
  return length;
}

bool has_room(const Vec3& place, const FreeSpace& space, std::span<const Disc> traffic) {
  if (space.spots() > 0 && !space.has_room(space.spot_at(place))) return false;
  return std::ranges::none_of(
      traffic, [&](const Disc& disc) { return glm::distance(disc.centre, place) < disc.radius + kGap; });
}

}  // namespace

std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player) {
  std::vector<std::pair<double, Start>> starts;
  for (const Start& start : arena.enemies) {
    const std::vector<Vec3> way = find_route(space, {}, start.position, player);
    const double length = way.empty() ? glm::distance(start.position, player) : length_of(way);
    starts.emplace_back(std::abs(length - kStartsAway), start);
  }
  std::ranges::stable_sort(starts, {}, &std::pair<double, Start>::first);
  std::vector<Start> sorted;
  for (const auto& [off, start] : starts) sorted.push_back(start);
  return sorted;
}

std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic) {
  const double heading = heading_of(vehicle.orientation * Vec3(0, 0, 1));
  for (const double turn : {0.0, 0.35, -0.35, 0.7, -0.7, 1.4, -1.4, 2.4, -2.4, kPi}) {
    for (const double away : {7.0, 9.0, 11.0, 13.0}) {
      const Vec3 there = vehicle.position + away * direction_of(wrapped(heading + turn), 0);
      if (!has_room(there, space, traffic)) continue;
      const Vec3 at = space.spots() > 0 ? space.place_of(space.spot_at(there)) : there;
      return Placement{at, turn_about({0, 1, 0}, heading + 0.5 * kPi)};
    }
  }
  return std::nullopt;
}

}  // namespace kerf
