#include "tests/support/game_files.h"

#include <cstdio>
#include <cstdlib>

#include "core/cut/cut_step.h"
#include "core/game/vehicle/vehicle.h"
#include "core/game/vehicle/vehicle_model.h"
#include "core/physics/physics.h"
#include "tests/support/checkout.h"

namespace kerf::test {

namespace {

template <typename T>
T loaded(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::abort();
}

}  // namespace

std::shared_ptr<const VehicleModel> hatchback() {
  static const std::shared_ptr<const VehicleModel> model =
      loaded(load_vehicle(loaded(read_vehicle(checkout() / "assets/vehicles/hatchback.json"))));
  return model;
}

std::shared_ptr<const Rules> flat_rules(size_t waves, size_t enemies) {
  auto rules = std::make_shared<Rules>();
  rules->player = hatchback();
  rules->waves.assign(waves, std::vector(enemies, hatchback()));
  ArenaDescription& arena = rules->arena.description;
  arena.size = {200, 200};
  arena.enemies = {{{0, 0, 25}, 3.14}, {{12, 0, 25}, 3.14}};
  return rules;
}

LoneVehicle::LoneVehicle() {
  Environment around;
  around.ground = 0;
  world.set_environment(around);
  Delta created;
  vehicle = add_vehicle(world, hatchback(), Placement{}, 0, created);
}

void LoneVehicle::cut(const Pose& from, const Pose& to, double radius, double range) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, range};
  settings.resolution.rule = Resolution::Rule::kTolerance;
  settings.resolution.tolerance = 0.01;
  const BeamMove move{from, to, 0};
  for (const BodyId id : world.ids()) {
    if (!cut_without_separation(world, settings, id, {&move, 1})) std::abort();
  }
  while (!is_settled(world)) continue_separation(world, 100'000);
  continue_separation(world, 1);
  Delta released;
  release_pieces(world, 0, released);
}

}  // namespace kerf::test
