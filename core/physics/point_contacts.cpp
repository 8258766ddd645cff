#include "core/physics/point_contacts.h"

#include <algorithm>
#include <optional>

namespace kerf {

namespace {

// How much nearer than a face, relative to the reach, a point is put that slides along it.
constexpr double kLift = 1e-3;

struct Plane {
  Vec3 at{0};
  Vec3 normal{0};  // unit, towards the point
  double distance_to(const Vec3& p) const { return glm::dot(p - at, normal); }
};

// Follows one point among the faces.
class PointProbe {
 public:
  PointProbe(const Body& body, double reach) : body_(body), reach_(reach) {}

  // The first face from `from` towards `to`, its normal towards `from`.
  std::optional<Plane> between(const Vec3& from, const Vec3& to) const {
    const Vec3 way = to - from;
    const double length = glm::length(way);
    if (!(length > 0)) return std::nullopt;
    return along(from, way / length, length);
  }

  std::optional<Plane> along(const Vec3& from, const Vec3& direction, double length) const {
    const auto hit = body_.tree.nearest(body_.mesh, Pose{from, direction}, {0, length});
    if (!hit) return std::nullopt;
    const Triangle t = body_.mesh.triangle(hit->face);
    Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double area = glm::length(normal);
    if (!(area > 0)) return std::nullopt;
    normal /= area;
    if (glm::dot(normal, direction) > 0) normal = -normal;
    return Plane{from + hit->length * direction, normal};
  }

  // The nearest plane around a point that is free.
  std::optional<Plane> near(const Collider::Point& own, const glm::dmat3& turn, const PointMemory& memory,
                            const Vec3& next) const {
    std::optional<Plane> best;
    const auto offer = [&](const std::optional<Plane>& plane) {
      if (plane && (!best || plane->distance_to(memory.free) < best->distance_to(memory.free))) best = plane;
    };
    if (memory.normal != Vec3(0)) offer(along(memory.free, -memory.normal, reach_));
    const Vec3 way = next - memory.free;
    const double length = glm::length(way);
    if (length > 0) offer(along(memory.free, way / length, length + reach_));
    if (best) return best;
    const Vec3 normal = turn * own.normal;
    if (normal != Vec3(0)) {
      offer(along(memory.free, normal, reach_));
      offer(along(memory.free, -normal, reach_));
    }
    if (own.outward != Vec3(0)) offer(along(memory.free, turn * own.outward, reach_));
    return best;
  }

  // Brings a point that went through a plane back to its side, as near as nothing lies between.
  void slide(const Vec3& is_at, const Plane& plane, PointMemory& memory) const {
    const Vec3 target = is_at + (kLift * reach_ - plane.distance_to(is_at)) * plane.normal;
    if (const auto blocked = between(memory.free, target)) {
      memory.free = blocked->at + kLift * reach_ * blocked->normal;
      return;
    }
    memory.free = target;
  }

 private:
  const Body& body_;
  double reach_;
};

bool lies_in(const Vec3& p, const Vec3& min, const Vec3& max) {
  return glm::all(glm::greaterThanEqual(p, min)) && glm::all(glm::lessThanEqual(p, max));
}

}  // namespace

void find_point_contacts(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
                         std::vector<PointMemory>& memory, std::vector<Contact>& out) {
  const double scale = std::min(points.scale, faces.scale);
  const double reach = lengths.reach * scale, skin = lengths.skin * scale;
  const RigidMap now = into(faces.now, points.now), next = into(faces.next, points.next);
  const Vec3 min = faces.collider->min - reach, max = faces.collider->max + reach;
  const PointProbe probe(*faces.body, reach);
  std::vector<PointMemory> known;
  auto old = memory.begin();
  for (uint32_t i = 0; i < points.collider->points.size(); ++i) {
    while (old != memory.end() && old->point < i) ++old;
    const bool remembered = old != memory.end() && old->point == i;
    const Collider::Point& own = points.collider->points[i];
    const Vec3 is_at = now(own.at), will_be = next(own.at);
    if (!remembered && !lies_in(is_at, min, max) &&
        !glm::all(glm::lessThanEqual(glm::min(is_at, will_be), max) &&
                  glm::greaterThanEqual(glm::max(is_at, will_be), min)))
      continue;
    PointMemory m = remembered ? *old : PointMemory{i, is_at, Vec3(0)};
    std::optional<Plane> plane = probe.between(m.free, is_at);
    if (plane) {
      probe.slide(is_at, *plane, m);
    } else {
      m.free = is_at;
      plane = probe.near(own, now.turn, m, will_be);
    }
    m.normal = plane ? plane->normal : Vec3(0);
    if (plane || lies_in(m.free, min, max)) known.push_back(m);
    if (!plane) continue;
    Contact& contact = out.emplace_back();
    contact.at = faces.now(is_at);
    contact.normal = faces.now.turn * plane->normal;
    contact.distance = plane->distance_to(is_at) - skin;
    contact.feature = i;
  }
  memory = std::move(known);
}

}  // namespace kerf
