#include "core/world/heat_flow.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/heat/face_heat.h"

namespace kerf {

void step_heat(World& world, BodyId id, double seconds) {
  KERF_ASSERT(seconds >= 0);
  Body& body = world.body(id);
  if (seconds <= 0 || body.mesh.columns().blank()) return;
  world.edit_energy().lost += conduct(body.mesh, body.heat, body.sheet.substance, body.sheet.thickness,
                                      HeatLoss{}, seconds, world.heat_memory());
}

namespace {

void flow(World& world, double seconds) {
  for (const BodyId id : world.ids()) step_heat(world, id, seconds);
}

}  // namespace

void step_heat(World& world, double seconds) {
  flow(world, seconds);
  if (is_hot(world)) world.edit_energy().ahead += seconds;
}

void cool(World& world, double seconds) {
  const double done = std::min(seconds, world.energy().ahead);
  if (done > 0) world.edit_energy().ahead -= done;
  flow(world, seconds - done);
}

void cool_for_ticks(World& world, Ticks passed) {
  KERF_ASSERT(passed <= world.clock());
  const Ticks flows = world.clock() / kTicksOfFlow - (world.clock() - passed) / kTicksOfFlow;
  for (Ticks i = 0; i < flows; ++i) cool(world, static_cast<double>(kTicksOfFlow) / kTicksPerSecond);
}

bool is_hot(const World& world) {
  return std::ranges::any_of(world.ids(), [&](BodyId id) {
    const Body& body = world.body(id);
    return body.mesh.columns().any_set(body.heat.energy);
  });
}

}  // namespace kerf
