#include "core/world/separation_state.h"

namespace kerf {

namespace {

constexpr uint32_t kNone = 0xffffffffu;

}  // namespace

uint32_t OpenSearch::root_of(FaceId f) const {
  const uint32_t marked = mark.get(f.index) & ~kLookedAt;
  if (marked == 0) return kNone;
  uint32_t front = marked - 1;
  while (front_parent[front] != front) front = front_parent[front];
  return front;
}

SearchFront* OpenSearch::front_of(FaceId f) {
  const uint32_t front = root_of(f);
  return front == kNone ? nullptr : &fronts[front];
}

uint32_t OpenSearch::label_to_be(FaceId f) const {
  const uint32_t front = stage == Stage::kRelabel ? root_of(f) : kNone;
  return front == kNone ? 0 : new_label[front];
}

size_t OpenSearch::bytes() const {
  size_t bytes = mark.bytes();
  for (const SearchFront& front : fronts) bytes += front.frontier.capacity() * sizeof(FaceId);
  return bytes;
}

}  // namespace kerf
