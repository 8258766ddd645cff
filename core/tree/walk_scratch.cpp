#include "core/tree/walk_scratch.h"

namespace kerf {

void WalkScratch::lengthen(WalkLists& lists, WordList& list) {
  auto& self = static_cast<WalkScratch&>(lists);
  if (!self.long_lists_) self.long_lists_ = std::make_unique<std::vector<Words>>();
  Words& words = self.long_lists_->emplace_back(list.items, list.items + list.count);
  list.capacity *= 2;
  words.resize(list.capacity);
  list.items = words.data();
}

}  // namespace kerf
