#include <algorithm>

#include "core/tree/aabb_tree.h"
#include "core/tree/sheared_ray.h"
#include "core/tree/tree_rays.h"
#include "core/tree/walk_scratch.h"

namespace kerf {

namespace {

bool nearer(const RayHit& a, const RayHit& b) {
  return a.length != b.length ? a.length < b.length : a.face < b.face;
}

Triangle triangle_of(const Mesh& mesh, const FaceBlock& block, unsigned lane) {
  return {mesh.position(VertexId(block.vertex[0][lane])), mesh.position(VertexId(block.vertex[1][lane])),
          mesh.position(VertexId(block.vertex[2][lane]))};
}

// Appends the crossing of the face, where there is one.
void test_face(const Mesh& mesh, const ShearedRay& ray, Interval range, uintptr_t word,
               std::vector<RayHit>& out) {
  const FaceBlock& block = *block_of(word);
  const auto length = ray.cross(triangle_of(mesh, block, lane_of(word)));
  if (length && *length >= range.low && *length <= range.high)
    out.push_back({FaceId(block.face[lane_of(word)]), *length});
}

void sort_from(std::vector<RayHit>& hits, size_t first) {
  if (hits.size() - first > 1)
    std::sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), nearer);
}

}  // namespace

void AabbTree::crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const {
  if (store_.root == kNoIndex) return;
  const auto rays = prepare_rays(store_, {&ray, 1}, range);
  if (!rays) return;
  WalkScratch scratch;
  walks_for(simd_).ray(store_.view(), rays->query, scratch.lists());
  const size_t first = out.size();
  const ShearedRay sheared(ray);
  for (const uintptr_t word : scratch.faces()) test_face(mesh, sheared, range, word, out);
  sort_from(out, first);
}

void AabbTree::crossings(const Mesh& mesh, std::span<const Pose> rays, Interval range,
                         std::span<std::vector<RayHit>> out) const {
  const auto parallel = [&](const Pose& ray) { return ray.direction == rays[0].direction; };
  if (store_.root == kNoIndex || rays.empty()) return;
  if (rays.size() > kBlockWidth || !std::all_of(rays.begin(), rays.end(), parallel)) {
    for (size_t i = 0; i < rays.size(); ++i) crossings(mesh, rays[i], range, out[i]);
    return;
  }
  const auto bundle = prepare_rays(store_, rays, range);
  if (!bundle) return;
  WalkScratch scratch;
  walks_for(simd_).rays(store_.view(), bundle->query, scratch.lists());
  size_t first[kBlockWidth];
  for (size_t i = 0; i < rays.size(); ++i) first[i] = out[i].size();
  for (const uintptr_t word : scratch.faces()) {
    const unsigned r = ray_of(word);
    test_face(mesh, ShearedRay(rays[r]), range, word, out[r]);
  }
  for (size_t i = 0; i < rays.size(); ++i) sort_from(out[i], first[i]);
}

// Nearest ---------------------------------------------------------------------------------------------------

namespace {

struct NearestSearch {
  const Mesh& mesh;
  const ShearedRay ray;
  const Interval range;
  const TreeRays& rays;
  float t_beyond;
  std::optional<RayHit> best;

  static float test(void* context, const FaceBlock* block, unsigned lanes) {
    return static_cast<NearestSearch*>(context)->test(*block, lanes);
  }
  float test(const FaceBlock& block, unsigned lanes) {
    for (unsigned lane = 0; lane < kBlockWidth; ++lane) {
      if ((lanes >> lane & 1) == 0) continue;
      const auto length = ray.cross(triangle_of(mesh, block, lane));
      if (!length || !(*length >= range.low && *length <= range.high)) continue;
      const RayHit hit{FaceId(block.face[lane]), *length};
      if (best && !nearer(hit, *best)) continue;
      best = hit;
      t_beyond = rays.t_beyond(hit.length);
    }
    return t_beyond;
  }
};

}  // namespace

std::optional<RayHit> AabbTree::nearest(const Mesh& mesh, const Pose& ray, Interval range) const {
  if (store_.root == kNoIndex) return std::nullopt;
  const auto rays = prepare_rays(store_, {&ray, 1}, range);
  if (!rays) return std::nullopt;
  WalkScratch scratch;
  NearestSearch search{mesh, ShearedRay(ray), range, *rays, rays->query.t_high, std::nullopt};
  walks_for(simd_).nearest(store_.view(), rays->query, scratch.lists(), {&search, NearestSearch::test});
  return search.best;
}

}  // namespace kerf
