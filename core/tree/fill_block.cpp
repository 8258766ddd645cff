#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <numeric>

#include "core/tree/edit_tree_internal.h"

namespace kerf {

namespace {

// Returns the mask of the slots without a child.
unsigned free_slots(const WideNode& node) {
  const Int4 none = all_lanes(INT32_C(-1));
  return mask_bits(load_lanes(&node.child[0].bits) == none) |
         mask_bits(load_lanes(&node.child[4].bits) == none) << 4;
}

size_t parts_for(size_t items, size_t width) { return (items + width - 1) / width; }

TreeFace face_in(const FaceBlock& block, uint32_t lane) {
  TreeFace face;
  for (int i = 0; i < 3; ++i) {
    face.corner[i] = Float4{block.corner[i][0][lane], block.corner[i][1][lane], block.corner[i][2][lane], 0};
    face.vertex[static_cast<size_t>(i)] = VertexId(block.vertex[i][lane]);
  }
  face.face = FaceId(block.face[lane]);
  return face;
}

// Returns an integer that compares like the float.
int32_t ordered(float x) {
  const auto bits = std::bit_cast<int32_t>(x);
  return bits < 0 ? bits ^ INT32_MAX : bits;
}

// Sorts at most kFewItems items by their coordinates, without a branch that depends on these: the place of an
// item is the number of smaller keys. The last bits of a key hold the item's number, which makes keys unique.
constexpr size_t kFewItems = 32;
void sort_few(std::span<uint32_t> items, const std::vector<Float4>& at, int axis) {
  std::array<uint32_t, kFewItems> before;
  alignas(16) std::array<int32_t, kFewItems> keys;
  std::ranges::copy(items, before.begin());
  for (size_t i = 0; i < items.size(); ++i) {
    constexpr auto kNumber = static_cast<int32_t>(kFewItems - 1);
    keys[i] = (ordered(at[items[i]][axis]) & ~kNumber) | static_cast<int32_t>(i);
  }
  for (size_t i = items.size(); i % 4 != 0; ++i) keys[i] = INT32_MAX;
  for (size_t i = 0; i < items.size(); ++i) {
    Int4 smaller{};
    for (size_t k = 0; k < items.size(); k += 4) smaller -= load_lanes(&keys[k]) < all_lanes(keys[i]);
    items[static_cast<size_t>(smaller[0] + smaller[1] + smaller[2] + smaller[3])] = before[i];
  }
}

int longest_side(const FloatBox& box) {
  const Float4 size = box.high - box.low;
  return longest_axis(size[0], size[1], size[2]);
}

}  // namespace

// Prepares the division of this many items, numbered from 0.
void BlockFiller::start(size_t items) {
  items_.resize(items);
  std::iota(items_.begin(), items_.end(), 0u);
  centres2_.clear();
}

// Moves the items of the first half of `parts` equal parts, in the order along the longest axis, to the
// front. Returns their number.
size_t BlockFiller::divide(std::span<uint32_t> items, size_t parts) {
  assert(parts >= 2 && items.size() >= parts);
  FloatBox centres;
  for (const uint32_t i : items) centres.add(centres2_[i], centres2_[i]);
  const int axis = longest_side(centres);
  const size_t first = items.size() * ((parts + 1) / 2) / parts;
  if (items.size() <= kFewItems) {
    sort_few(items, centres2_, axis);
  } else {
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(first), items.end(),
                     [&](uint32_t a, uint32_t b) { return centres2_[a][axis] < centres2_[b][axis]; });
  }
  return first;
}

void BlockFiller::fill(uint32_t block, std::span<const TreeFace> faces) {
  assert(!faces.empty());
  const uint32_t parent = tree_.blocks[block].parent, slot = tree_.blocks[block].slot;
  const uint32_t count = tree_.blocks[block].count;
  if (count + faces.size() <= kBlockWidth) {
    for (uint32_t i = 0; i < faces.size(); ++i) tree_.put(faces[i], block, count + i);
    tree_.set_count(block, count + static_cast<uint32_t>(faces.size()));
    const FloatBox box = tree_.block_box(tree_.blocks[block]);
    tree_.set_slot_box(parent, slot, box);
    return grow_above(tree_, parent, box);
  }
  faces_.clear();
  for (uint32_t lane = 0; lane < count; ++lane) faces_.push_back(face_in(tree_.blocks[block], lane));
  faces_.insert(faces_.end(), faces.begin(), faces.end());
  start(faces_.size());
  for (const TreeFace& face : faces_) {
    const FloatBox box = face.box();
    centres2_.push_back(box.low + box.high);
  }
  children_.clear();
  close_blocks(block, items_);
  while (children_.size() > kNodeWidth) gather_in_nodes();
  hang(parent, slot);
}

