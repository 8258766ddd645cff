#include "core/edit/likely_larger.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr uint32_t kFrontierSamples = 64, kFaceSamples = 256;

// The mean of corners of the frontier's live faces.
Vec3 middle_of(const Mesh& mesh, const SearchFront& front) {
  Vec3 sum(0);
  size_t count = 0;
  const size_t size = front.frontier.size() - front.next,
               stride = std::max<size_t>(size / kFrontierSamples, 1);
  for (size_t i = front.next; i < front.frontier.size(); i += stride) {
    const FaceId f = front.frontier[i].face;
    if (!mesh.is_live(f)) continue;
    sum += mesh.position(mesh.corners(f)[0]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : sum;
}

}  // namespace

uint32_t likely_larger(const Body& body, uint32_t a, uint32_t b) {
  const OpenSearch& search = body.separation.search;
  const SearchFront &front_a = search.fronts[a], &front_b = search.fronts[b];
  KERF_ASSERT(!front_a.exhausted() && !front_b.exhausted());
  const Vec3 middle_a = middle_of(body.mesh, front_a), middle_b = middle_of(body.mesh, front_b);
  const FaceCounts* whole = &body.whole_of(search.seed[a]);
  const uint32_t stride = std::max(body.mesh.face_slots() / kFaceSamples, 1u);
  int nearer_a = 0;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); slot += stride) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f) || &body.whole_of(f) != whole) continue;
    const SearchFront* reached_by = search.front_of(f);
    const Vec3 at = body.mesh.position(body.mesh.corners(f)[0]);
    const Vec3 to_a = at - middle_a, to_b = at - middle_b;
    const bool of_a = reached_by ? reached_by == &front_a : glm::dot(to_a, to_a) < glm::dot(to_b, to_b);
    nearer_a += of_a ? 1 : -1;
  }
  return nearer_a > 0 ? a : b;
}

}  // namespace kerf
