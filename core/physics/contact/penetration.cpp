#include "core/physics/contact/penetration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"

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

bool pierces(const Vec3& from, const Vec3& to, const MovingBody& faces) {
  if (!faces.collider->space.meets({glm::min(from, to), glm::max(from, to)})) return false;
  const double length = glm::length(to - from);
  return length > 0 &&
         faces.body->tree.nearest(faces.body->mesh, Pose{from, (to - from) / length}, {0, length});
}

// Returns true if a chord passes through a face; `map`: from the frame of the chords to that of the faces.
bool chords_pierce(const MovingBody& chords, const MovingBody& faces, const RigidMap& map) {
  const auto near = [&](const Cluster& cluster) { return faces.collider->space.meets(box_of(cluster, map)); };
  return chords.collider->fine_chord_clusters.any_of(near, [&](uint32_t i) {
    const Collider::Chord& c = chords.collider->fine_chords[i];
    return pierces(map(c.from), map(c.to), faces);
  });
}

// Returns true if a point meets a face on its way.
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

bool sheets_cross(const MovingBody& a, const MovingBody& b) {
  return chords_pierce(a, b, into(b.now, a.now)) || chords_pierce(b, a, into(a.now, b.now));
}

bool pass_through(const MovingBody& a, const MovingBody& b) {
  const RigidMap ab = into(b.next, a.next), ba = into(a.next, b.next);
  return chords_pierce(a, b, ab) || chords_pierce(b, a, ba) || points_pass(a, b, into(b.now, a.now), ab) ||
         points_pass(b, a, into(a.now, b.now), ba);
}

namespace {

constexpr double kLongerWay = 2;   // max ratio of a kept way of the last tick to the shortest one
constexpr size_t kMaxPlaces = 16;  // tested places for each of the two bodies

// Returns the places where chords of one body pass through faces of another, in the frame of the faces.
std::vector<FacePlane> places(const MovingBody& chords, const MovingBody& faces) {
  const RigidMap map = into(faces.now, chords.now);
  std::vector<FacePlane> found;
  const auto near = [&](const Cluster& cluster) { return faces.collider->space.meets(box_of(cluster, map)); };
  chords.collider->fine_chord_clusters.any_of(near, [&](uint32_t i) {
    const Collider::Chord& c = chords.collider->fine_chords[i];
    if (const auto plane = face_between(faces, map(c.from), map(c.to))) found.push_back(*plane);
    return found.size() == kMaxPlaces;
  });
  return found;
}

// A direction, in world coordinates, along which the first of two bodies leaves the second.
struct Exit {
  Vec3 way{0};  // unit
  double depth = std::numeric_limits<double>::infinity();
};

void take_shorter(Exit& best, const Vec3& way, double depth) {
  if (depth < best.depth) best = {way, depth};
}

// Returns the points of a body, in world coordinates.
std::vector<Vec3> points_of(const MovingBody& body) {
  std::vector<Vec3> points;
  for (const std::vector<Collider::Point>* list : {&body.collider->points, &body.collider->guards}) {
    for (const Collider::Point& p : *list) points.push_back(body.now(p.at));
  }
  return points;
}

Interval extent(const std::vector<Vec3>& points, const Vec3& along) {
  Interval extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3& p : points) {
    const double at = glm::dot(p, along);
    extent = {std::min(extent.low, at), std::max(extent.high, at)};
  }
  return extent;
}

// Tries the exits of points through the plane of a face that has points on both sides.
void try_plane(const Vec3& at, const Vec3& normal, const std::vector<Vec3>& points, double sign, Exit& best) {
  const Interval heights = extent(points, normal);
  const double level = glm::dot(at, normal);
  take_shorter(best, sign * normal, level - heights.low);
  take_shorter(best, -sign * normal, heights.high - level);
}

// The extreme points along a direction, the first of equal ones.
struct Extremes {
  Vec3 lowest, highest;
};

Extremes extremes(const std::vector<Vec3>& points, const Vec3& way) {
  KERF_ASSERT(!points.empty());
  size_t lowest = 0, highest = 0;
  double low = glm::dot(points[0], way), high = low;
  for (size_t i = 1; i < points.size(); ++i) {
    const double at = glm::dot(points[i], way);
    if (at < low) low = at, lowest = i;
    if (at > high) high = at, highest = i;
  }
  return {points[lowest], points[highest]};
}

// Passage of one list of points past another, until a plane across the way separates them. `apart`: the
// vector between the points that pass each other last.
struct Passing {
  double depth = 0;
  Vec3 apart{0};
};

Passing passing(const Extremes& first, const Extremes& second, const Vec3& way) {
  const Vec3 apart = second.highest - first.lowest;
  return {glm::dot(apart, way), apart};
}

Passing passing(const std::vector<Vec3>& first, const std::vector<Vec3>& second, const Vec3& way) {
  return passing(extremes(first, way), extremes(second, way), way);
}

