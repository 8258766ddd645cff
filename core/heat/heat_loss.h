#pragma once

#include "core/heat/substance.h"

namespace kerf {

// What the sheet loses to its surroundings from both sides.
struct HeatLoss {
  double convection = 15;  // W/(m^2 K), from each side; still air
};

inline constexpr double kStefanBoltzmann = 5.670374419e-8;  // W/(m^2 K^4)

// What both sides of a sheet lose at a temperature (K) by convection and grey radiation, over its difference
// from the ambient: W/(m^2 K).
constexpr double heat_lost_per_kelvin(const Substance& s, const HeatLoss& loss, double temperature) {
  const double squares = temperature * temperature + kAmbient * kAmbient;
  return 2 * (loss.convection + s.emissivity * kStefanBoltzmann * squares * (temperature + kAmbient));
}

// The derivative of what they lose (W/m^2) by the temperature, W/(m^2 K).
constexpr double heat_lost_slope(const Substance& s, const HeatLoss& loss, double temperature) {
  return 2 *
         (loss.convection + 4 * s.emissivity * kStefanBoltzmann * temperature * temperature * temperature);
}

}  // namespace kerf
