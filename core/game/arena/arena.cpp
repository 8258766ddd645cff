#include "core/game/arena/arena.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/deterministic_math.h"
#include "core/document/scene_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/world/body_creation.h"

namespace kerf {

Status add_joints(std::span<const SceneJoint> joints, ModelBody& model) {
  for (const SceneJoint& joint : joints) {
    auto made = make_joint(joint, BodyId{}, model.body);
    if (!made) return made.error();
    model.joints.push_back(std::move(*made));
  }
  return Done{};
}

BodyId add_body(World& world, const ModelBody& model, uint32_t generation) {
  const BodyId id = world.add(model.body, generation);
  if (model.joints.empty()) return id;
  Joints joints = world.joints();
  for (const Joint& joint : model.joints) joints.all.emplace_back(joint).body = id;
  world.set_joints(std::move(joints));
  return id;
}

namespace {

constexpr NumberRange kHeadings{-360, 360, "degrees"};

// A heading overrides an orientation.
void pose_fields(Fields& f, Placement& placement) {
  f.vector("position", placement.position, VectorRule::kNearby, kOptional);
  f.orientation("orientation", placement.orientation, kOptional);
  double heading = 0;
  if (!f.present("heading", false)) return;
  f.angle("heading", heading, kHeadings, kOptional);
  placement.orientation = axis_angle({0, 1, 0}, heading);
}

Status read_size(const JsonValue& value, Vec2& size) {
  const auto two = value.pair();
  if (!two) return two.error();
  size = {two->low, two->high};
  if (glm::min(size.x, size.y) < 10 || glm::max(size.x, size.y) > 10'000)
    return value.wrong("must be from 10 to 10000 m");
  return Done{};
}

bool is_inside(const Start& start, const Vec2& size) {
  const Vec3 p = glm::abs(start.position);
  return 2 * p.x <= size.x && 2 * p.z <= size.y;
}

}  // namespace

static void describe(Fields& f, Start& start) {
  f.vector("position", start.position, VectorRule::kNearby);
  f.angle("heading", start.heading, kHeadings, kOptional);
}

static void describe(Fields& f, ArenaBody& body) {
  describe(f, body.body);
  f.flag("cuttable", body.cuttable, kOptional);
  f.member("pose", kOptional, [&](Fields& pose) { pose_fields(pose, body.body.placement); });
  if (f.present("heading", false)) pose_fields(f, body.body.placement);
}

static void describe(Fields& f, ArenaDescription& arena) {
  f.filled_text("name", arena.name, kOptional);
  f.number("ground", arena.ground, {-1000, 1000, "m"}, kOptional);
  f.value(
      "size", [&](const JsonValue& value) { return read_size(value, arena.size); }, nullptr, kOptional);
  f.list("bodies", "bodies", arena.bodies, kOptional);
  lights_field(f, "lamps", arena.lamps);
  f.by_name("paints", arena.paints);
  f.member("starts", kNeeded, [&](Fields& starts) {
    starts.object("player", arena.player);
    starts.list("enemies", "starts", arena.enemies);
    starts.check(!arena.enemies.empty(), "enemies", "must hold one start or more");
  });
  const auto inside = [&](const Start& start) { return is_inside(start, arena.size); };
  f.check(inside(arena.player) && std::all_of(arena.enemies.begin(), arena.enemies.end(), inside), "starts",
          "a start is outside the \"size\" of the arena");
}

Result<ArenaDescription> read_arena(const std::filesystem::path& file) {
  ArenaDescription arena;
  arena.name = file.stem().string();
  return read_described(file, std::move(arena));
}

Placement Start::placement() const { return {position, axis_angle({0, 1, 0}, heading)}; }

Result<Arena> load_arena(ArenaDescription description, const Progress* progress) {
  Arena arena{std::move(description), {}};
  std::map<std::filesystem::path, Body> loaded;
  ProgressShares shares(progress);
  const double share = 1 / static_cast<double>(std::max<size_t>(arena.description.bodies.size(), 1));
  for (const ArenaBody& described : arena.description.bodies) {
    const Progress loading = shares.next(share);
    const std::filesystem::path mesh = described.body.mesh.lexically_normal();
    if (!loaded.contains(mesh)) {
      auto body = load_body(described.body.name, mesh, &loading);
      if (!body) return body.error();
      loaded.emplace(mesh, std::move(*body));
    }
    ModelBody& model = arena.bodies.emplace_back();
    model.body = loaded.at(mesh);
    model.body.name = described.body.name;
    model.body.placement = described.body.placement;
    model.body.sheet = described.body.sheet;
    model.body.pinned = !described.cuttable;
    model.body.motion.asleep = described.cuttable;
    if (const Status joined = add_joints(described.body.joints, model); !joined)
      return bad_input(mesh.string() + ": " + joined.error().message);
  }
  return arena;
}

}  // namespace kerf
