#pragma once

#include "core/base/interval.h"

namespace kerf {

// How the lasers of a match work. Shares of energy and heat are of what the laser holds, or bears, at most.
struct LaserRules {
  double range = 40;                   // m
  Interval radius{0.012, 0.035};       // m, of the narrowest and the widest beam
  double drain = 0.16, charge = 0.11;  // 1/s, of energy, while it fires at medium width and while it does not
  double charge_driving = charge;      // 1/s, likewise while the vehicle drives at kDriving or more
  double heating = 0.34, cooling = 0.3;  // 1/s, likewise
  double cooled = 0.35;                  // the heat below which an overheated laser fires again
  static constexpr double kDriving = 8;  // m/s
};

}  // namespace kerf
