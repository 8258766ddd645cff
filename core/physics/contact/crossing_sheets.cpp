#include "core/physics/contact/crossing_sheets.h"

namespace kerf {

namespace {

bool pierces(const Vec3& from, const Vec3& to, const MovingBody& faces) {
  if (!faces.collider->space.meets({glm::min(from, to), glm::max(from, to)})) return false;
  const double length = glm::length(to - from);
  return length > 0 &&
         faces.body->tree.nearest(faces.body->mesh, Pose{from, (to - from) / length}, {0, length});
}

// Whether a chord goes through a face; `map` is from the frame of the chords to that of the faces.
bool chords_pierce(const MovingBody& chords, const MovingBody& faces, const RigidMap& map) {
  const auto near = [&](const Cluster& cluster) { return faces.collider->space.meets(box_of(cluster, map)); };
  return chords.collider->fine_chord_clusters.any_of(near, [&](uint32_t i) {
    const Collider::Chord& c = chords.collider->fine_chords[i];
    return pierces(map(c.from), map(c.to), faces);
  });
}

// Whether a point meets a face on its way.
bool points_pass(const MovingBody& points, const MovingBody& faces, const RigidMap& now,
                 const RigidMap& next) {
  const auto near = [&](const Cluster& cluster) {
    return faces.collider->space.meets(way_of(cluster, now, next));
  };
  const auto pass = [&](const Clusters& clusters, const std::vector<Collider::Point>& list) {
    return clusters.any_of(near,
                           [&](uint32_t i) { return pierces(now(list[i].at), next(list[i].at), faces); });
  };
  const Collider& c = *points.collider;
  return pass(c.point_clusters, c.points) || pass(c.guard_clusters, c.guards);
}

}  // namespace

bool sheets_cross(const MovingBody& a, const MovingBody& b) {
  return chords_pierce(a, b, into(b.now, a.now)) || chords_pierce(b, a, into(a.now, b.now));
}

bool get_through(const MovingBody& a, const MovingBody& b) {
  const RigidMap ab = into(b.next, a.next), ba = into(a.next, b.next);
  return chords_pierce(a, b, ab) || chords_pierce(b, a, ba) || points_pass(a, b, into(b.now, a.now), ab) ||
         points_pass(b, a, into(a.now, b.now), ba);
}

}  // namespace kerf
