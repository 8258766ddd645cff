#include <algorithm>
#include <cassert>
#include <utility>

#include "core/tree/edit_tree_internal.h"

namespace kerf {

namespace {

template <typename Record>
void prefetch(const Record& record) {
  for (size_t at = 0; at < sizeof record; at += 64)
    __builtin_prefetch(reinterpret_cast<const char*>(&record) + at);
}

// Replacements are collected by the blocks that lose faces before these are filled, so that a face that is
// added and replaced again within a batch never enters the tree, and a block is divided once.
class Batch {
 public:
  Batch(TreeStore& tree, const Mesh& mesh) : tree_(tree), mesh_(mesh), filler_(tree) {}

  void record(const Replacement& r) {
    assert(r.removed_count > 0 && r.added_count > 0);
    if (changes_.size() + r.removed_count > kMaxChanges) apply();
    const uint32_t home = change_of(r.removed[0]);
    for (int i = 0; i < r.removed_count; ++i) remove(r.removed[i]);
    for (int i = 0; i < r.added_count; ++i) add(r.added[i], home);
  }

  // Fills the blocks before it removes empty ones, because the tree must not become empty in between.
  void apply() {
    for (BlockChange& c : changes_) {
      tree_.blocks.edit(c.block).change = 0;
      fill(c);
    }
    for (const BlockChange& c : changes_) {
      if (!c.filled) shrink_block(tree_, c.block);
    }
    changes_.clear();
    added_.clear();
  }

 private:
  // Places from here on are indices in added_.
  static constexpr uint32_t kAdded = 0xf0000000u;
  static constexpr uint32_t kMaxChanges = 0xffffu;  // fits FaceBlock::change

  // A block that loses faces, and the list of those added to it, latest first.
  struct BlockChange {
    uint32_t block;
    uint32_t latest = kNoIndex;  // in added_
    bool filled = false;
  };
  struct AddedFace {
    FaceId face;
    uint32_t change;
    uint32_t before;  // in the same list
  };

  // Returns the number of the change of the block in which a face is, or to which it is added.
  uint32_t change_of(FaceId f) {
    const uint32_t place = tree_.place(f);
    assert(place != kNoIndex);
    if (place >= kAdded) return added_[place - kAdded].change;
    const uint32_t block = place / kBlockWidth;
    FaceBlock& b = tree_.blocks.edit(block);
    if (b.change == 0) {
      prefetch(tree_.nodes[b.parent]);
      changes_.push_back({block});
      b.change = static_cast<uint16_t>(changes_.size());
    }
    return b.change - 1u;
  }

  void remove(FaceId f) {
    const uint32_t place = tree_.place(f);
    assert(place != kNoIndex);
    if (place >= kAdded) return tree_.set_place(f, kNoIndex);
    change_of(f);
    drop_lane(tree_, place / kBlockWidth, place % kBlockWidth);
  }

  void add(FaceId f, uint32_t change) {
    const auto at = static_cast<uint32_t>(added_.size());
    added_.push_back({f, change, std::exchange(changes_[change].latest, at)});
    tree_.set_place(f, kAdded + at);
  }

  // Adds the faces that no later replacement has removed.
  void fill(BlockChange& c) {
    faces_.clear();
    for (uint32_t at = c.latest; at != kNoIndex; at = added_[at].before) {
      const FaceId f = added_[at].face;
      if (tree_.place(f) == kAdded + at) faces_.emplace_back(tree_.frame, mesh_, positions_, f);
    }
    c.filled = !faces_.empty();
    if (c.filled) filler_.fill(c.block, faces_);
  }

  TreeStore& tree_;
  const Mesh& mesh_;
  Positions positions_ = mesh_.positions();
  BlockFiller filler_;
  std::vector<BlockChange> changes_;
  std::vector<AddedFace> added_;
  std::vector<TreeFace> faces_;
};

// Number of replacements by which each kind of record is prefetched ahead. A face that an earlier replacement
// adds has no block yet.
constexpr size_t kPlaceAhead = 6, kBlockAhead = 3;

}  // namespace

void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const Replacement> all) {
  Batch batch(tree, mesh);
  for (size_t i = 0; i < all.size(); ++i) {
    if (i + kPlaceAhead < all.size()) tree.prefetch_place(all[i + kPlaceAhead].removed[0]);
    if (i + kBlockAhead < all.size()) {
      const uint32_t place = tree.place(all[i + kBlockAhead].removed[0]);
      if (place / kBlockWidth < tree.blocks.size()) prefetch(tree.blocks[place / kBlockWidth]);
    }
    batch.record(all[i]);
  }
  batch.apply();
}

}  // namespace kerf
