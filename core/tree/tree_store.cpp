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
  for (uint32_t s = 0; s < kNodeWidth; ++s) empty_slot(n, s);
  return n;
}

uint32_t TreeStore::add_block() {
  const uint32_t b = take(blocks, free_block_, free_block_count_);
  blocks[b] = FaceBlock{};
  blocks[b].parent = kNoIndex;
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

void TreeStore::write_face(const Mesh& mesh, FaceId f, uint32_t block, uint32_t lane) {
  FaceBlock& b = blocks[block];
  const auto corners = mesh.corners(f);
  for (int i = 0; i < 3; ++i) {
    const Vec3 p = frame.to_tree(mesh.position(corners[i]));
    for (int k = 0; k < 3; ++k) b.corner[i][k][lane] = static_cast<float>(p[k]);
    b.vertex[i][lane] = corners[i].index;
  }
  b.face[lane] = f.index;
  set_place(f, block * kBlockWidth + lane);
}

FloatBox TreeStore::face_box(const FaceBlock& b, uint32_t lane) const {
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    const float x = b.corner[0][k][lane], y = b.corner[1][k][lane], z = b.corner[2][k][lane];
    box.low[k] = round_down(std::min({x, y, z}));
    box.high[k] = round_up(std::max({x, y, z}));
  }
  return box;
}

FloatBox TreeStore::block_box(const FaceBlock& b) const {
  FloatBox box;
  for (uint32_t lane = 0; lane < b.count; ++lane) box.add(face_box(b, lane));
  return box;
}

FloatBox TreeStore::node_box(const WideNode& node) const {
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = *std::min_element(node.plane[k], node.plane[k] + kNodeWidth);
    box.high[k] = *std::max_element(node.plane[k + 3], node.plane[k + 3] + kNodeWidth);
  }
  return box;
}

FloatBox TreeStore::slot_box(uint32_t node, uint32_t slot) const {
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = nodes[node].plane[k][slot];
    box.high[k] = nodes[node].plane[k + 3][slot];
  }
  return box;
}

void TreeStore::set_slot_box(uint32_t node, uint32_t slot, const FloatBox& box) {
  for (int k = 0; k < 3; ++k) {
    nodes[node].plane[k][slot] = box.low[k];
    nodes[node].plane[k + 3][slot] = box.high[k];
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
  Vec3 far;
  for (int k = 0; k < 3; ++k) far[k] = std::max(std::abs(double{box.low[k]}), std::abs(double{box.high[k]}));
  reach_ = glm::length(far);
}

TreeView TreeStore::view() const {
  static_assert(nodes.kShift == TreeView::kShift && blocks.kShift == TreeView::kShift);
  return {nodes.chunks(), blocks.chunks(), root};
}

void TreeStore::empty_slot(uint32_t node, uint32_t slot) {
  nodes[node].child[slot] = Child{};
  set_slot_box(node, slot, FloatBox{});
  nodes[node].hit = static_cast<uint8_t>(nodes[node].hit & ~(1u << slot));
}

}  // namespace kerf
