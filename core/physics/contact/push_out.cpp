#include "core/physics/contact/push_out.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/tick.h"
#include "core/physics/contact/face_plane.h"

namespace kerf {

namespace {

constexpr size_t kMostPlaces = 16;  // that are looked at for each of the two bodies

// The places where chords of one body go through faces of another, in the frame of the faces.
std::vector<FacePlane> places(const MovingBody& chords, const MovingBody& faces) {
  const RigidMap map = into(faces.now, chords.now);
  std::vector<FacePlane> found;
  const auto near = [&](const Cluster& cluster) { return faces.collider->space.meets(box_of(cluster, map)); };
  chords.collider->fine_chord_clusters.any_of(near, [&](uint32_t i) {
    const Collider::Chord& c = chords.collider->fine_chords[i];
    if (const auto plane = face_between(faces, map(c.from), map(c.to))) found.push_back(*plane);
    return found.size() == kMostPlaces;
  });
  return found;
}

// The direction, in the world, in which the body of the chords leaves the faces behind.
struct Exit {
  Vec3 way{0};  // unit
  double depth = std::numeric_limits<double>::infinity();
};

Exit shortest_exit(const MovingBody& chords, const MovingBody& faces, const std::vector<FacePlane>& places) {
  const RigidMap map = into(faces.now, chords.now);
  Exit best;
  for (const FacePlane& plane : places) {
    double above = 0, below = 0;
    for (const Collider::Point& p : chords.collider->points) {
      const double height = plane.distance_to(map(p.at));
      above = std::max(above, height);
      below = std::max(below, -height);
    }
    if (below < best.depth) best = {faces.now.turn * plane.normal, below};
    if (above < best.depth) best = {-(faces.now.turn * plane.normal), above};
  }
  return best;
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

std::optional<Contact> push_out(const MovingBody& first, const MovingBody& second, uint32_t ticks) {
  KERF_ASSERT(first.id < second.id && ticks > 0);
  const double left = kLongestPush - seconds_of_ticks(ticks), speed = kPushOut * first.metre;
  if (left <= 0) return std::nullopt;
  const std::vector<FacePlane> on_second = places(first, second), on_first = places(second, first);
  if (on_first.empty() && on_second.empty()) return std::nullopt;
  Exit exit = shortest_exit(first, second, on_second);
  const Exit other = shortest_exit(second, first, on_first);
  if (other.depth < exit.depth) exit = {-other.way, other.depth};
  if (exit.depth > speed * left) return std::nullopt;
  const double overlap = speed * seconds_of_ticks(1) / kSolvedShare;
  return Contact{middle_of(first, second, on_first, on_second), exit.way, -overlap, 0, {}};
}

}  // namespace kerf
