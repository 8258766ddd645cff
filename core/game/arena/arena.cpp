#include "core/game/arena/arena.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/mesh/measures.h"
#include "core/world/body_creation.h"

namespace kerf {

namespace {

std::optional<SightHit> on_ground(const World& world, const Pose& ray, double length) {
  const Environment& around = world.environment();
  if (!around.ground) return std::nullopt;
  const Vec3 up = around.up();
  const double height = glm::dot(ray.origin, up) - *around.ground, sinking = -glm::dot(ray.direction, up);
  if (!(sinking > 0) || height < 0 || height > length * sinking) return std::nullopt;
  return SightHit{BodyId{}, height / sinking, up};
}

// In the world, against the ray.
Vec3 normal_of(const Body& body, FaceId face, const Pose& ray) {
  const Triangle t = body.mesh.triangle(face);
  const Vec3 n = body.placement.orientation * glm::cross(t[1] - t[0], t[2] - t[0]);
  const double size = glm::length(n);
  if (!(size > 0)) return -ray.direction;
  return (glm::dot(n, ray.direction) > 0 ? -1 / size : 1 / size) * n;
}

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
  if (glm::min(size.x, size.y) < 10 || glm::max(size.x, size.y) > 1000)
    return value.wrong("must be from 10 to 1000 m");
  return Done{};
}

bool is_inside(const Start& start, const Vec2& size) {
  const Vec3 p = glm::abs(start.position);
  return 2 * p.x <= size.x && 2 * p.z <= size.y;
}

constexpr double kBump = 0.25;  // m, height over which a vehicle drives
constexpr double kRoof = 2.2;   // m, the height of a vehicle
constexpr double kHigh = 1;     // m, height above the ground from which an upper floor is not mistaken for it
constexpr double kBelow = 0.6;  // m, by which a place on a floor may lie below it
constexpr double kStep = 0.3;   // m, maximum difference in height of neighbouring spots
constexpr double kMargin = 3;   // m, at the edge of the arena
constexpr double kSampling = 0.25;   // m, between points of faces
constexpr double kFloorless = 0.02;  // m, above the ground: lower faces are painted on it

bool is_over(const Triangle& t, const Vec2& half) {
  const Vec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  return high.x > -half.x && low.x < half.x && high.z > -half.y && low.z < half.y;
}

// Calls visit(point) for closely spaced points of a triangle. Of a very large one, takes the parts over the
// arena.
template <typename Visit>
void sample(const Triangle& t, const Vec2& half, Visit visit) {
  constexpr double kLarge = 1000;  // m
  const double longest =
      std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
  if (longest > kLarge) {
    const Vec3 a = 0.5 * (t[0] + t[1]), b = 0.5 * (t[1] + t[2]), c = 0.5 * (t[2] + t[0]);
    for (const Triangle& part : {Triangle{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}}) {
      if (is_over(part, half)) sample(part, half, visit);
    }
    return;
  }
  const int n = 1 + static_cast<int>(longest / kSampling);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j)
      visit(t[0] + (static_cast<double>(i) / n) * (t[1] - t[0]) +
            (static_cast<double>(j) / n) * (t[2] - t[0]));
  }
}

}  // namespace

bool passes_near(const Pose& ray, double length, const Vec3& centre, double radius, double reach) {
  KERF_ASSERT(length >= 0 && radius >= 0);
  const Vec3 way = centre - ray.origin;
  const double along = std::clamp(glm::dot(way, ray.direction), 0.0, length);
  const Vec3 beside = way - along * ray.direction;
  return glm::dot(beside, beside) <= (radius + reach) * (radius + reach);
}

Sight::Sight(const World& world) : world_(world) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden || body.tree.leaf_count() == 0) continue;
    const Bounds box = body.bounds();
    bodies_.push_back({id, &body, body.placement.to_world(0.5 * (box.min + box.max)),
                       0.5 * glm::length(box.max - box.min)});
  }
}

std::optional<SightHit> Sight::nearest(const Pose& ray, double length, const Stops& stops) const {
  KERF_ASSERT(is_unit(ray.direction) && length >= 0);
  std::optional<SightHit> first = on_ground(world_, ray, length);
  for (const Near& near : bodies_) {
    const double within = first ? first->length : length;
    if (!passes_near(ray, within, near.centre, near.radius) || !stops(near.id)) continue;
    const Body& body = *near.body;
    const auto hit = body.tree.nearest(body.mesh, body.placement.to_body(ray), {0, within});
    if (hit) first = SightHit{near.id, hit->length, normal_of(body, hit->face, ray)};
  }
  return first;
}

