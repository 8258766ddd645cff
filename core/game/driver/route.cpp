#include "core/game/driver/route.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace kerf {

namespace {

constexpr double kComfort = 2.2;   // m, the clearance from which on there is no detour for more
constexpr double kNarrow = 1.2;    // times the length, for each metre less
constexpr double kNoRoom = 20;     // times the length, where there is no room
constexpr float kInTraffic = 6;    // times the length
constexpr double kAroundGoal = 8;  // m
constexpr double kBeside = 1.0;    // m, to traffic
using Spot = FreeSpace::Spot;

class Search {
 public:
  Search(const FreeSpace& space, std::span<const Disc> traffic)
      : space_(space), extra_(space.spots(), 0), costs_(space.spots(), kUnknown), before_(space.spots(), 0) {
    for (const Disc& disc : traffic) mark(disc);
  }

  std::vector<Vec3> find(Spot from, Spot to) {
    goal_ = space_.place_of(to);
    costs_[from] = 0;
    open_.push({static_cast<float>(glm::distance(space_.place_of(from), goal_)), from});
    while (!open_.empty()) {
      const auto [estimate, spot] = open_.top();
      open_.pop();
      if (spot == to) return way_to(to, from);
      if (estimate > costs_[spot] + rest(spot) + 1e-3f) continue;  // a cheaper way was found meanwhile
      expand(spot);
    }
    return {};
  }

 private:
  static constexpr float kUnknown = std::numeric_limits<float>::infinity();
  struct Open {
    float estimate;
    Spot spot;
    bool operator<(const Open& other) const {
      return estimate != other.estimate ? estimate > other.estimate : spot > other.spot;
    }
  };

  float rest(Spot spot) const { return static_cast<float>(glm::distance(space_.place_of(spot), goal_)); }

  void mark(const Disc& disc) {
    const double reach = disc.radius + kBeside;
    for (double dz = -reach; dz <= reach; dz += FreeSpace::kCell) {
      for (double dx = -reach; dx <= reach; dx += FreeSpace::kCell) {
        if (dx * dx + dz * dz <= reach * reach)
          extra_[space_.spot_at(disc.centre + Vec3(dx, 0, dz))] = kInTraffic;
      }
    }
  }

  void expand(Spot spot) {
    const bool room = space_.has_room(spot);
    space_.for_each_beside(spot, [&](Spot to, double metres) {
      if (room && !space_.has_room(to)) return;
      const double lacking = std::max(0.0, kComfort - space_.clearance(to));
      const double factor = (room ? 1 : kNoRoom) + kNarrow * lacking + extra_[to];
      const float cost = costs_[spot] + static_cast<float>(metres * factor);
      if (cost >= costs_[to]) return;
      costs_[to] = cost;
      before_[to] = spot;
      open_.push({cost + rest(to), to});
    });
  }

  std::vector<Vec3> way_to(Spot spot, Spot from) const {
    std::vector<Vec3> way{space_.place_of(spot)};
    while (spot != from) {
      spot = before_[spot];
      way.push_back(space_.place_of(spot));
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  const FreeSpace& space_;
  Vec3 goal_{0};
  std::vector<float> extra_;  // by spot, times the length
  std::vector<float> costs_;
  std::vector<Spot> before_;
  std::priority_queue<Open> open_;
};

}  // namespace

std::vector<Vec3> find_route(const FreeSpace& space, std::span<const Disc> traffic, const Vec3& from,
                             const Vec3& to) {
  if (space.spots() == 0) return {from, to};
  const Spot goal = space.with_room_near(to, kAroundGoal);
  return goal == space.spots() ? std::vector<Vec3>{} : Search(space, traffic).find(space.spot_at(from), goal);
}

}  // namespace kerf