Extremes turned_round(const Extremes& e) { return {e.highest, e.lowest}; }

// Improves an exit by turning its way against the vector that makes it long, in decreasing steps.
void refine(const std::vector<Vec3>& first, const std::vector<Vec3>& second, Exit& exit) {
  constexpr int kTries = 16;
  double turn = 0.3;  // rad
  Passing now = passing(first, second, exit.way);
  for (int i = 0; i < kTries; ++i) {
    const Vec3 aside = now.apart - glm::dot(now.apart, exit.way) * exit.way;
    if (!(glm::length(aside) > 0)) return;
    const Vec3 way = glm::normalize(exit.way - turn * glm::normalize(aside));
    const Passing next = passing(first, second, way);
    if (next.depth < now.depth) {
      exit = {way, next.depth};
      now = next;
    } else {
      turn *= 0.5;
    }
  }
}

// Finds the shortest exit across planes between all points of the two bodies.
void try_between(const std::vector<Vec3>& ways, const std::vector<Vec3>& first,
                 const std::vector<Vec3>& second, Exit& best) {
  Exit exit;
  for (const Vec3& way : ways) {
    const Extremes of_first = extremes(first, way), of_second = extremes(second, way);
    take_shorter(exit, way, passing(of_first, of_second, way).depth);
    take_shorter(exit, -way, passing(turned_round(of_first), turned_round(of_second), -way).depth);
  }
  refine(first, second, exit);
  take_shorter(best, exit.way, exit.depth);
}

// Returns directions over a hemisphere, on a spiral (Saff, Kuijlaars: Distributing many points on a sphere,
// 1997).
std::vector<Vec3> spread_ways() {
  constexpr int kWays = 48;
  constexpr double kTurnCosine = -0.7373688780783197, kTurnSine = 0.6754902942615238;  // of the golden angle
  std::vector<Vec3> ways;
  double x = 1, z = 0;
  for (int i = 0; i < kWays; ++i) {
    const double y = (i + 0.5) / kWays, radius = std::sqrt(1 - y * y);
    ways.push_back(glm::normalize(Vec3(radius * x, y, radius * z)));
    const double turned = kTurnCosine * x - kTurnSine * z;
    z = kTurnSine * x + kTurnCosine * z;
    x = turned;
  }
  return ways;
}

// Returns the shortest exit along the normals of the faces at the places and along directions all around.
// The way of the last tick, if any, counts as shorter than it is.
Exit shortest_exit(const MovingBody& first, const MovingBody& second, const std::vector<FacePlane>& on_first,
                   const std::vector<FacePlane>& on_second, const Vec3& before) {
  const std::vector<Vec3> of_first = points_of(first), of_second = points_of(second);
  Exit best;
  std::vector<Vec3> ways = spread_ways();
  for (const FacePlane& plane : on_second) {
    ways.push_back(second.now.turn * plane.normal);
    try_plane(second.now(plane.at), ways.back(), of_first, 1, best);
  }
  for (const FacePlane& plane : on_first) {
    ways.push_back(first.now.turn * plane.normal);
    try_plane(first.now(plane.at), ways.back(), of_second, -1, best);
  }
  try_between(ways, of_first, of_second, best);
  if (before == Vec3(0)) return best;
  Exit same{before, passing(of_first, of_second, before).depth};
  refine(of_first, of_second, same);
  return same.depth < kLongerWay * best.depth ? same : best;
}

Vec3 middle_of(const MovingBody& first, const MovingBody& second, const std::vector<FacePlane>& on_first,
               const std::vector<FacePlane>& on_second) {
  KERF_ASSERT(!on_first.empty() || !on_second.empty());
  Vec3 sum(0);
  for (const FacePlane& plane : on_first) sum += first.now(plane.at);
  for (const FacePlane& plane : on_second) sum += second.now(plane.at);
  return sum / static_cast<double>(on_first.size() + on_second.size());
}

}  // namespace

std::optional<Contact> push_out(const MovingBody& first, const MovingBody& second, PairMemory& memory) {
  KERF_ASSERT(first.id < second.id && memory.crossed > 0);
  if (seconds_of_ticks(memory.crossed) >= kMaxPush) return std::nullopt;
  const std::vector<FacePlane> on_second = places(first, second), on_first = places(second, first);
  if (on_first.empty() && on_second.empty()) return std::nullopt;
  const Exit exit = shortest_exit(first, second, on_first, on_second, memory.way_out);
  memory.way_out = exit.way;
  if (exit.depth > kDeepestPush * first.metre) return std::nullopt;
  const double overlap = kPushOut * first.metre * seconds_of_ticks(1) / kSolvedShare;
  return Contact{middle_of(first, second, on_first, on_second), exit.way, -overlap, 0, {}};
}

}  // namespace kerf
