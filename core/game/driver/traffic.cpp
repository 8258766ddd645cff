#include "core/game/driver/traffic.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

constexpr double kSmall = 0.8;  // m, the diagonal of what vehicles drive over
constexpr double kFlat = 0.25;  // m, likewise the height

bool is_carried(std::span<const Vehicle> vehicles, BodyId id) {
  return std::any_of(vehicles.begin(), vehicles.end(),
                     [&](const Vehicle& v) { return v.chassis != id && v.has(id); });
}

// Covers a box of a body by discs along its longest side.
void cover(const Body& body, BodyId id, const AabbTree::Box& box, std::vector<Disc>& discs) {
  const glm::dmat3 turn = glm::mat3_cast(body.placement.orientation);
  const Vec3 middle = body.placement.to_world(0.5 * (box.min + box.max)), half = 0.5 * (box.max - box.min);
  int longest = 0, second = 0;
  double lengths[3], height = 0;
  for (int k = 0; k < 3; ++k) {
    lengths[k] = half[k] * glm::length(Vec2(turn[k].x, turn[k].z));
    height += half[k] * std::abs(turn[k].y);
    if (lengths[k] > lengths[longest]) longest = k;
  }
  if (2 * height < kFlat) return;
  second = longest == 0 ? 1 : 0;
  for (int k = 0; k < 3; ++k) {
    if (k != longest && lengths[k] > lengths[second]) second = k;
  }
  const double radius = std::max(lengths[second], 0.2), reach = std::max(lengths[longest] - radius, 0.0);
  const int count = 1 + static_cast<int>(std::ceil(reach / radius));
  for (int i = 0; i < count; ++i) {
    const double along = count > 1 ? -reach + 2 * reach * i / (count - 1) : 0.0;
    const Vec3 way = half[longest] > 0 ? along * turn[longest] : Vec3(0);
    discs.push_back({middle + way, radius, body.motion.velocity, id});
  }
}

}  // namespace

std::vector<Disc> find_traffic(const World& world, std::span<const Vehicle> vehicles) {
  std::vector<Disc> discs;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.pinned || body.hidden || body.tree.leaf_count() == 0) continue;
    const AabbTree::Box box = body.tree.bounds();
    if (glm::length(box.max - box.min) < kSmall || is_carried(vehicles, id)) continue;
    cover(body, id, box, discs);
  }
  return discs;
}

}  // namespace kerf
