#include "core/heat/cut_remedies.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kNarrowest = 0.02;  // of the kerf
constexpr int kHalvings = 50;

double widest_kerf(LumpedCut cut, double thickness, double speed) {
  const auto cuts = [&](double kerf) {
    cut.kerf = kerf;
    return cut_thickness(cut, speed) >= thickness;
  };
  double high = cut.kerf, low = kNarrowest * high;
  if (!cuts(low)) return 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (cuts(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

CutRemedies remedies(const LumpedCut& cut, double thickness, double speed) {
  KERF_ASSERT(thickness > 0 && speed > 0 && cut.kerf > 0 && cut.power > 0);
  const double reached = cut_thickness(cut, speed);
  if (reached >= thickness) return {speed, cut.power, cut.kerf};
  return {cutting_speed(cut, thickness), cut.power * thickness / reached, widest_kerf(cut, thickness, speed)};
}

}  // namespace kerf
