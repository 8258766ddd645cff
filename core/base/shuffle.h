#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/random.h"

namespace kerf {

// Varies what no result may depend on: the order in which a query of a tree lists faces, the shape of trees,
// and the number of faces that are processed together. Off unless the environment variable KERF_SHUFFLE
// holds a seed, for tests that compare results.
class Shuffle {
 public:
  // The one of this process; the environment is read once.
  static const Shuffle& chosen();

  bool on() const { return seed_ != 0; }
  // A generator for one choice, which `about` tells from others; the same for equal seeds and choices.
  Random random(uint64_t about) const { return Random(hash_combine(seed_, about)); }

  // Whether this is one of the calls, one of `times` on average, for which it returns true; false if off.
  bool once_in(uint64_t times) const;

  // Brings the items from index `first` on into a random order, which depends on how many they are.
  template <typename T>
  void reorder(std::vector<T>& items, size_t first) const {
    if (!on()) return;
    Random random = this->random(items.size());
    for (size_t i = items.size(); i > first + 1; --i)
      std::swap(items[i - 1], items[first + random.below(i - first)]);
  }

 private:
  uint64_t seed_ = 0;
};

}  // namespace kerf
