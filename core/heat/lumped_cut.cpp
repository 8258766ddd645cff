#include "core/heat/lumped_cut.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/base/exponential.h"

namespace kerf {
namespace {

struct Point {
  double peclet, loss;
};
constexpr std::array<Point, 11> kLosses{{{0.01, 1.2902},
                                         {0.02, 1.4773},
                                         {0.05, 1.8031},
                                         {0.1, 2.1315},
                                         {0.2, 2.5576},
                                         {0.5, 3.3245},
                                         {1, 4.1065},
                                         {2, 5.1111},
                                         {3, 5.8233},
                                         {5, 6.8755},
                                         {8, 8.0204}}};
constexpr double kFastExponent = 0.36;

double absorbed(const LumpedCut& cut) { return absorptivity(cut.substance, cut.wavelength) * cut.power; }

double peclet_per_speed(const LumpedCut& cut) {
  const Substance& s = cut.substance;
  return cut.kerf * s.density * s.heat_solid / (4 * s.conductivity);
}

// The power that the cut takes per thickness (W/m).
double power_per_thickness(const LumpedCut& cut, double speed) {
  const Substance& s = cut.substance;
  const double removal = cut.kerf * speed * s.density * enthalpy_of_removal(s) / cut.axis;
  if (s.conductivity == 0) return removal;
  return removal +
         s.conductivity * (s.transition - kAmbient) * conduction_loss(speed * peclet_per_speed(cut));
}

}  // namespace

double conduction_loss(double peclet) {
  KERF_ASSERT(peclet >= 0);
  if (peclet <= kLosses.front().peclet) return kLosses.front().loss;
  if (peclet >= kLosses.back().peclet)
    return kLosses.back().loss * exponential(kFastExponent * logarithm(peclet / kLosses.back().peclet));
  const auto* above =
      std::find_if(kLosses.begin(), kLosses.end(), [&](const Point& p) { return p.peclet > peclet; });
  const Point low = *(above - 1), high = *above;
  const double share = logarithm(peclet / low.peclet) / logarithm(high.peclet / low.peclet);
  return low.loss * exponential(share * logarithm(high.loss / low.loss));
}

double cutting_speed(const LumpedCut& cut, double thickness) {
  KERF_ASSERT(thickness > 0 && cut.kerf > 0);
  const double available = absorbed(cut) / thickness;
  const Substance& s = cut.substance;
  double low = s.conductivity == 0 ? 0 : kLosses.front().peclet / peclet_per_speed(cut);
  double high = cut.axis * available / (cut.kerf * s.density * enthalpy_of_removal(s));  // without conduction
  if (high <= low || power_per_thickness(cut, low) > available) return 0;
  constexpr int kHalvings = 100;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (power_per_thickness(cut, middle) > available ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double cut_thickness(const LumpedCut& cut, double speed) {
  KERF_ASSERT(speed > 0 && cut.kerf > 0);
  return absorbed(cut) / power_per_thickness(cut, speed);
}

}  // namespace kerf
