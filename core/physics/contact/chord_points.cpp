#include "core/physics/contact/chord_points.h"

#include <algorithm>
#include <cassert>

#include "core/physics/contact/face_plane.h"

namespace kerf {

namespace {

constexpr uint32_t kPlaceBits = 12;
constexpr uint32_t kPlaces = 1u << kPlaceBits;  // along a chord

uint32_t point_at(uint32_t chord, double share) {
  const auto place = static_cast<uint32_t>(share * kPlaces);
  return kOnChord | chord << kPlaceBits | std::min(place, kPlaces - 1);
}

constexpr uint32_t kApart = kPlaces / 4;  // of two points of a chord

// Unless there is one near it on the chord.
void insert(const PointMemory& point, std::vector<PointMemory>& memory) {
  const auto before = [](const PointMemory& m, uint32_t wanted) { return m.point < wanted; };
  const auto at = std::lower_bound(memory.begin(), memory.end(), point.point, before);
  const uint32_t chord = point.point >> kPlaceBits;
  const auto near = [&](const PointMemory& m) {
    const uint32_t between = std::max(m.point, point.point) - std::min(m.point, point.point);
    return m.point >> kPlaceBits == chord && between < kApart;
  };
  if (at != memory.end() && near(*at)) return;
  if (at != memory.begin() && near(*std::prev(at))) return;
  memory.insert(at, point);
}

// The middles between the places where a chord goes through faces at the end of its way, as shares of it.
std::vector<double> middles(const Vec3& from, const Vec3& to, const MovingBody& faces) {
  const double length = glm::length(to - from);
  std::vector<RayHit> hits;
  if (!(length > 0)) return {};
  ++faces.rays;
  faces.body->tree.crossings(faces.body->mesh, Pose{from, (to - from) / length}, {0, length}, hits);
  if (hits.empty()) return {};
  std::vector<double> shares;
  double last = 0;
  for (const RayHit& hit : hits) {
    shares.push_back(0.5 * (last + hit.length) / length);
    last = hit.length;
  }
  shares.push_back(0.5 * (last + length) / length);
  return shares;
}

}  // namespace

Collider::Point point_of(const Collider& collider, uint32_t point) {
  if (!is_on_chord(point)) return collider.points[point];
  const uint32_t chord = (point & ~kOnChord) >> kPlaceBits;
  assert(chord < collider.chords.size());
  const double share = (point & (kPlaces - 1)) / static_cast<double>(kPlaces);
  return {glm::mix(collider.chords[chord].from, collider.chords[chord].to, share), Vec3(0), Vec3(0)};
}

void remember_piercing_points(const MovingBody& chords, const MovingBody& faces,
                              std::vector<PointMemory>& memory) {
  const RigidMap now = into(faces.now, chords.now), next = into(faces.next, chords.next);
  for (const Cluster& cluster : chords.collider->chord_clusters) {
    if (!way_of(cluster, next, next).overlaps(faces.collider->bounds)) continue;
    for (uint32_t i = cluster.begin; i < cluster.end; ++i) {
      const Collider::Chord& c = chords.collider->chords[i];
      for (const double share : middles(next(c.from), next(c.to), faces)) {
        const uint32_t point = point_at(i, share);
        const Vec3 at = point_of(*chords.collider, point).at, free = now(at);
        if (const auto plane = face_between(faces, free, next(at))) insert({point, plane->normal}, memory);
      }
    }
  }
}

}  // namespace kerf
