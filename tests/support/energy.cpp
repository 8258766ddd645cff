#include "tests/support/energy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf::test {

void expect_closed_ledger(const World& world, double tolerance) {
  const EnergyLedger& ledger = world.energy();
  double stored = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    stored += body.heat.stored(body.mesh);
    body.mesh.columns().for_each_set(body.heat.energy, [&](FaceId f) {
      EXPECT_TRUE(body.mesh.is_live(f));
      EXPECT_GE(body.heat.energy_of(body.mesh, f), 0);
    });
  }
  EXPECT_NEAR(ledger.absorbed + ledger.escaped, ledger.emitted, tolerance * ledger.emitted);
  EXPECT_NEAR(stored + ejected_energy(world) + ledger.lost, ledger.absorbed + ledger.burnt,
              tolerance * ledger.emitted);
}

double hottest(const World& world) {
  double most = kAmbient;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    body.mesh.columns().for_each_set(body.heat.energy, [&](FaceId f) {
      most = std::max(most, body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
    });
  }
  return most;
}

}  // namespace kerf::test