Status add_joints(std::span<const JointDescription> joints, ModelBody& model) {
  for (const JointDescription& joint : joints) {
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
    starts.check(!arena.enemies.empty(), "enemies", "must contain at least one start");
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
  std::map<std::pair<std::filesystem::path, FileUnit>, Body> loaded;
  ProgressShares shares(progress);
  const double share = 1 / static_cast<double>(std::max<size_t>(arena.description.bodies.size(), 1));
  for (const ArenaBody& described : arena.description.bodies) {
    const Progress loading = shares.next(share);
    const std::filesystem::path mesh = described.body.mesh.lexically_normal();
    const auto key = std::pair(mesh, described.body.unit);
    if (!loaded.contains(key)) {
      auto body = load_body(described.body.name, mesh, &loading, described.body.unit);
      if (!body) return body.error();
      loaded.emplace(key, std::move(*body));
    }
    ModelBody& model = arena.bodies.emplace_back();
    model.body = loaded.at(key);
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

std::vector<Triangle> fixed_faces(const Arena& arena) {
  std::vector<Triangle> faces;
  for (const ModelBody& model : arena.bodies) {
    if (!model.body.pinned) continue;
    const Mesh& mesh = model.body.mesh;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      Triangle t = mesh.triangle(FaceId(f));
      for (int corner = 0; corner < 3; ++corner) t[corner] = model.body.placement.to_world(t[corner]);
      faces.push_back(t);
    }
  }
  return faces;
}

bool is_drivable(const Triangle& t) {
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  return std::abs(normal.y) > kDrivable * glm::length(normal);
}

FreeSpace::FreeSpace(const Arena& arena)
    : ground_(arena.description.ground), half_(0.5 * arena.description.size) {
  columns_ = static_cast<int>(arena.description.size.x / kCell) + 1;
  rows_ = static_cast<int>(arena.description.size.y / kCell) + 1;
  std::vector<Triangle> faces = fixed_faces(arena);
  std::erase_if(faces, [&](const Triangle& t) { return !is_over(t, half_); });
  find_upper_floor(faces);
  std::vector<bool> blocked(spots(), false);
  find_blocked(faces, blocked);
  measure(blocked);
  forget_unreachable(arena.description.player.position);
}

int FreeSpace::column(double x) const {
  return std::clamp(static_cast<int>((x + half_.x) / kCell), 0, columns_ - 1);
}

int FreeSpace::row(double z) const {
  return std::clamp(static_cast<int>((z + half_.y) / kCell), 0, rows_ - 1);
}

void FreeSpace::find_upper_floor(const std::vector<Triangle>& faces) {
  heights_.assign(cells(), ground_);
  for (const Triangle& t : faces) {
    if (!is_drivable(t)) continue;
    sample(t, half_, [&](const Vec3& p) {
      if (p.y > ground_ + kHighest || p.y < ground_ + kFloorless) return;
      double& height = heights_[spot_of(column(p.x), row(p.z), false)];
      height = std::max(height, p.y);
    });
  }
}

void FreeSpace::find_blocked(const std::vector<Triangle>& faces, std::vector<bool>& blocked) const {
  KERF_ASSERT(blocked.size() == spots() && heights_.size() == cells());
  for (const Triangle& t : faces) {
    sample(t, half_, [&](const Vec3& p) {
      if (std::abs(p.x) > half_.x || std::abs(p.z) > half_.y) return;
      const Spot lower = spot_of(column(p.x), row(p.z), false), upper = lower + cells();
      const auto in_the_way = [&](double floor) { return p.y > floor + kBump && p.y < floor + kRoof; };
      if (in_the_way(ground_)) blocked[lower] = true;
      if (in_the_way(heights_[lower])) blocked[upper] = true;
    });
  }
  for (Spot spot = 0; spot < spots(); ++spot) {
    const Vec3 p = glm::abs(place_of(spot));
    const bool at_edge = p.x > half_.x - kMargin || p.z > half_.y - kMargin;
    if (at_edge || !has_floor(spot) || is_parapet(spot)) blocked[spot] = true;
  }
}

// Returns true if a spot of the upper floor is the top of something that stands on the floor next to it.
bool FreeSpace::is_parapet(Spot spot) const {
  if (spot < cells()) return false;
  const int x = static_cast<int>(spot - cells()) % columns_, z = static_cast<int>(spot - cells()) / columns_;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (!is_inside(x + dx, z + dz)) continue;
      const Spot next = spot_of(x + dx, z + dz, true);
      const double over = heights_[spot - cells()] - heights_[next - cells()];
      if (has_floor(next) && over > kStep && over < kRoof) return true;
    }
  }
  return false;
}

bool FreeSpace::has_floor(Spot spot) const { return spot < cells() || heights_[spot - cells()] > ground_; }

// Returns true if the upper floor ends here, at a height.
bool FreeSpace::is_at_drop(int x, int z) const {
  if (has_floor(spot_of(x, z, true))) return false;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (is_inside(x + dx, z + dz) && heights_[spot_of(x + dx, z + dz, false)] > ground_ + kStep)
        return true;
    }
  }
  return false;
}

void FreeSpace::measure(const std::vector<bool>& blocked) {
  KERF_ASSERT(blocked.size() == spots());
  clearance_.assign(spots(), static_cast<float>(kFar));
  constexpr int kReach = static_cast<int>(kFar / kCell) + 1;
  for (Spot spot = 0; spot < spots(); ++spot) {
    if (!blocked[spot]) continue;
    clearance_[spot] = 0;
    const bool upper = spot >= cells();
    const int x = static_cast<int>(spot % cells()) % columns_,
              z = static_cast<int>(spot % cells()) / columns_;
    if (upper && !has_floor(spot) && !is_at_drop(x, z)) continue;
    for (int dz = -kReach; dz <= kReach; ++dz) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        if (!is_inside(x + dx, z + dz)) continue;
        float& near = clearance_[spot_of(x + dx, z + dz, upper)];
        near = std::min(near, static_cast<float>(kCell * std::sqrt(static_cast<double>(dx * dx + dz * dz))));
      }
    }
  }
}

