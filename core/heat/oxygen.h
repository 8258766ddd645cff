#pragma once

#include "core/heat/substance.h"

namespace kerf {

// Laser cutting with oxygen: a share of the kerf burns (Substance::burnt_share), and its heat helps to melt
// the rest (A. Ivarson et al., Journal of Materials Processing Technology 40, 1994). With more than about a
// quarter of iron burnt that heat alone would melt the kerf at any speed; so the rate is bounded, too: oxygen
// reaches the iron through what is molten and burnt already, and a front does not burn faster than
// kBurningFront. Both numbers are empirical.

// J/kg, of iron that burns to FeO: 267 kJ/mol.
inline constexpr double kHeatOfBurning = 4.78e6;
// m/s: 2 m/min, up to which the front runs ahead of a beam and leaves striations (Y. Arata et al.,
// Transactions of JWRI 8, 1979).
inline constexpr double kBurningFront = 1.0 / 30;
// K, at which iron catches fire.
inline constexpr double kKindling = 1143;

// The heat (J/kg) that burning adds to each kilogram of the kerf of a beam that goes on at a speed (m/s).
constexpr double burning_heat(const Substance& s, double speed) {
  return s.burnt_share * kHeatOfBurning * (speed > kBurningFront ? kBurningFront / speed : 1);
}

}  // namespace kerf
