#include "core/document/scene_text.h"
#include "core/game/angle.h"
#include "core/game/arena/arena.h"
#include "core/game/json_fields.h"

namespace kerf {

namespace {

Status parse_heading(JsonFields& fields, double& radians) {
  double degrees = 0;
  fields.number("heading", degrees, {-360, 360});
  radians = radians_of(degrees);
  return fields.status();
}

Status parse_start(const JsonValue& value, Start& start) {
  JsonFields fields(value);
  fields.vector("position", start.position, true);
  return parse_heading(fields, start.heading);
}

Status parse_pose(const JsonValue& value, Placement& placement) {
  JsonFields fields(value);
  fields.vector("position", placement.position);
  fields.member("orientation", [&](const JsonValue& member) -> Status {
    const auto turn = member.orientation();
    if (!turn) return turn.error();
    placement.orientation = *turn;
    return Done{};
  });
  if (!value.has("heading")) return fields.status();
  double heading = 0;
  const Status parsed = parse_heading(fields, heading);
  placement.orientation = turn_about({0, 1, 0}, heading);
  return parsed;
}

Status parse_body(const JsonValue& value, const std::filesystem::path& folder, ArenaBody& arena_body) {
  auto body = parse_scene_body(value, folder);
  if (!body) return body.error();
  arena_body.body = std::move(*body);
  Placement& placement = arena_body.body.placement;
  JsonFields fields(value);
  fields.flag("cuttable", arena_body.cuttable);
  fields.member("pose", [&](const JsonValue& pose) { return parse_pose(pose, placement); });
  if (fields.status() && value.has("heading")) return parse_pose(value, placement);
  return fields.status();
}

Status parse_size(const JsonValue& value, Vec2& size) {
  const bool two = value.json().is_array() && value.json().size() == 2;
  if (!two) return value.wrong("must be two numbers");
  for (int i = 0; i < 2; ++i) {
    const auto n = value[static_cast<size_t>(i)].positive_number();
    if (!n) return n.error();
    if (*n < 10 || *n > 10'000) return value.wrong("must be from 10 to 10000 m");
    size[i] = *n;
  }
  return Done{};
}

Status parse_starts(const JsonValue& value, ArenaDescription& arena) {
  JsonFields fields(value);
  fields.member(
      "player", [&](const JsonValue& v) { return parse_start(v, arena.player); }, true);
  fields.list(
      "enemies", "starts", [&](const JsonValue& v) { return parse_start(v, arena.enemies.emplace_back()); },
      true);
  if (fields.status() && arena.enemies.empty()) return value["enemies"].wrong("must hold one start or more");
  return fields.status();
}

// Starts are within the arena.
Status check_starts(const JsonValue& root, const ArenaDescription& arena) {
  std::vector<Start> all = arena.enemies;
  all.push_back(arena.player);
  for (const Start& start : all) {
    const Vec3 p = glm::abs(start.position);
    if (2 * p.x > arena.size.x || 2 * p.z > arena.size.y)
      return root["starts"].wrong("a start is outside the \"size\" of the arena");
  }
  return Done{};
}

}  // namespace

Result<ArenaDescription> read_arena(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file.string());
  if (!json) return json.error();
  const JsonValue root(*json, file.string());
  ArenaDescription arena;
  arena.name = file.stem().string();
  JsonFields fields(root);
  fields.text("name", arena.name).number("ground", arena.ground, {-1000, 1000});
  fields.member("size", [&](const JsonValue& v) { return parse_size(v, arena.size); });
  fields.list("bodies", "bodies", [&](const JsonValue& v) {
    return parse_body(v, file.parent_path(), arena.bodies.emplace_back());
  });
  fields.member("lamps", [&](const JsonValue& v) -> Status {
    auto lamps = parse_lights(v);
    if (!lamps) return lamps.error();
    arena.lamps = std::move(*lamps);
    return Done{};
  });
  fields.member("paints", [&](const JsonValue& v) -> Status {
    auto paints = parse_paints(v);
    if (!paints) return paints.error();
    arena.paints = std::move(*paints);
    return Done{};
  });
  fields.member(
      "starts", [&](const JsonValue& v) { return parse_starts(v, arena); }, true);
  if (!fields.status()) return fields.status().error();
  if (const Status inside = check_starts(root, arena); !inside) return inside.error();
  return arena;
}

}  // namespace kerf
