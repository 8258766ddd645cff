#include "core/game/driver/driver_view.h"

#include <algorithm>
#include <cmath>

#include "core/base/geometry.h"

namespace kerf {

namespace {

constexpr double kSmall = 0.8;      // m, diagonal of bodies that vehicles drive over
constexpr double kFlat = 0.25;      // m, their height
constexpr double kTall = 3.5;       // m, height above which bodies over a vehicle are ignored
constexpr double kUnderRoof = 2.2;  // m

bool is_carried(std::span<const Vehicle> vehicles, BodyId id) {
  return std::any_of(vehicles.begin(), vehicles.end(),
                     [&](const Vehicle& v) { return v.chassis != id && v.has(id); });
}

// The height of a point of a body in the world [m].
double height_of(const Body& body, const Vec3& p) { return body.placement.to_world(p).y; }

Interval heights_of(const Body& body, const Bounds& box) {
  Interval heights{height_of(body, box.min), height_of(body, box.min)};
  for (int corner = 1; corner < 8; ++corner) {
    const Vec3 p((corner & 1 ? box.max : box.min).x, (corner & 2 ? box.max : box.min).y,
                 (corner & 4 ? box.max : box.min).z);
    heights.low = std::min(heights.low, height_of(body, p));
    heights.high = std::max(heights.high, height_of(body, p));
  }
  return heights;
}

// The box of those faces of a tall body that extend below the roof of a vehicle.
Bounds low_box(const Body& body, double below) {
  Bounds low{Vec3(1e300), Vec3(-1e300)};
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    if (!body.mesh.is_live(FaceId(slot))) continue;
    const Triangle t = body.mesh.triangle(FaceId(slot));
    if (std::ranges::none_of(t, [&](const Vec3& p) { return height_of(body, p) < below; })) continue;
    for (const Vec3& p : t) {
      low.min = glm::min(low.min, p);
      low.max = glm::max(low.max, p);
    }
  }
  return low;
}

void cover(const Body& body, BodyId id, const Bounds& box, std::vector<Disc>& discs) {
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
    Bounds box = body.bounds();
    if (glm::length(box.max - box.min) < kSmall || is_carried(vehicles, id)) continue;
    const Interval heights = heights_of(body, box);
    if (heights.high - heights.low > kTall) box = low_box(body, heights.low + kUnderRoof);
    if (box.min.x <= box.max.x) cover(body, id, box, discs);
  }
  return discs;
}

}  // namespace kerf
