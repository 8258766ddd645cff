#include "core/graph/traversal.h"

#include "core/base/assert.h"

namespace kerf {

Traversal traverse(const GraphLinks& links, uint32_t start) {
  KERF_ASSERT(start < links.nodes());
  Traversal t;
  t.rank.assign(links.nodes(), Traversal::kNone);
  const auto mark = [&](uint32_t node, uint32_t from) {
    t.rank[node] = static_cast<uint32_t>(t.order.size());
    t.order.push_back(node);
    t.from.push_back(from);
  };
  mark(start, Traversal::kNone);
  for (size_t i = 0; i < t.order.size(); ++i) {
    const uint32_t node = t.order[i];
    for (const uint32_t other : links.of(node)) {
      if (t.rank[other] == Traversal::kNone) mark(other, node);
    }
  }
  return t;
}

GraphComponents find_components(const GraphLinks& links) {
  GraphComponents found;
  found.of.assign(links.nodes(), kNoIndex);
  std::vector<uint32_t> queue;
  for (uint32_t start = 0; start < links.nodes(); ++start) {
    if (found.of[start] != kNoIndex) continue;
    const auto component = static_cast<uint32_t>(found.size.size());
    queue.assign(1, start);
    found.of[start] = component;
    for (size_t i = 0; i < queue.size(); ++i) {
      for (const uint32_t other : links.of(queue[i])) {
        if (found.of[other] != kNoIndex) continue;
        found.of[other] = component;
        queue.push_back(other);
      }
    }
    found.size.push_back(static_cast<uint32_t>(queue.size()));
  }
  return found;
}

}  // namespace kerf