// Divides faces among blocks, the first of which exists.
void BlockFiller::close_blocks(uint32_t first, std::span<uint32_t> faces) {
  if (faces.size() <= kBlockWidth) return close_block(first, faces);
  const size_t left = divide(faces, parts_for(faces.size(), kBlockWidth));
  close_blocks(first, faces.first(left));
  close_blocks(tree_.add_block(), faces.subspan(left));
}

void BlockFiller::close_block(uint32_t block, std::span<const uint32_t> faces) {
  assert(!faces.empty() && faces.size() <= kBlockWidth);
  FloatBox box;
  for (uint32_t lane = 0; lane < faces.size(); ++lane) {
    const TreeFace& face = faces_[faces[lane]];
    tree_.put(face, block, lane);
    box.add(face.box());
  }
  tree_.set_count(block, static_cast<uint32_t>(faces.size()));
  children_.push_back({Child::block(block), box});
}

// Hangs runs of children, which are in the order of their division, in new nodes, and replaces them by these.
void BlockFiller::gather_in_nodes() {
  const size_t parts = parts_for(children_.size(), kNodeWidth);
  std::vector<Boxed> nodes;
  for (size_t part = 0, next = 0; part < parts; ++part) {
    const size_t end = children_.size() * (part + 1) / parts;
    const uint32_t n = tree_.add_node();
    FloatBox all;
    for (uint32_t slot = 0; next < end; ++next, ++slot) {
      tree_.hang(n, slot, children_[next].child, children_[next].box);
      all.add(children_[next].box);
    }
    nodes.push_back({Child::node(n), all});
  }
  children_ = std::move(nodes);
}

// Hangs the children in a slot and in free slots of the same node.
void BlockFiller::hang(uint32_t parent, uint32_t slot) {
  assert(!children_.empty() && children_.size() <= kNodeWidth);
  FloatBox all;
  for (const Boxed& c : children_) all.add(c.box);
  unsigned free = free_slots(tree_.nodes[parent]);
  if (children_.size() <= 1u + static_cast<unsigned>(std::popcount(free))) {
    tree_.hang(parent, slot, children_[0].child, children_[0].box);
    for (size_t i = 1; i < children_.size(); ++i, free &= free - 1)
      tree_.hang(parent, static_cast<uint32_t>(std::countr_zero(free)), children_[i].child, children_[i].box);
    return grow_above(tree_, parent, all);
  }
  const uint32_t above = tree_.nodes[parent].parent;
  const unsigned free_above = parent == tree_.root ? 0 : free_slots(tree_.nodes[above]);
  if (free_above != 0) {
    for (uint32_t s = 0; s < kNodeWidth; ++s) {
      if (s != slot && !tree_.nodes[parent].child[s].none())
        children_.push_back({tree_.nodes[parent].child[s], tree_.slot_box(parent, s)});
    }
    divide_node(parent, above, static_cast<uint32_t>(std::countr_zero(free_above)));
  } else {
    const uint32_t n = tree_.add_node();
    for (uint32_t s = 0; s < children_.size(); ++s) tree_.hang(n, s, children_[s].child, children_[s].box);
    tree_.hang(parent, slot, Child::node(n), all);
    grow_above(tree_, parent, all);
  }
}

// Divides the children, at most twice the width of a node, among a node and a new one in a free slot of the
// node above.
void BlockFiller::divide_node(uint32_t node, uint32_t above, uint32_t free_slot) {
  assert(children_.size() >= 2 && children_.size() <= 2 * kNodeWidth);
  start(children_.size());
  for (const Boxed& c : children_) centres2_.push_back(c.box.low + c.box.high);
  const size_t first = divide(items_, 2);
  const uint32_t fresh = tree_.add_node();
  FloatBox boxes[2];
  for (uint32_t i = 0; i < items_.size(); ++i) {
    const Boxed& c = children_[items_[i]];
    const bool goes = i >= first;
    tree_.hang(goes ? fresh : node, static_cast<uint32_t>(goes ? i - first : i), c.child, c.box);
    boxes[goes].add(c.box);
  }
  for (auto s = static_cast<uint32_t>(first); s < kNodeWidth; ++s) tree_.empty_slot(node, s);
  tree_.set_slot_box(above, tree_.nodes[node].slot, boxes[0]);
  tree_.hang(above, free_slot, Child::node(fresh), boxes[1]);
  boxes[0].add(boxes[1]);
  grow_above(tree_, above, boxes[0]);
}

}  // namespace kerf
