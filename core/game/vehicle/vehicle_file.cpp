#include "core/game/vehicle/vehicle_file.h"

#include <array>

#include "core/document/files/scene_text.h"
#include "core/document/text/fields.h"

namespace kerf {

static void describe(Fields& f, WheelDescription& wheel) {
  f.filled_text("part", wheel.part);
  f.filled_text("mount", wheel.mount);
  f.vector("hub", wheel.hub, VectorRule::kNearby);
  f.number("radius", wheel.radius, {0.01, 10, "m"});
  f.flag("steers", wheel.steers, kOptional);
  f.flag("driven", wheel.driven, kOptional);
  f.member("suspension", kOptional, [&](Fields& of) {
    of.number("travel", wheel.travel, {0.01, 2, "m"}, kOptional);
  });
}

static void describe(Fields& f, BarrelDescription& barrel) {
  f.filled_text("part", barrel.part);
  f.vector("pivot", barrel.pivot, VectorRule::kNearby);
  f.vector("muzzle", barrel.muzzle, VectorRule::kNearby);
  f.check(barrel.pivot != barrel.muzzle, "muzzle", "must be another point than \"pivot\"");
  f.angles("pitch", barrel.pitch, {-89, 89}, kOptional);
}

static void describe(Fields& f, TurretDescription& turret) {
  f.filled_text("part", turret.part);
  f.filled_text("mount", turret.mount);
  f.vector("pivot", turret.pivot, VectorRule::kNearby);
  f.angles("yaw", turret.yaw, {-180, 180}, kOptional);
  f.object("barrel", turret.barrel);
}

static void describe(Fields& f, VitalDescription& vital) {
  constexpr std::array kKindsOfVitals{"engine", "driver"};
  f.choice("kind", vital.kind, kKindsOfVitals);
  f.filled_text("part", vital.part);
  f.filled_text("mount", vital.mount, kOptional);
}

static void describe(Fields& f, EngineDescription& engine) {
  f.number("force", engine.force, {1, 1e7, "N"}, kOptional);
  f.number("power", engine.power, {1, 1e9, "W"}, kOptional);
  f.number("top_speed", engine.top_speed, {0.1, 100, "m/s"}, kOptional);
}

static void describe(Fields& f, VehicleDescription& vehicle) {
  describe(f, vehicle.body);
  f.by_name("paints", vehicle.paints);
  f.filled_text("name", vehicle.name, kOptional);
  f.number("mass", vehicle.mass, {1, 1e6, "kg"}, kOptional);
  f.list("wheels", "wheels", vehicle.wheels);
  f.check(!vehicle.wheels.empty() && vehicle.wheels.size() <= 12, "wheels", "must hold 1 to 12 wheels");
  f.object("turret", vehicle.turret);
  f.list("vital", "parts", vehicle.vitals, kOptional);
  const bool may_lack_vitals = !f.present("vital", false);
  f.check(vehicle.vitals.size() <= 8, "vital", "must hold no more than 8 parts");
  f.check(may_lack_vitals || !vehicle.vitals.empty(), "vital",
          "must hold one part or more; without the key a vehicle is out when little of it is left");
  f.vector("driver_eye", vehicle.driver_eye, VectorRule::kNearby, kOptional);
  f.object("engine", vehicle.engine, kOptional);
}

Result<VehicleDescription> read_vehicle(const std::filesystem::path& file) {
  VehicleDescription vehicle;
  vehicle.name = file.stem().string();
  return read_described(file, std::move(vehicle));
}

}  // namespace kerf
