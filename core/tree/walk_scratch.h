#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/tree/walks.h"

namespace kerf {

// The lists of one traversal. They lie in this object, i.e. on the caller's stack, as long as they are short.
// Construction and destruction are cheap, because a ray that misses everything takes only one or two hundred
// instructions.
class WalkScratch : public WalkLists {
 public:
  WalkScratch()
      : WalkLists{
            {nodes_, 0, kShort}, {blocks_, 0, kShort}, {faces_, 0, kShort}, {boxes_, 0, kShort}, lengthen} {}
  WalkScratch(const WalkScratch&) = delete;
  WalkScratch& operator=(const WalkScratch&) = delete;

  // The faces that the traversal listed, as face_word().
  std::span<const uintptr_t> found() const { return {faces.items, faces.count}; }
  // The faces whose boxes the traversal met, likewise.
  std::span<const uintptr_t> met() const { return {boxes.items, boxes.count}; }

 private:
  using Words = std::vector<uintptr_t>;
  static void lengthen(WalkLists& lists, WordList& list) {
    auto& self = static_cast<WalkScratch&>(lists);
    if (!self.long_lists_) self.long_lists_ = std::make_unique<std::vector<Words>>();
    Words& words = self.long_lists_->emplace_back(list.items, list.items + list.count);
    list.capacity *= 2;
    words.resize(list.capacity);
    list.items = words.data();
  }

  static constexpr uint32_t kShort = 96;
  std::unique_ptr<std::vector<Words>> long_lists_;
  uintptr_t nodes_[kShort], blocks_[kShort], faces_[kShort], boxes_[kShort];
};

}  // namespace kerf
