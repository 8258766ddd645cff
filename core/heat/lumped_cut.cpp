#include "core/heat/lumped_cut.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

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

// Returns the power that the cut takes per thickness (W/m).
double power_per_thickness(const LumpedCut& cut, double speed) {
  KERF_ASSERT(cut.axis >= 1);
  const Substance& s = cut.substance;
  const double burning = cut.oxygen ? burning_heat(s, speed) : 0;
  const double removal = cut.kerf * speed * s.density * (enthalpy_of_removal(s) / cut.axis - burning);
  if (s.conductivity == 0) return removal;
  return removal +
         s.conductivity * (s.transition - kAmbient) * conduction_loss(speed * peclet_per_speed(cut));
}

// Returns a speed (m/s) with sufficient power, or nullopt: with oxygen the highest of many samples up to the
// burning front, because combustion may need a minimum speed; else the lowest speed.
std::optional<double> possible_speed(const LumpedCut& cut, double available) {
  const double least = cut.substance.conductivity == 0 ? 0 : kLosses.front().peclet / peclet_per_speed(cut);
  constexpr int kTried = 400;
  for (int i = cut.oxygen ? kTried : 0; i > 0; --i) {
    const double speed = kBurningFront * i / kTried;
    if (speed >= least && power_per_thickness(cut, speed) <= available) return speed;
  }
  return power_per_thickness(cut, least) <= available ? std::optional(least) : std::nullopt;
}

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

double conduction_loss(double peclet) {
  KERF_ASSERT(peclet >= 0);
  if (peclet <= kLosses.front().peclet) return kLosses.front().loss;
  if (peclet >= kLosses.back().peclet)
    return kLosses.back().loss * det::exp(kFastExponent * det::log(peclet / kLosses.back().peclet));
  const auto* above =
      std::find_if(kLosses.begin(), kLosses.end(), [&](const Point& p) { return p.peclet > peclet; });
  const Point low = *(above - 1), high = *above;
  const double share = det::log(peclet / low.peclet) / det::log(high.peclet / low.peclet);
  return low.loss * det::exp(share * det::log(high.loss / low.loss));
}

double cutting_speed(const LumpedCut& cut, double thickness) {
  KERF_ASSERT(thickness > 0 && cut.kerf > 0);
  const double available = absorbed(cut) / thickness;
  const Substance& s = cut.substance;
  const std::optional<double> possible = possible_speed(cut, available);
  if (!possible) return 0;
  double low = *possible;
  double high = cut.axis * available / (cut.kerf * s.density * enthalpy_of_removal(s));  // without conduction
  if (cut.oxygen) high += cut.axis * kBurningFront * burning_heat(s, 0) / enthalpy_of_removal(s);
  if (high <= low) return 0;
  constexpr int kHalvings = 100;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (power_per_thickness(cut, middle) > available ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double cut_thickness(const LumpedCut& cut, double speed) {
  KERF_ASSERT(speed > 0 && cut.kerf > 0);
  const double power = power_per_thickness(cut, speed);
  return power > 0 ? absorbed(cut) / power : std::numeric_limits<double>::infinity();
}

CutRemedies remedies(const LumpedCut& cut, double thickness, double speed) {
  KERF_ASSERT(thickness > 0 && speed > 0 && cut.kerf > 0 && cut.power > 0);
  const double reached = cut_thickness(cut, speed);
  if (reached >= thickness) return {speed, cut.power, cut.kerf};
  const double power =
      reached > 0 ? cut.power * thickness / reached : std::numeric_limits<double>::infinity();
  return {cutting_speed(cut, thickness), power, widest_kerf(cut, thickness, speed)};
}

}  // namespace kerf
