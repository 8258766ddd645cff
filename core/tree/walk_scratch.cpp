#include "core/tree/walk_scratch.h"

namespace kerf {

void WalkScratch::List::lengthen(WordList& list) {
  auto& self = static_cast<List&>(list);
  if (self.many.empty()) self.many.assign(self.items, self.items + self.count);
  self.many.resize(2 * size_t{self.capacity});
  self.items = self.many.data();
  self.capacity *= 2;
}

}  // namespace kerf
