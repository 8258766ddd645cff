#include "core/physics/contact/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/tick.h"
#include "core/physics/contact/point_contacts.h"

namespace kerf {

namespace {

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

bool sheets_cross(const MovingBody& a, const MovingBody& b) {
  return chords_pierce(a, b, into(b.now, a.now)) || chords_pierce(b, a, into(a.now, b.now));
}

bool get_through(const MovingBody& a, const MovingBody& b) {
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
