#include "tests/matches/endurance.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "core/world/world.h"

namespace kerf {

namespace {

constexpr Ticks kLookAtMeshesEvery = 10 * kTicksPerSecond;
constexpr double kOutside = 0.5;  // m, that the middle of a body may be beyond the arena
constexpr size_t kMaxBodies = 1000;

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_finite(const Body& body) {
  const glm::dquat& q = body.placement.orientation;
  return is_finite(body.placement.position) && std::isfinite(q.w + q.x + q.y + q.z) &&
         is_finite(body.motion.velocity) && is_finite(body.motion.spin);
}

bool is_inside(const Body& body, const ArenaDescription& arena) {
  if (body.tree.leaf_count() == 0) return true;
  const Bounds box = body.bounds();
  const Vec3 middle = body.placement.to_world(0.5 * (box.min + box.max));
  const double size = glm::length(box.max - box.min);
  return std::abs(middle.x) <= 0.5 * arena.size.x + kOutside &&
         std::abs(middle.z) <= 0.5 * arena.size.y + kOutside && middle.y >= arena.ground - size - kOutside;
}

bool has_finite_vertices(const Mesh& mesh) {
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const Vec3& corner : mesh.triangle(FaceId(f))) {
      if (!is_finite(corner)) return false;
    }
  }
  return true;
}

bool counts_its_faces(const Body& body) {
  std::vector<size_t> faces(body.pieces.size());
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f))) ++faces[body.label(FaceId(f))];
  }
  for (uint32_t label = 0; label < faces.size(); ++label) {
    if (body.pieces[label].faces != faces[label]) return false;
  }
  return true;
}

std::string fault_in(const Match& match, bool of_meshes) {
  if (match.world().ids().size() > kMaxBodies) return "there are too many bodies";
  for (const BodyId id : match.world().ids()) {
    const Body& body = match.world().body(id);
    if (!is_finite(body)) return body.name + " is at no finite place";
    if (!body.pinned && !is_inside(body, match.rules().arena.description)) return body.name + " is outside";
    if (!of_meshes) continue;
    if (!has_finite_vertices(body.mesh)) return body.name + " has a vertex at no finite place";
    if (!counts_its_faces(body)) return body.name + " counts faces that it does not have";
  }
  return {};
}

}  // namespace

Endurance endure(const MatchSetup& setup, double seconds) {
  using Clock = std::chrono::steady_clock;
  Match match(setup);
  BotPlayer bot(match);
  Endurance result;
  std::vector<double> times;
  const auto ticks = static_cast<size_t>(seconds * kTicksPerSecond);
  while (times.size() < ticks && !match.settled() && result.fault.empty()) {
    const Controls controls = bot.next(match);
    const Clock::time_point start = Clock::now();
    match.tick(controls);
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    result.most_bodies = std::max(result.most_bodies, match.world().ids().size());
    result.fault = fault_in(match, times.size() % kLookAtMeshesEvery == 0);
    if (!result.fault.empty()) result.fault += " in tick " + std::to_string(times.size());
  }
  result.ticks = times.size();
  result.hash = state_hash(match.world());
  std::sort(times.begin(), times.end());
  if (times.empty()) return result;
  result.median_s = times[times.size() / 2];
  result.slow_s = times[times.size() * 99 / 100];
  result.longest_s = times.back();
  return result;
}

}  // namespace kerf
