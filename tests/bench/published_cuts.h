#pragma once

#include <span>

#include "core/laser/laser.h"

namespace kerf::bench {

// A published speed of a laser cut.
struct PublishedCut {
  int number;
  const char* material;       // a preset of assets/materials.json
  double millimetres, watts;  // thickness, power
  double slowest, fastest;    // m/min
  double kerf;                // mm, typical for the machine; hardly ever measured with the speed
  const char* what;           // material and gas as published
  const char* why;            // why no agreement within 30 % can be expected; empty where it can
  Assist assist = Assist::kNone;
};

// 34 rows of vendors' charts, teaching tables and measurements by hobbyists: machinemfg.com (1 to 10, 13),
// LaserSpecHub (14 to 22, 25, 26), leikepajatestaus (11, 12), protolab (23, 24, 27, 28), softsolder.com (29
// to 32), NexMaker (33), Burger et al. (34).
std::span<const PublishedCut> published_cuts();

}  // namespace kerf::bench
