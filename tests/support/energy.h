#pragma once

#include "core/world/world.h"

namespace kerf::test {

// Expects that emitted = absorbed + escaped and absorbed = stored + ejected + lost, to a share of what was
// emitted, and that no face has less than no energy.
void expect_closed_ledger(const World& world, double tolerance);

// The temperature of the hottest face (K).
double hottest(const World& world);

}  // namespace kerf::test
