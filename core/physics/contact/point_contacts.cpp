#include "core/physics/contact/point_contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/assert.h"
#include "core/physics/contact/chord_points.h"
#include "core/physics/contact/face_plane.h"

namespace kerf {

namespace {

// Follows the points of one body among the faces of another.
class PointTracker {
 public:
  PointTracker(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
               const std::vector<PointMemory>& memory, std::vector<Contact>& out)
      : points_(*points.collider),
        faces_(faces),
        reach_(lengths.reach * std::min(points.scale, faces.scale)),
        skin_(lengths.skin * std::min(points.scale, faces.scale)),
        now_(into(faces.now, points.now)),
        next_(into(faces.next, points.next)),
        around_(faces.collider->bounds.wider(reach_)),
        memory_(memory),
        out_(out) {}

  // Returns what is to be remembered.
  std::vector<PointMemory> track() {
    const auto near = [&](const Cluster& cluster) {
      const Box way = way_of(cluster, now_, next_);
      return way.overlaps(around_) && faces_.collider->space.meets(way.wider(reach_));
    };
    points_.point_clusters.for_each(near, [&](uint32_t i) { follow(i, remembered_normal(i)); });
    while (old_ < memory_.size() && memory_[old_].point < points_.points.size()) ++old_;
    for (; old_ < memory_.size(); ++old_) follow(memory_[old_].point, &memory_[old_].normal);
    return std::move(known_);
  }

 private:
  // Precondition: points are asked for in their order.
  const Vec3* remembered_normal(uint32_t i) {
    while (old_ < memory_.size() && memory_[old_].point < i) ++old_;
    return old_ < memory_.size() && memory_[old_].point == i ? &memory_[old_].normal : nullptr;
  }

  void follow(uint32_t i, const Vec3* normal) {
    const Collider::Point own = point_of(points_, i);
    const Vec3 is_at = now_(own.at), will_be = next_(own.at);
    const Box way{glm::min(is_at, will_be), glm::max(is_at, will_be)};
    if (!way.overlaps(around_)) return;
    if (is_at_rim(i)) return follow_at_rim(i, *normal);
    if (!faces_.collider->space.meets(way.wider(reach_))) return;
    const std::optional<FacePlane> plane = nearest_plane(own, is_at, will_be, normal);
    if (!plane) return;
    const double distance = plane->distance_to(is_at);
    const bool is_guard = i >= points_.points.size();
    if (is_guard && distance > 2 * skin_) return;
    known_.push_back({i, plane->normal});
    const bool on_edge = is_on_chord(i) || (is_guard && own.outward != Vec3(0));
    out_.push_back({faces_.now(is_at), faces_.now.turn * plane->normal, distance - skin_, i, {}, on_edge});
  }

  // Such a contact lasts while the chord would go through a face if it went on against the normal.
  void follow_at_rim(uint32_t i, const Vec3& normal) {
    KERF_ASSERT(std::abs(glm::dot(normal, normal) - 1) < 1e-9);
    const Collider::Chord& chord = chord_of(points_, i);
    const Vec3 from = now_(chord.from), to = now_(chord.to);
    for (const double shift : {0.25 * skin_, skin_, 0.5 * reach_, reach_}) {
      if (!face_between(faces_, from - shift * normal, to - shift * normal)) continue;
      known_.push_back({i, normal});
      out_.push_back({faces_.now(now_(point_of(points_, i).at)), faces_.now.turn * normal, 0, i, {}, true});
      return;
    }
  }

  std::optional<FacePlane> nearest_plane(const Collider::Point& own, const Vec3& is_at, const Vec3& will_be,
                                         const Vec3* normal) const {
    std::optional<FacePlane> best;
    const auto offer = [&](const Vec3& direction, double length) {
      const std::optional<FacePlane> plane = along(is_at, direction, length);
      if (plane && (!best || plane->distance_to(is_at) < best->distance_to(is_at))) best = plane;
    };
    if (normal) offer(-*normal, reach_);
    const Vec3 way = will_be - is_at;
    const double length = glm::length(way);
    if (length > 0) offer(way / length, length + reach_);
    if (best) return best;
    const Vec3 own_normal = now_.turn * own.normal;
    if (own_normal != Vec3(0)) {
      offer(own_normal, reach_);
      offer(-own_normal, reach_);
    }
    if (own.outward != Vec3(0)) offer(now_.turn * own.outward, reach_);
    return best;
  }

  std::optional<FacePlane> along(const Vec3& from, const Vec3& direction, double length) const {
    const Vec3 to = from + length * direction;
    if (!faces_.collider->space.meets({glm::min(from, to), glm::max(from, to)})) return std::nullopt;
    return face_along(faces_, from, direction, length);
  }

  const Collider& points_;
  const MovingBody& faces_;
  const double reach_, skin_;
  const RigidMap now_, next_;  // from the frame of the points to that of the faces
  const Box around_;
  const std::vector<PointMemory>& memory_;
  size_t old_ = 0;
  std::vector<PointMemory> known_;
  std::vector<Contact>& out_;
};

}  // namespace

void find_point_contacts(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
                         std::vector<PointMemory>& memory, std::vector<Contact>& out) {
  KERF_ASSERT(points.scale > 0 && faces.scale > 0);
  KERF_ASSERT(std::is_sorted(memory.begin(), memory.end(),
                             [](const PointMemory& a, const PointMemory& b) { return a.point < b.point; }));
  memory = PointTracker(points, faces, lengths, memory, out).track();
}

}  // namespace kerf
