#include <algorithm>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/sheared_ray.h"
#include "core/tree/tree_rays.h"
#include "core/tree/walk_scratch.h"

namespace kerf {

namespace {

static_assert(RayQuery::kPositionShift == Positions::kShift && sizeof(Vec3) == 24);

bool nearer(const RayHit& a, const RayHit& b) {
  return a.length != b.length ? a.length < b.length : a.face < b.face;
}

Triangle triangle_of(Positions positions, const FaceBlock& block, unsigned lane) {
  return {positions[block.vertex[0][lane]], positions[block.vertex[1][lane]],
          positions[block.vertex[2][lane]]};
}

// The crossing of a listed face, if there is one within the range.
std::optional<RayHit> test_face(Positions positions, const ShearedRay& ray, Interval range, uintptr_t word) {
  const FaceBlock& block = *block_of(word);
  const unsigned lane = lane_of(word);
  const auto length = ray.cross(triangle_of(positions, block, lane));
  if (!length || !(*length >= range.low && *length <= range.high)) return std::nullopt;
  return RayHit{FaceId(block.face[lane]), *length};
}

void sort_from(std::vector<RayHit>& hits, size_t first) {
  if (hits.size() - first > 1)
    std::sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), nearer);
}

}  // namespace

void AabbTree::crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const {
  KERF_ASSERT(is_unit(ray.direction));
  if (store_.root == kNoIndex) return;
  RayQuery query;
  query.positions = reinterpret_cast<const char* const*>(mesh.positions().chunks());
  if (!prepare_rays(store_, {&ray, 1}, range, query)) return;
  WalkScratch scratch;
  walks_->ray(store_.view(), query, scratch);
  if (scratch.found().empty()) return;
  const ShearedRay sheared(ray);
  const size_t first = out.size();
  for (const uintptr_t word : scratch.found()) {
    if (const auto hit = test_face(mesh.positions(), sheared, range, word)) out.push_back(*hit);
  }
  sort_from(out, first);
}

void AabbTree::crossings(const Mesh& mesh, std::span<const Pose> rays, Interval range,
                         std::span<std::vector<RayHit>> out) const {
  KERF_ASSERT(out.size() == rays.size());
  const auto parallel = [&](const Pose& ray) { return ray.direction == rays[0].direction; };
  if (store_.root == kNoIndex || rays.empty()) return;
  if (rays.size() > kBlockWidth || !std::all_of(rays.begin(), rays.end(), parallel)) {
    for (size_t i = 0; i < rays.size(); ++i) crossings(mesh, rays[i], range, out[i]);
    return;
  }
  RayQuery query;
  query.positions = reinterpret_cast<const char* const*>(mesh.positions().chunks());
  if (!prepare_rays(store_, rays, range, query)) return;
  WalkScratch scratch;
  walks_->rays(store_.view(), query, scratch);
  if (scratch.found().empty()) return;
  ShearedRay sheared[kBlockWidth];
  for (size_t i = 0; i < rays.size(); ++i)
    sheared[i] = i == 0 ? ShearedRay(rays[0]) : sheared[0].beside(rays[i]);
  size_t first[kBlockWidth];
  for (size_t i = 0; i < rays.size(); ++i) first[i] = out[i].size();
  for (const uintptr_t word : scratch.found()) {
    const unsigned r = ray_of(word);
    if (const auto hit = test_face(mesh.positions(), sheared[r], range, word)) out[r].push_back(*hit);
  }
  for (size_t i = 0; i < rays.size(); ++i) sort_from(out[i], first[i]);
}

std::optional<RayHit> AabbTree::nearest(const Mesh& mesh, const Pose& ray, Interval range) const {
  KERF_ASSERT(is_unit(ray.direction));
  if (store_.root == kNoIndex) return std::nullopt;
  RayQuery query;
  query.positions = reinterpret_cast<const char* const*>(mesh.positions().chunks());
  if (!prepare_rays(store_, {&ray, 1}, range, query)) return std::nullopt;
  WalkScratch scratch;
  walks_->nearest(store_.view(), query, scratch);
  if (scratch.found().empty()) return std::nullopt;
  const ShearedRay sheared(ray);
  std::optional<RayHit> best;
  for (const uintptr_t word : scratch.found()) {
    const auto hit = test_face(mesh.positions(), sheared, range, word);
    if (hit && (!best || nearer(*hit, *best))) best = hit;
  }
  return best;
}

}  // namespace kerf
