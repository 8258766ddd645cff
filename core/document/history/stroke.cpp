#include "core/document/history/stroke.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

BeamMove in_body(const Placement& placement, const BeamMove& move) {
  return {placement.to_body(move.from), placement.to_body(move.to), move.seconds};
}

// The distance of a point from the half-line of a beam.
double distance(const Pose& beam, const Vec3& p) {
  const Vec3 way = p - beam.origin;
  const double along = std::max(0.0, glm::dot(way, beam.direction));
  return glm::length(way - along * beam.direction);
}

}  // namespace

void Stroke::list_path(const World& world) {
  for (auto& [id, moves] : swept) {
    if (!world.contains(id)) continue;
    const Placement& placement = world.body(id).placement;
    for (size_t i = listed_; i < path.size(); ++i) moves.push_back(in_body(placement, path[i]));
  }
  listed_ = path.size();
}

void Stroke::cut_back(const World& world, size_t moves, const std::optional<BeamMove>& instead) {
  KERF_ASSERT(listed_ == path.size() && moves <= path.size());
  for (auto& [id, listed] : swept) {
    if (world.contains(id)) listed.resize(listed.size() - moves);
  }
  path.resize(path.size() - moves);
  listed_ = path.size();
  if (instead) path.push_back(*instead);
  list_path(world);
}

void Stroke::inherit(std::span<const Detached> detached) {
  for (const Detached& d : detached) {
    const auto at = swept.find(d.from);
    if (at != swept.end()) swept[d.to] = at->second;
  }
}

std::vector<BeamMove> Stroke::move_body(BodyId id, const Body& body, const Placement& from,
                                        const Pose& still) {
  KERF_ASSERT(listed_ == path.size());
  const auto [at, first] = swept.try_emplace(id);
  if (first) {
    for (const BeamMove& move : path) at->second.push_back(in_body(from, move));
  }
  const BeamMove whole{from.to_body(still), body.placement.to_body(still), 0};
  // The body lies in a sphere around the middle of what was loaded.
  const Vec3 middle = body.middle();
  const double size = 0.5 * glm::length(body.loaded.max - body.loaded.min);
  const double reach = glm::distance(whole.from.origin, middle) + size;
  const double radius = settings.laser.radius;
  std::vector<BeamMove> moves = subdivide(whole, radius, std::min(settings.laser.range.high, reach));
  // Each of the moves carries the beam by at most a radius.
  std::erase_if(moves, [&](const BeamMove& m) { return distance(m.from, middle) > size + 3 * radius; });
  at->second.insert(at->second.end(), moves.begin(), moves.end());
  return moves;
}

}  // namespace kerf
