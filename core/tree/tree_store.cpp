#include "core/tree/tree_store.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Returns the reciprocal of the largest power of two not above x, clamped to stay finite. Precondition: x is
// positive and finite.
double power_of_two_over(double x) {
  KERF_ASSERT(x > 0 && std::isfinite(x));
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, std::min(1 - exponent, 1000));
}

// Takes a record from the free list, or a new one.
template <typename T>
uint32_t take(Records<T>& pool, uint32_t& free, uint32_t& free_count) {
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

TreeFrame TreeFrame::around(const Bounds& bounds) {
  TreeFrame frame;
  if (bounds.is_none()) return frame;
  frame.origin = bounds.centre();
  const Vec3 half = bounds.max - frame.origin;
  const double extent = std::max({half.x, half.y, half.z});
  if (extent > 0) frame.scale = power_of_two_over(extent);
  return frame;
}

void make_empty(WideNode& node) {
  node.parent = kNoIndex;
  node.slot = 0;
  const FloatBox none;
  for (int k = 0; k < 6; ++k) {
    const Float4 plane = k < 3 ? none.low : none.high;
    store_lanes(node.plane[k], plane);
    store_lanes(node.plane[k] + 4, plane);
  }
  for (Child& child : node.child) child = Child{};
}

void set_slot_box(WideNode& node, uint32_t slot, const FloatBox& box) {
  assert(slot < kNodeWidth);
  for (int k = 0; k < 3; ++k) {
    node.plane[k][slot] = box.low[k];
    node.plane[k + 3][slot] = box.high[k];
  }
}

uint32_t TreeStore::add_node() {
  const uint32_t n = take(nodes, TreeCounts::free_node, TreeCounts::free_node_count);
  make_empty(nodes.edit(n));
  return n;
}

uint32_t TreeStore::add_block() {
  const uint32_t b = take(blocks, TreeCounts::free_block, TreeCounts::free_block_count);
  FaceBlock& block = blocks.edit(b);
  block.parent = kNoIndex;
  block.slot = 0;
  block.change = 0;
  return b;
}

void TreeStore::free_node(uint32_t n) {
  nodes.edit(n).parent = TreeCounts::free_node;
  TreeCounts::free_node = n;
  ++TreeCounts::free_node_count;
}

void TreeStore::free_block(uint32_t b) {
  set_count(b, 0);
  blocks.edit(b).parent = TreeCounts::free_block;
  TreeCounts::free_block = b;
  ++TreeCounts::free_block_count;
}

void TreeStore::set_count(uint32_t block, uint32_t count) {
  assert(count <= kBlockWidth);
  FaceBlock& b = blocks.edit(block);
  TreeCounts::single_count += uint32_t{count == 1} - uint32_t{b.count == 1};
  b.count = static_cast<uint8_t>(count);
}

void TreeStore::set_place(FaceId f, uint32_t place) {
  places_.grow_to(f.index + 1);
  places_.edit(f.index) = place + 1;
}

// A newly built tree fills its blocks to about nine tenths and its nodes to about one half.
void TreeStore::reserve(uint32_t faces, uint32_t slots) {
  nodes.grow_on_huge_pages();
  blocks.grow_on_huge_pages();
  blocks.reserve(faces / 4 + faces / 32 + 1);
  nodes.reserve(faces / 16 + 1);
  places_.grow_to(slots);
}

void TreeStore::put(const TreeFace& face, uint32_t block, uint32_t lane) {
  assert(lane < kBlockWidth);
  FaceBlock& b = blocks.edit(block);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) b.corner[i][k][lane] = face.corner[i][k];
    b.vertex[i][lane] = face.vertex[i].index;
  }
  b.face[lane] = face.face.index;
  set_place(face.face, block * kBlockWidth + lane);
}

