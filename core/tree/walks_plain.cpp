#include "core/tree/walk_code.h"

// Vectors of floats with the same interface as in walks_sse4.cpp, as arrays, for any processor.
namespace kerf::plain {

template <int kLanes>
struct Floats {
  float v[kLanes];

  [[gnu::always_inline]] inline static Floats load(const float* p) {
    return by_lane([p](int i) { return p[i]; });
  }
  [[gnu::always_inline]] inline static Floats all(float x) {
    return by_lane([x](int) { return x; });
  }
  [[gnu::always_inline]] inline void store(float* p) const {
    for (int i = 0; i < kLanes; ++i) p[i] = v[i];
  }
  // Four floats twice.
  [[gnu::always_inline]] inline static Floats twice(const Floats<kLanes / 2>& x) {
    return by_lane([&x](int i) { return x.v[i % (kLanes / 2)]; });
  }
  // Four times x in the lower lanes, four times y in the upper ones.
  [[gnu::always_inline]] inline static Floats pair(float x, float y) {
    return by_lane([x, y](int i) { return i < kLanes / 2 ? x : y; });
  }
  template <typename Lane>
  [[gnu::always_inline]] inline static Floats by_lane(Lane lane) {
    Floats made;
    for (int i = 0; i < kLanes; ++i) made.v[i] = lane(i);
    return made;
  }
};

template <int n>
[[gnu::always_inline]] inline Floats<n> operator+(const Floats<n>& a, const Floats<n>& b) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] + b.v[i]; });
}
template <int n>
[[gnu::always_inline]] inline Floats<n> operator-(const Floats<n>& a, const Floats<n>& b) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] - b.v[i]; });
}
template <int n>
[[gnu::always_inline]] inline Floats<n> operator*(const Floats<n>& a, const Floats<n>& b) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] * b.v[i]; });
}
template <int n>
[[gnu::always_inline]] inline Floats<n> product_minus(const Floats<n>& a, const Floats<n>& b,
                                                      const Floats<n>& c) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] * b.v[i] - c.v[i]; });
}
template <int n>
[[gnu::always_inline]] inline Floats<n> minus_product(const Floats<n>& a, const Floats<n>& b,
                                                      const Floats<n>& c) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] - b.v[i] * c.v[i]; });
}
// Like the instructions of SSE, these return the second number if the two are equal or one is NaN.
template <int n>
[[gnu::always_inline]] inline Floats<n> min(const Floats<n>& a, const Floats<n>& b) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
template <int n>
[[gnu::always_inline]] inline Floats<n> max(const Floats<n>& a, const Floats<n>& b) {
  return Floats<n>::by_lane([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
template <int n>
[[gnu::always_inline]] inline Floats<n> abs(const Floats<n>& a) {
  return Floats<n>::by_lane([&](int i) { return __builtin_fabsf(a.v[i]); });
}
// A mask with one bit per lane.
template <int n>
[[gnu::always_inline]] inline unsigned le(const Floats<n>& a, const Floats<n>& b) {
  unsigned bits = 0;
  for (int i = 0; i < n; ++i) bits |= unsigned{a.v[i] <= b.v[i]} << i;
  return bits;
}

}  // namespace kerf::plain

namespace kerf {

const Walks& walks_plain() {
  static constexpr Walks kWalks = WalkCode<plain::Floats<8>, plain::Floats<4>>::walks();
  return kWalks;
}

}  // namespace kerf
