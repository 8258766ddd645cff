#include "core/world/separation_state.h"

namespace kerf {

SearchFront* OpenSearch::front_of(FaceId f) {
  const uint32_t marked = mark.get(f.index) & ~kLookedAt;
  if (marked == 0) return nullptr;
  uint32_t front = marked - 1;
  while (front_parent[front] != front) front = front_parent[front];
  return &fronts[front];
}

size_t OpenSearch::bytes() const {
  size_t bytes = mark.bytes();
  for (const SearchFront& front : fronts) bytes += front.frontier.capacity() * sizeof(ReachedFace);
  return bytes;
}

}  // namespace kerf
