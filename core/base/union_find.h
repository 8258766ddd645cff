#pragma once

#include <cassert>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace kerf {

// Disjoint sets over 0 .. count-1 with path halving (R. Tarjan, J. van Leeuwen: Worst-case analysis of set
// union algorithms, 1984). The representative of a set is its least member.
class UnionFind {
 public:
  explicit UnionFind(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  // The representative of the set of x. Precondition: x < count. Amortised O(log count).
  uint32_t find(uint32_t x) {
    assert(x < parent_.size());
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }
  // Merges the sets of a and b. Returns whether they were different sets. Precondition: both are < count.
  bool unite(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  std::vector<uint32_t> parent_;
};

}  // namespace kerf
