#pragma once

namespace kerf {

inline constexpr int kNextAxis[] = {1, 2, 0};
inline constexpr int kLongestAxis[] = {0, 0, 1, 0, 2, 2, 1, 0};

// Along which axis a vector is longest, the first of them, from the sizes of its components. Without
// branches.
template <typename T>
[[gnu::always_inline]] inline int longest_axis(T x, T y, T z) {
  return kLongestAxis[unsigned{x >= y} | unsigned{y >= z} << 1 | unsigned{z > x} << 2];
}

}  // namespace kerf
