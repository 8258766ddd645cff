#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace kerf {

// How much area of a surface deviates how far from its facets; see BaseFaces::deviation().
class CurvedArea {
 public:
  // Notes that the smooth normal at a corner of a face of this area deviates by an angle of this sine.
  void note(double sine, double area) {
    if (sine < kFlat) return;
    by_sine_[std::min(static_cast<size_t>(sine * kSteps), kSteps - 1)] += area;
  }
  void add(const CurvedArea& other) {
    for (size_t i = 0; i < kSteps; ++i) by_sine_[i] += other.by_sine_[i];
  }
  // The sine that nine tenths of the area do not exceed; 0 without area.
  float deviation() const {
    constexpr double kLargeShare = 0.9;
    double all = 0, below = 0;
    for (const double area : by_sine_) all += area;
    float sine = 0;
    for (size_t i = 0; i < kSteps && below < kLargeShare * all; ++i) {
      below += by_sine_[i];
      sine = static_cast<float>(i + 1) / kSteps;
    }
    return sine;
  }

 private:
  static constexpr size_t kSteps = 100;
  static constexpr double kFlat = 0.01;  // deviations below it are none
  std::array<double, kSteps> by_sine_{};
};

}  // namespace kerf
