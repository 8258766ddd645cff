#include "core/tree/tree_store.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

// A record off the list of free ones, or a new one.
template <typename T>
uint32_t take(Pool<T>& pool, uint32_t& free, uint32_t& free_count) {
  if (free == kNoIndex) {
    pool.grow_to(pool.size() + 1);
    return pool.size() - 1;
  }
  const uint32_t taken = free;
  free = pool[taken].parent;
  --free_count;
  return taken;
}

}  // namespace

uint32_t TreeStore::add_node() {
  const uint32_t n = take(nodes, free_node_, free_node_count_);
  nodes[n].parent = kNoIndex;
  nodes[n].slot = 0;
  nodes[n].hit = 0;
  const FloatBox none;
  for (int k = 0; k < 6; ++k) {
    const __m128 plane = k < 3 ? none.low : none.high;
    _mm_store_ps(nodes[n].plane[k], plane);
    _mm_store_ps(nodes[n].plane[k] + 4, plane);
  }
  for (Child& child : nodes[n].child) child = Child{};
  return n;
}

uint32_t TreeStore::add_block() {
  const uint32_t b = take(blocks, free_block_, free_block_count_);
  blocks[b].parent = kNoIndex;
  blocks[b].slot = 0;
  blocks[b].hit = 0;
  return b;
}

void TreeStore::free_node(uint32_t n) {
  nodes[n].parent = free_node_;
  free_node_ = n;
  ++free_node_count_;
}

void TreeStore::free_block(uint32_t b) {
  set_count(b, 0);
  blocks[b].parent = free_block_;
  free_block_ = b;
  ++free_block_count_;
}

void TreeStore::set_count(uint32_t block, uint32_t count) {
  FaceBlock& b = blocks[block];
  single_count_ += uint32_t{count == 1} - uint32_t{b.count == 1};
  b.count = static_cast<uint8_t>(count);
}

void TreeStore::set_place(FaceId f, uint32_t place) {
  places_.grow_to(f.index + 1);
  places_[f.index] = place + 1;
}

// Blocks are filled by nine tenths, nodes by half, in a tree as built.
void TreeStore::reserve(uint32_t faces, uint32_t slots) {
  blocks.reserve(faces / 4 + faces / 32 + 1);
  nodes.reserve(faces / 16 + 1);
  places_.grow_to(slots);
}

void TreeStore::put(const TreeFace& face, uint32_t block, uint32_t lane) {
  FaceBlock& b = blocks[block];
  for (int i = 0; i < 3; ++i) {
    alignas(16) float xyz[4];
    _mm_store_ps(xyz, face.corner[i]);
    for (int k = 0; k < 3; ++k) b.corner[i][k][lane] = xyz[k];
    b.vertex[i][lane] = face.vertex[i].index;
  }
  b.face[lane] = face.face.index;
  set_place(face.face, block * kBlockWidth + lane);
}

FloatBox TreeStore::face_box(const FaceBlock& b, uint32_t lane) const {
  const auto corner = [&](int i) {
    return _mm_setr_ps(b.corner[i][0][lane], b.corner[i][1][lane], b.corner[i][2][lane], 0);
  };
  const __m128 p = corner(0), q = corner(1), r = corner(2);
  return {round_down(_mm_min_ps(_mm_min_ps(p, q), r)), round_up(_mm_max_ps(_mm_max_ps(p, q), r))};
}

FloatBox TreeStore::block_box(const FaceBlock& b) const {
  const FloatBox none;
  const __m128 empty = _mm_castsi128_ps(
      _mm_cmpgt_epi32(_mm_setr_epi32(1, 2, 3, 4), _mm_set1_epi32(static_cast<int>(b.count))));
  __m128 low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    const __m128 p = _mm_load_ps(b.corner[0][k]), q = _mm_load_ps(b.corner[1][k]),
                 r = _mm_load_ps(b.corner[2][k]);
    low[k] = _mm_blendv_ps(_mm_min_ps(_mm_min_ps(p, q), r), none.low, empty);
    high[k] = _mm_blendv_ps(_mm_max_ps(_mm_max_ps(p, q), r), none.high, empty);
  }
  return {round_down(least_of_rows(low[0], low[1], low[2])),
          round_up(most_of_rows(high[0], high[1], high[2]))};
}

FloatBox TreeStore::node_box(const WideNode& node) const {
  __m128 p[6];
  for (int k = 0; k < 6; ++k) {
    const __m128 a = _mm_load_ps(node.plane[k]), b = _mm_load_ps(node.plane[k] + 4);
    p[k] = k < 3 ? _mm_min_ps(a, b) : _mm_max_ps(a, b);
  }
  return {least_of_rows(p[0], p[1], p[2]), most_of_rows(p[3], p[4], p[5])};
}

FloatBox TreeStore::slot_box(uint32_t node, uint32_t slot) const {
  const auto& plane = nodes[node].plane;
  return {_mm_setr_ps(plane[0][slot], plane[1][slot], plane[2][slot], 0),
          _mm_setr_ps(plane[3][slot], plane[4][slot], plane[5][slot], 0)};
}

void TreeStore::set_slot_box(uint32_t node, uint32_t slot, const FloatBox& box) {
  alignas(16) float low[4], high[4];
  _mm_store_ps(low, box.low);
  _mm_store_ps(high, box.high);
  auto& plane = nodes[node].plane;
  for (int k = 0; k < 3; ++k) {
    plane[k][slot] = low[k];
    plane[k + 3][slot] = high[k];
  }
}

void TreeStore::hang(uint32_t node, uint32_t slot, Child child, const FloatBox& box) {
  nodes[node].child[slot] = child;
  set_slot_box(node, slot, box);
  uint32_t& parent = child.is_block() ? blocks[child.index()].parent : nodes[child.index()].parent;
  uint8_t& at = child.is_block() ? blocks[child.index()].slot : nodes[child.index()].slot;
  parent = node;
  at = static_cast<uint8_t>(slot);
}

void TreeStore::set_root_box(const FloatBox& box) {
  root_box_ = box;
  alignas(16) float far[4];
  const __m128 sign = _mm_set1_ps(-0.0f);
  _mm_store_ps(far, _mm_max_ps(_mm_andnot_ps(sign, box.low), _mm_andnot_ps(sign, box.high)));
  reach_ = glm::length(Vec3(far[0], far[1], far[2]));
}

TreeView TreeStore::view() const {
  static_assert(decltype(nodes)::kShift == TreeView::kShift && decltype(blocks)::kShift == TreeView::kShift);
  return {nodes.chunks(), blocks.chunks(), root};
}

void TreeStore::empty_slot(uint32_t node, uint32_t slot) {
  nodes[node].child[slot] = Child{};
  set_slot_box(node, slot, FloatBox{});
  nodes[node].hit = static_cast<uint8_t>(nodes[node].hit & ~(1u << slot));
}

}  // namespace kerf