void FreeSpace::forget_unreachable(const Vec3& start) {
  const Spot first = with_room_near(start, kFar);
  if (first == spots()) return;
  std::vector<bool> reached(spots(), false);
  std::vector<Spot> open{first};
  while (!open.empty()) {
    const Spot spot = open.back();
    open.pop_back();
    if (spot == spots() || reached[spot]) continue;
    reached[spot] = true;
    for_each_beside(spot, [&](Spot beside, double) {
      if (has_room(beside)) open.push_back(beside);
    });
  }
  for (Spot spot = 0; spot < spots(); ++spot) {
    if (has_room(spot) && !reached[spot]) clearance_[spot] = 0;
  }
}

bool FreeSpace::is_step(Spot from, Spot to) const {
  return has_floor(from) && has_floor(to) && std::abs(place_of(from).y - place_of(to).y) < kStep;
}

FreeSpace::Spot FreeSpace::spot_at(const Vec3& p) const {
  KERF_ASSERT(spots() > 0);
  const Spot lower = spot_of(column(p.x), row(p.z), false);
  const double height = heights_[lower];
  const bool roomier = clearance_[lower + cells()] > clearance_[lower] || height > ground_ + kHigh;
  const bool on_upper = has_floor(lower + cells()) && roomier && p.y > height - kBelow;
  return on_upper ? lower + cells() : lower;
}

Vec3 FreeSpace::place_of(Spot spot) const {
  KERF_ASSERT(spot < spots());
  const uint32_t cell = spot % cells();
  const double x = (static_cast<int>(cell) % columns_ + 0.5) * kCell - half_.x;
  const double z = (static_cast<int>(cell) / columns_ + 0.5) * kCell - half_.y;
  return {x, spot >= cells() ? heights_[cell] : ground_, z};
}

FreeSpace::Spot FreeSpace::with_room_near(const Vec3& p, double reach) const {
  KERF_ASSERT(spots() > 0 && reach >= 0);
  Spot best = spots();
  double nearest = reach;
  const int most = static_cast<int>(reach / kCell) + 1, x = column(p.x), z = row(p.z);
  for (int dz = -most; dz <= most; ++dz) {
    for (int dx = -most; dx <= most; ++dx) {
      if (!is_inside(x + dx, z + dz)) continue;
      for (const bool upper : {false, true}) {
        const Spot spot = spot_of(x + dx, z + dz, upper);
        const double distance = glm::distance(place_of(spot), p);
        if (!has_room(spot) || distance > nearest || (distance == nearest && best != spots())) continue;
        nearest = distance;
        best = spot;
      }
    }
  }
  return best;
}

Obstacles::Obstacles(const Arena& arena) : half_(0.5 * arena.description.size) {
  columns_ = column(half_.x) + 1;
  rows_ = row(half_.y) + 1;
  in_cell_.resize(static_cast<size_t>(columns_ * rows_));
  for (const Triangle& t : fixed_faces(arena)) {
    if (is_drivable(t)) continue;
    const Vec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
    if (high.x < -half_.x || low.x > half_.x || high.z < -half_.y || low.z > half_.y) continue;
    const auto index = static_cast<uint32_t>(faces_.size());
    faces_.push_back(t);
    const Cells cells = cells_between(low, high);
    for (int z = cells.low; z <= cells.high; ++z) {
      for (int x = cells.left; x <= cells.right; ++x)
        in_cell_[static_cast<size_t>(z * columns_ + x)].push_back(index);
    }
  }
}

Obstacles::Cells Obstacles::cells_between(const Vec3& low, const Vec3& high) const {
  const auto within = [](double at, double half) { return std::clamp(at, -half, half); };
  return {column(within(low.x, half_.x)), column(within(high.x, half_.x)), row(within(low.z, half_.y)),
          row(within(high.z, half_.y))};
}

std::optional<Obstacles::Touch> Obstacles::touched_by(const Vec3& centre, double radius) const {
  KERF_ASSERT(radius > 0);
  std::optional<Touch> deepest;
  if (faces_.empty()) return deepest;
  const Cells cells = cells_between(centre - Vec3(radius), centre + Vec3(radius));
  for (int z = cells.low; z <= cells.high; ++z) {
    for (int x = cells.left; x <= cells.right; ++x) {
      for (const uint32_t face : in_cell_[static_cast<size_t>(z * columns_ + x)]) {
        const Vec3 at = nearest_point(centre, faces_[face]), way = centre - at;
        const double distance = glm::length(way);
        if (distance >= (deepest ? deepest->distance : radius) || !(distance > 0)) continue;
        if (way.y <= kDrivable * distance) deepest = Touch{at, distance};
      }
    }
  }
  return deepest;
}

}  // namespace kerf
