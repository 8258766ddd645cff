#include "core/game/vehicle/vehicle_file.h"

#include "core/document/scene_joint_text.h"
#include "core/document/scene_text.h"
#include "core/game/json_fields.h"

namespace kerf {

namespace {

Status parse_wheel(const JsonValue& value, WheelDescription& wheel) {
  JsonFields fields(value);
  fields.text("part", wheel.part, true).text("mount", wheel.mount, true).vector("hub", wheel.hub, true);
  fields.number("radius", wheel.radius, {0.01, 10}, true).flag("steers", wheel.steers);
  fields.flag("driven", wheel.driven);
  fields.member("suspension", [&](const JsonValue& suspension) {
    return JsonFields(suspension).number("travel", wheel.travel, {0.01, 2}).status();
  });
  return fields.status();
}

Status parse_barrel(const JsonValue& value, BarrelDescription& barrel) {
  JsonFields fields(value);
  fields.text("part", barrel.part, true).vector("pivot", barrel.pivot, true);
  fields.vector("muzzle", barrel.muzzle, true).angles("pitch", barrel.pitch, {-89, 89});
  if (fields.status() && barrel.pivot == barrel.muzzle)
    return value["muzzle"].wrong("must be another point than \"pivot\"");
  return fields.status();
}

Status parse_turret(const JsonValue& value, TurretDescription& turret) {
  JsonFields fields(value);
  fields.text("part", turret.part, true).text("mount", turret.mount, true);
  fields.vector("pivot", turret.pivot, true).angles("yaw", turret.yaw, {-180, 180});
  fields.member(
      "barrel", [&](const JsonValue& barrel) { return parse_barrel(barrel, turret.barrel); }, true);
  return fields.status();
}

Status parse_vital(const JsonValue& value, VitalDescription& vital) {
  std::string kind;
  JsonFields fields(value);
  fields.text("kind", kind, true).text("part", vital.part, true).text("mount", vital.mount);
  if (!fields.status()) return fields.status();
  if (kind != "engine" && kind != "driver") return value["kind"].wrong("must be \"engine\" or \"driver\"");
  vital.kind = kind == "engine" ? VitalDescription::Kind::kEngine : VitalDescription::Kind::kDriver;
  return Done{};
}

Status parse_engine(const JsonValue& value, EngineDescription& engine) {
  return JsonFields(value)
      .number("force", engine.force, {1, 1e7})
      .number("power", engine.power, {1, 1e9})
      .number("top_speed", engine.top_speed, {0.1, 100})
      .status();
}

template <typename T>
Status append(const JsonValue& value, std::vector<T>& list, Status (*parse)(const JsonValue&, T&)) {
  return parse(value, list.emplace_back());
}

// What a vehicle has in common with a scene: its mesh, its sheet, its joints and its paints.
Status parse_as_scene(const JsonValue& root, const std::filesystem::path& folder,
                      VehicleDescription& vehicle) {
  auto body = parse_scene_body(root, folder);
  if (!body) return body.error();
  vehicle.body = std::move(*body);
  if (!root.has("paints")) return Done{};
  auto paints = parse_paints(root["paints"]);
  if (!paints) return paints.error();
  vehicle.paints = std::move(*paints);
  return Done{};
}

}  // namespace

Result<VehicleDescription> read_vehicle(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file.string());
  if (!json) return json.error();
  const JsonValue root(*json, file.string());
  VehicleDescription vehicle;
  vehicle.name = file.stem().string();
  if (const Status scene = parse_as_scene(root, file.parent_path(), vehicle); !scene) return scene.error();
  JsonFields fields(root);
  fields.text("name", vehicle.name).number("mass", vehicle.mass, {1, 1e6});
  fields.list(
      "wheels", "wheels", [&](const JsonValue& v) { return append(v, vehicle.wheels, parse_wheel); }, true);
  fields.member(
      "turret", [&](const JsonValue& v) { return parse_turret(v, vehicle.turret); }, true);
  fields.list("vital", "parts", [&](const JsonValue& v) { return append(v, vehicle.vitals, parse_vital); });
  fields.vector("driver_eye", vehicle.driver_eye);
  fields.member("engine", [&](const JsonValue& v) { return parse_engine(v, vehicle.engine); });
  if (!fields.status()) return fields.status().error();
  if (vehicle.wheels.empty() || vehicle.wheels.size() > 12)
    return root["wheels"].wrong("must hold 1 to 12 wheels");
  if (vehicle.vitals.size() > 8) return root["vital"].wrong("must hold no more than 8 parts");
  return vehicle;
}

}  // namespace kerf