bool TreeStore::holds(const TreeFace& face, uint32_t block, uint32_t lane) const {
  assert(lane < kBlockWidth);
  const FaceBlock& b = blocks[block];
  if (b.face[lane] != face.face.index) return false;
  const auto same_corner = [&](int own, int given) {
    bool same = b.vertex[own][lane] == face.vertex[static_cast<size_t>(given)].index;
    for (int k = 0; k < 3; ++k) same = same && b.corner[own][k][lane] == face.corner[given][k];
    return same;
  };
  for (int turn = 0; turn < 3; ++turn) {
    if (same_corner(0, turn) && same_corner(1, (turn + 1) % 3) && same_corner(2, (turn + 2) % 3)) return true;
  }
  return false;
}

FloatBox TreeStore::face_box(const FaceBlock& b, uint32_t lane) const {
  const auto corner = [&](int i) {
    return Float4{b.corner[i][0][lane], b.corner[i][1][lane], b.corner[i][2][lane], 0};
  };
  const Float4 p = corner(0), q = corner(1), r = corner(2);
  return {round_down(min_lanes(min_lanes(p, q), r)), round_up(max_lanes(max_lanes(p, q), r))};
}

FloatBox TreeStore::block_box(const FaceBlock& b) const {
  const FloatBox none;
  const Int4 empty = Int4{1, 2, 3, 4} > all_lanes(int32_t{b.count});
  Float4 low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    const Float4 p = load_lanes(b.corner[0][k]), q = load_lanes(b.corner[1][k]),
                 r = load_lanes(b.corner[2][k]);
    low[k] = empty ? none.low : min_lanes(min_lanes(p, q), r);
    high[k] = empty ? none.high : max_lanes(max_lanes(p, q), r);
  }
  return {round_down(min_of_rows(low[0], low[1], low[2])), round_up(max_of_rows(high[0], high[1], high[2]))};
}

FloatBox TreeStore::node_box(const WideNode& node) const {
  Float4 p[6];
  for (int k = 0; k < 6; ++k) {
    const Float4 a = load_lanes(node.plane[k]), b = load_lanes(node.plane[k] + 4);
    p[k] = k < 3 ? min_lanes(a, b) : max_lanes(a, b);
  }
  return {min_of_rows(p[0], p[1], p[2]), max_of_rows(p[3], p[4], p[5])};
}

FloatBox TreeStore::slot_box(uint32_t node, uint32_t slot) const {
  assert(slot < kNodeWidth);
  const auto& plane = nodes[node].plane;
  return {Float4{plane[0][slot], plane[1][slot], plane[2][slot], 0},
          Float4{plane[3][slot], plane[4][slot], plane[5][slot], 0}};
}

void TreeStore::set_slot_box(uint32_t node, uint32_t slot, const FloatBox& box) {
  kerf::set_slot_box(nodes.edit(node), slot, box);
}

void TreeStore::hang(uint32_t node, uint32_t slot, Child child, const FloatBox& box) {
  assert(slot < kNodeWidth && !child.none());
  nodes.edit(node).child[slot] = child;
  set_slot_box(node, slot, box);
  const auto link_back = [&](auto& record) {
    record.parent = node;
    record.slot = static_cast<uint8_t>(slot);
  };
  if (child.is_block())
    link_back(blocks.edit(child.index()));
  else
    link_back(nodes.edit(child.index()));
}

void TreeStore::set_root_box(const FloatBox& box) {
  TreeCounts::root_box = box;
  const Float4 far = max_lanes(abs_lanes(box.low), abs_lanes(box.high));
  TreeCounts::reach = glm::length(Vec3(far[0], far[1], far[2]));
}

size_t TreeStore::bytes() const { return nodes.bytes() + blocks.bytes() + places_.bytes(); }

void TreeStore::empty_slot(uint32_t node, uint32_t slot) {
  assert(slot < kNodeWidth);
  WideNode& n = nodes.edit(node);
  n.child[slot] = Child{};
  set_slot_box(node, slot, FloatBox{});
}

}  // namespace kerf
