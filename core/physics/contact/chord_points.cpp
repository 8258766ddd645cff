#include "core/physics/contact/chord_points.h"

#include <algorithm>
#include <cassert>

#include "core/physics/contact/face_plane.h"

namespace kerf {

namespace {

constexpr uint32_t kPlaceBits = 12;
constexpr uint32_t kPlaces = 1u << kPlaceBits;  // along a chord

uint32_t point_at(uint32_t chord, double share) {
  assert(share >= 0 && share <= 1 + 1e-9 && chord < kAtRim >> kPlaceBits);
  const auto place = static_cast<uint32_t>(share * kPlaces);
  return kOnChord | chord << kPlaceBits | std::min(place, kPlaces - 1);
}

constexpr uint32_t kApart = kPlaces / 4;  // of two points of a chord

// Adds a point in its order, unless there is one near it on the chord.
void insert(const PointMemory& point, std::vector<PointMemory>& memory) {
  const auto at = std::ranges::lower_bound(memory, point.point, {}, &PointMemory::point);
  const uint32_t chord = point.point >> kPlaceBits;
  const auto near = [&](const PointMemory& m) {
    const uint32_t between = std::max(m.point, point.point) - std::min(m.point, point.point);
    return m.point >> kPlaceBits == chord && between < kApart;
  };
  if (at != memory.end() && near(*at)) return;
  if (at != memory.begin() && near(*std::prev(at))) return;
  memory.insert(at, point);
}

// Adds a point at a rim. If there is one near it on the chord, that one has a normal between the two instead.
// Returns whether the point is new.
bool insert_at_rim(const PointMemory& point, std::vector<PointMemory>& memory) {
  for (PointMemory& m : memory) {
    if (!is_at_rim(m.point) || m.point >> kPlaceBits != point.point >> kPlaceBits) continue;
    const Vec3 sum = m.normal + point.normal;
    m.normal = glm::length(sum) > 0.1 ? glm::normalize(sum) : point.normal;
    return false;
  }
  memory.insert(std::ranges::lower_bound(memory, point.point, {}, &PointMemory::point), point);
  return true;
}

// The places where a chord goes through faces at the end of its way, as shares of it.
std::vector<double> places(const Vec3& from, const Vec3& to, const MovingBody& faces) {
  const double length = glm::length(to - from);
  if (!(length > 0)) return {};
  std::vector<RayHit> hits;
  ++faces.rays;
  faces.body->tree.crossings(faces.body->mesh, Pose{from, (to - from) / length}, {0, length}, hits);
  std::vector<double> shares;
  for (const RayHit& hit : hits) shares.push_back(hit.length / length);
  return shares;
}

// The middles between these places and the ends of the chord.
std::vector<double> middles(const std::vector<double>& places) {
  std::vector<double> shares;
  double last = 0;
  for (const double place : places) {
    shares.push_back(0.5 * (last + place));
    last = place;
  }
  shares.push_back(0.5 * (last + 1));
  return shares;
}

}  // namespace

const Collider::Chord& chord_of(const Collider& collider, uint32_t point) {
  const uint32_t chord = (point & ~(kOnChord | kAtRim)) >> kPlaceBits;
  assert(is_on_chord(point) && chord < collider.chords.size());
  return collider.chords[chord];
}

Collider::Point point_of(const Collider& collider, uint32_t point) {
  assert(is_on_chord(point) || point < collider.points.size());
  if (!is_on_chord(point)) return collider.points[point];
  const Collider::Chord& chord = chord_of(collider, point);
  const double share = (point & (kPlaces - 1)) / static_cast<double>(kPlaces);
  return {glm::mix(chord.from, chord.to, share), Vec3(0), Vec3(0)};
}

bool remember_piercing_points(const MovingBody& chords, const MovingBody& faces,
                              std::vector<PointMemory>& memory) {
  const RigidMap now = into(faces.now, chords.now), next = into(faces.next, chords.next);
  bool any_new = false;
  for (const Cluster& cluster : chords.collider->chord_clusters) {
    if (!way_of(cluster, next, next).overlaps(faces.collider->bounds)) continue;
    for (uint32_t i = cluster.begin; i < cluster.end; ++i) {
      const Collider::Chord& c = chords.collider->chords[i];
      const std::vector<double> through = places(next(c.from), next(c.to), faces);
      if (through.empty()) continue;
      bool met_face = false;
      for (const double share : middles(through)) {
        const uint32_t point = point_at(i, share);
        const Vec3 at = point_of(*chords.collider, point).at, free = now(at);
        if (const auto plane = face_between(faces, free, next(at))) {
          insert({point, plane->normal}, memory);
          met_face = true;
        }
      }
      if (met_face) continue;
      const uint32_t point = point_at(i, through[0]) | kAtRim;
      const Vec3 at = point_of(*chords.collider, point).at, back = now(at) - next(at);
      if (const double way = glm::length(back); way > 0)
        any_new |= insert_at_rim({point, back / way}, memory);
    }
  }
  assert(std::is_sorted(memory.begin(), memory.end(),
                        [](const PointMemory& a, const PointMemory& b) { return a.point < b.point; }));
  return any_new;
}

}  // namespace kerf
