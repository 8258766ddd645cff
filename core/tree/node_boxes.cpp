#include "core/tree/node_boxes.h"

#include <cassert>

namespace kerf {

void make_empty(WideNode& node) {
  node.parent = kNoIndex;
  node.slot = 0;
  node.hit = 0;
  const FloatBox none;
  for (int k = 0; k < 6; ++k) {
    const __m128 plane = k < 3 ? none.low : none.high;
    _mm_store_ps(node.plane[k], plane);
    _mm_store_ps(node.plane[k] + 4, plane);
  }
  for (Child& child : node.child) child = Child{};
}

void set_slot_box(WideNode& node, uint32_t slot, const FloatBox& box) {
  assert(slot < kNodeWidth);
  alignas(16) float low[4], high[4];
  _mm_store_ps(low, box.low);
  _mm_store_ps(high, box.high);
  for (int k = 0; k < 3; ++k) {
    node.plane[k][slot] = low[k];
    node.plane[k + 3][slot] = high[k];
  }
}

}  // namespace kerf
