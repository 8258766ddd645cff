#include "core/physics/contact/point_contacts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/base/assert.h"

namespace kerf {

std::optional<FacePlane> face_along(const MovingBody& faces, const Vec3& from, const Vec3& direction,
                                    double length) {
  KERF_ASSERT(std::abs(glm::dot(direction, direction) - 1) < 1e-9 && length >= 0);
  const Body& body = *faces.body;
  const auto hit = body.tree.nearest(body.mesh, Pose{from, direction}, {0, length});
  if (!hit) return std::nullopt;
  const Triangle t = body.mesh.triangle(hit->face);
  Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double area = glm::length(normal);
  if (!(area > 0)) return std::nullopt;
  normal /= area;
  if (glm::dot(normal, direction) > 0) normal = -normal;
  return FacePlane{from + hit->length * direction, normal};
}

std::optional<FacePlane> face_between(const MovingBody& faces, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length = glm::length(way);
  if (!(length > 0)) return std::nullopt;
  return face_along(faces, from, way / length, length);
}

namespace {

constexpr uint32_t kPlaceBits = 12;
constexpr uint32_t kPlaces = 1u << kPlaceBits;  // along a chord

uint32_t point_at(uint32_t chord, double share) {
  assert(share >= 0 && share <= 1 + 1e-9 && chord < kAtRim >> kPlaceBits);
  const auto place = static_cast<uint32_t>(share * kPlaces);
  return kOnChord | chord << kPlaceBits | std::min(place, kPlaces - 1);
}

constexpr uint32_t kApart = kPlaces / 4;  // min distance of two points of a chord

// Inserts a point in order, unless there is one near it on the chord.
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

// Inserts a point at a rim. If there is one near it on the chord, sets the normal of that one between the
// two instead. Returns true if the point is new.
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

// The places where a chord passes through faces at the end of its way, as shares of the chord.
struct Piercing {
  std::vector<double> shares;
  FaceId first;  // face at the first of them
};

Piercing places(const Vec3& from, const Vec3& to, const MovingBody& faces) {
  const double length = glm::length(to - from);
  if (!(length > 0)) return {};
  std::vector<RayHit> hits;
  faces.body->tree.crossings(faces.body->mesh, Pose{from, (to - from) / length}, {0, length}, hits);
  Piercing piercing;
  if (!hits.empty()) piercing.first = hits[0].face;
  for (const RayHit& hit : hits) piercing.shares.push_back(hit.length / length);
  return piercing;
}

// Returns the unit normal of the contact of a chord that met the rim of a sheet coming from the direction
// `back` (not 0): in the plane of the face at the rim, or across it if the chord came mainly from there.
Vec3 rim_normal(const Triangle& face, const Vec3& back) {
  constexpr double kRather = 0.7;  // cosine
  const Vec3 came_from = glm::normalize(back), area = glm::cross(face[1] - face[0], face[2] - face[0]);
  if (!(glm::length(area) > 0)) return came_from;
  const Vec3 across = glm::dot(area, came_from) / glm::dot(area, area) * area;
  return glm::normalize(glm::length(across) > kRather ? across : came_from - across);
}

// Returns the midpoints between these places and the ends of the chord.
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
  assert(is_on_chord(point) && chord < collider.fine_chords.size());
  return collider.fine_chords[chord];
}

Collider::Point point_of(const Collider& collider, uint32_t point) {
  const size_t points = collider.points.size();
  assert(is_on_chord(point) || point < points + collider.guards.size());
  if (!is_on_chord(point)) return point < points ? collider.points[point] : collider.guards[point - points];
  const Collider::Chord& chord = chord_of(collider, point);
  const double share = (point & (kPlaces - 1)) / static_cast<double>(kPlaces);
  return {glm::mix(chord.from, chord.to, share), Vec3(0), Vec3(0)};
}

void remember_passing_guards(const MovingBody& points, const MovingBody& faces,
                             std::vector<PointMemory>& memory) {
  const Collider& c = *points.collider;
  const RigidMap now = into(faces.now, points.now), next = into(faces.next, points.next);
  const auto near = [&](const Cluster& cluster) {
    return faces.collider->space.meets(way_of(cluster, now, next));
  };
  c.guard_clusters.for_each(near, [&](uint32_t i) {
    const std::optional<FacePlane> plane = face_between(faces, now(c.guards[i].at), next(c.guards[i].at));
    if (!plane) return;
    const PointMemory met{static_cast<uint32_t>(c.points.size()) + i, plane->normal};
    const auto at = std::ranges::lower_bound(memory, met.point, {}, &PointMemory::point);
    if (at == memory.end() || at->point != met.point) memory.insert(at, met);
  });
}

bool remember_piercing_points(const MovingBody& chords, const MovingBody& faces,
                              std::vector<PointMemory>& memory) {
  const RigidMap now = into(faces.now, chords.now), next = into(faces.next, chords.next);
  bool any_new = false;
  const auto near = [&](const Cluster& cluster) {
    return box_of(cluster, next).overlaps(faces.collider->bounds);
  };
  chords.collider->fine_chord_clusters.for_each(near, [&](uint32_t i) {
    const Collider::Chord& c = chords.collider->fine_chords[i];
    const Piercing through = places(next(c.from), next(c.to), faces);
    if (through.shares.empty()) return;
    bool met_face = false;
    for (const double share : middles(through.shares)) {
      const uint32_t point = point_at(i, share);
      const Vec3 at = point_of(*chords.collider, point).at, free = now(at);
      if (const auto plane = face_between(faces, free, next(at))) {
        insert({point, plane->normal}, memory);
        met_face = true;
      }
    }
    if (met_face) return;
    const uint32_t point = point_at(i, through.shares[0]) | kAtRim;
    const Vec3 at = point_of(*chords.collider, point).at, back = now(at) - next(at);
    if (!(glm::length(back) > 0)) return;
    const Triangle face = faces.body->mesh.triangle(through.first);
    any_new |= insert_at_rim({point, rim_normal(face, back)}, memory);
  });
  assert(std::is_sorted(memory.begin(), memory.end(),
                        [](const PointMemory& a, const PointMemory& b) { return a.point < b.point; }));
  return any_new;
}

namespace {

// Tracks the points of one body among the faces of another.
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

  // Returns the new memory.
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
  // Precondition: called with ascending points.
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

  // Such a contact lasts while the chord would pass through a face if it moved on against the normal.
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
