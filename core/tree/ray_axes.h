#pragma once

namespace kerf {

// The cyclic successor of each axis.
inline constexpr int kNextAxis[] = {1, 2, 0};
// Results of longest_axis, indexed by its three comparisons.
inline constexpr int kLongestAxis[] = {0, 0, 1, 0, 2, 2, 1, 0};

// The index of the largest of three absolute components, the first of them if several are equal. Free of
// branches.
template <typename T>
[[gnu::always_inline]] inline int longest_axis(T x, T y, T z) {
  return kLongestAxis[unsigned{x >= y} | unsigned{y >= z} << 1 | unsigned{z > x} << 2];
}

}  // namespace kerf
