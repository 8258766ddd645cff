#include "core/game/vehicle/vehicle_model.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/document/text/fields.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

uint32_t part_of_group(const std::string& group, const std::vector<std::string>& parts) {
  auto best = static_cast<uint32_t>(parts.size());
  for (uint32_t p = 0; p < parts.size(); ++p) {
    const bool longer = best == parts.size() || parts[p].size() > parts[best].size();
    if (longer && is_of_part(group, parts[p])) best = p;
  }
  return best;
}

// Returns true if all corners of the triangle lie in the ball.
bool is_inside(const Triangle& t, const Ball& ball) {
  return std::all_of(t.begin(), t.end(),
                     [&](const Vec3& p) { return glm::distance(p, ball.centre) <= ball.radius; });
}

std::vector<bool> faces_of_part(const Body& loaded, const std::string& part) {
  std::vector<bool> of(loaded.mesh.face_slots(), false);
  for (const MeshPart& group : loaded.named_parts) {
    if (!is_of_part(group.name, part)) continue;
    for (uint32_t f = group.first; f < group.last; ++f) of[f] = true;
  }
  return of;
}

// The centre of the bounds of a part. Precondition: it has faces.
Vec3 centre_of(const Body& body, const std::string& part) {
  Vec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const MeshPart& group : body.named_parts) {
    if (!is_of_part(group.name, part)) continue;
    for (uint32_t f = group.first; f < group.last; ++f) {
      for (const Vec3& corner : body.mesh.triangle(FaceId(f))) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
    }
  }
  return 0.5 * low + 0.5 * high;
}

class ModelLoader {
 public:
  ModelLoader(VehicleDescription description, const Progress* progress)
      : model_(std::make_shared<VehicleModel>()), progress_(progress) {
    model_->description = std::move(description);
  }

  Result<std::shared_ptr<const VehicleModel>> load() {
    const auto soup = read_mesh(what().body.mesh, progress_, what().body.unit);
    if (!soup) return soup.error();
    if (const Status split = split_up(*soup); !split) return split.error();
    if (const Status joined = share_out_joints(); !joined) return joined.error();
    if (const Status watched = watch_parts(); !watched) return watched.error();
    set_weight();
    return std::shared_ptr<const VehicleModel>(std::move(model_));
  }

 private:
  const VehicleDescription& what() const { return model_->description; }
  Error wrong(const std::string& text) const {
    return bad_input(what().body.mesh.string() + ": " + text + " (vehicle \"" + what().name + "\")");
  }

  // Builds the bodies of the parts that are not of the chassis, in the order of `bodies_`.
  Status split_up(const Soup& soup) {
    std::vector<std::string> names;
    for (const WheelDescription& wheel : what().wheels) names.push_back(wheel.part);
    names.push_back(what().turret.part);
    names.push_back(what().turret.barrel.part);
    const std::vector<uint32_t> part = part_of_triangles(soup, names);
    model_->wheels.resize(what().wheels.size());
    bodies_.clear();
    for (VehicleBody& wheel : model_->wheels) bodies_.push_back(&wheel);
    for (VehicleBody* body : {&model_->turret, &model_->barrel, &model_->chassis}) bodies_.push_back(body);
    names.push_back("chassis");
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
      auto built = build_mesh(extract_part(soup, part, i));
      if (!built) return wrong("no faces of the part \"" + names[i] + "\"");
      bodies_[i]->body = make_body(what().name + " " + names[i], std::move(*built));
      bodies_[i]->body.sheet = what().body.sheet;
    }
    return Done{};
  }

  // Assigns each joint to the body that has both of its parts. Skips those between two bodies: the rules of
  // damage hold the parts that the chassis carries.
  Status share_out_joints() {
    for (const JointDescription& joint : what().body.joints) {
      if (joint.parts[0].empty() || joint.parts[1].empty())
        return wrong("a joint of a vehicle needs \"parts\", two names");
      for (const std::string& part : joint.parts) {
        const auto has_part = [&](const VehicleBody* body) { return has_group(body->body, part); };
        if (std::ranges::none_of(bodies_, has_part))
          return wrong("a joint names the part \"" + part + "\", which the mesh lacks");
      }
      for (VehicleBody* body : bodies_) {
        if (!has_group(body->body, joint.parts[0]) || !has_group(body->body, joint.parts[1])) continue;
        if (const Status added = add_joints({&joint, 1}, *body); !added) return wrong(added.error().message);
        if (body == &model_->chassis) model_->breaks.push_back(may_break(joint));
      }
    }
    return Done{};
  }

  bool may_break(const JointDescription& joint) const {
    const auto is_kept = [&](const std::string& group) {
      const auto is_vital = [&](const VitalDescription& v) { return is_of_part(group, v.part); };
      const auto is_mount = [&](const WheelDescription& w) { return is_of_part(group, w.mount); };
      return is_of_part(group, what().turret.mount) || std::ranges::any_of(what().vitals, is_vital) ||
             std::ranges::any_of(what().wheels, is_mount) ||
             (what().tank && is_of_part(group, what().tank->part));
    };
    const auto carries_vitals = [&](const std::string& group) {
      return std::ranges::any_of(what().vitals,
                                 [&](const VitalDescription& v) { return is_of_part(group, v.mount); });
    };
    const bool frame =
        joint.kind == Joint::Kind::kWeld && carries_vitals(joint.parts[0]) && carries_vitals(joint.parts[1]);
    return !frame && !is_kept(joint.parts[0]) && !is_kept(joint.parts[1]);
  }

  static bool has_group(const Body& body, const std::string& name) {
    for (const MeshPart& group : body.named_parts) {
      if (group.name == name) return true;
    }
    return false;
  }

  Status watch_parts() {
    for (VehicleBody* body : bodies_) body->watch = FaceWatch(body->body);
    for (size_t w = 0; w < model_->wheels.size(); ++w) {
      const WheelDescription& wheel = what().wheels[w];
      watch_carried(model_->wheels[w], wheel.part, wheel.hub);
      if (const Status s = watch_chassis(wheel.mount, &wheel.hub); !s) return s;
    }
    const TurretDescription& turret = what().turret;
    watch_carried(model_->turret, turret.part, turret.pivot);
    model_->turret.watch.add_part_near(model_->turret.body, turret.part, turret.barrel.pivot);
    watch_carried(model_->barrel, turret.barrel.part, turret.barrel.pivot);
    if (const Status s = watch_chassis(turret.mount, &turret.pivot); !s) return s;
    for (const VitalDescription& vital : what().vitals) {
      if (const Status s = watch_chassis(vital.part, nullptr); !s) return s;
      model_->vital_centres.push_back(centre_of(model_->chassis.body, vital.part));
    }
    if (!what().tank) return Done{};
    if (const Status s = watch_chassis(what().tank->part, nullptr); !s) return s;
    model_->tank_centre = centre_of(model_->chassis.body, what().tank->part);
    return Done{};
  }

  static void watch_carried(VehicleBody& body, const std::string& part, const Vec3& seat) {
    body.watch.add_part(body.body, part);
    body.watch.add_part_near(body.body, part, seat);
  }

  Status watch_chassis(const std::string& part, const Vec3* seat) {
    FaceWatch& watch = model_->chassis.watch;
    const Body& chassis = model_->chassis.body;
    const size_t group = seat ? watch.add_part_near(chassis, part, *seat) : watch.add_part(chassis, part);
    if (!(watch.area(group) > 0)) return wrong("the chassis has no faces of the part \"" + part + "\"");
    return Done{};
  }

  // The chassis has the mass of all parts that it carries.
  void set_weight() {
    Body& chassis = model_->chassis.body;
    KERF_ASSERT(chassis.loaded.area > 0);
    model_->chassis_area = chassis.loaded.area;
    chassis.sheet.density = what().mass / (chassis.loaded.area * chassis.sheet.thickness);
  }

  std::shared_ptr<VehicleModel> model_;
  const Progress* progress_;
  std::vector<VehicleBody*> bodies_;
};

}  // namespace

std::vector<uint32_t> part_of_triangles(const Soup& soup, const std::vector<std::string>& parts) {
  std::vector<uint32_t> of(soup.triangles.size(), static_cast<uint32_t>(parts.size()));
  for (const MeshPart& group : soup.parts) {
    const uint32_t part = part_of_group(group.name, parts);
    if (part == parts.size()) continue;
    for (uint32_t t = group.first; t < group.last; ++t) of[t] = part;
  }
  return of;
}

Soup extract_part(const Soup& soup, const std::vector<uint32_t>& part, uint32_t wanted) {
  KERF_ASSERT(part.size() == soup.triangles.size());
  Soup own;
  own.positions = soup.positions;
  own.material_names = soup.material_names;
  own.format = soup.format;
  std::vector<uint32_t> before(part.size() + 1, 0);  // triangles of the part before each one
  for (size_t t = 0; t < part.size(); ++t) {
    before[t + 1] = before[t] + (part[t] == wanted ? 1 : 0);
    if (part[t] != wanted) continue;
    own.triangles.push_back(soup.triangles[t]);
    if (!soup.materials.empty()) own.materials.push_back(soup.materials[t]);
  }
  for (const MeshPart& group : soup.parts) {
    const uint32_t first = before[group.first], last = before[group.last];
    if (first < last) own.parts.push_back({group.name, first, last});
  }
  own.faces_in_file = own.triangles_in_file = own.triangles.size();
  return own;
}

double area_within(const Triangle& t, const Ball& ball) {
  if (squared_distance(ball.centre, t) > ball.radius * ball.radius) return 0;
  if (is_inside(t, ball)) return triangle_area(t);
  size_t longest = 0;
  for (size_t i = 1; i < 3; ++i) {
    if (glm::distance(t[i], t[(i + 1) % 3]) > glm::distance(t[longest], t[(longest + 1) % 3])) longest = i;
  }
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  if (glm::distance(a, b) < 0.2 * ball.radius) return 0.5 * triangle_area(t);
  const Vec3 middle = 0.5 * (a + b);
  return area_within({a, middle, c}, ball) + area_within({middle, b, c}, ball);
}

double FaceWatch::area_in(size_t group, const Triangle& t) const {
  return near_[group] ? area_within(t, *near_[group]) : triangle_area(t);
}

size_t FaceWatch::add(const Body& loaded, const std::vector<bool>& faces, const std::optional<Ball>& near) {
  KERF_ASSERT(areas_.size() < kMaxGroups && groups_of_.size() == loaded.mesh.face_slots());
  KERF_ASSERT(faces.size() == groups_of_.size() && (!near || near->radius > 0));
  const size_t group = areas_.size();
  near_.push_back(near);
  double area = 0;
  for (uint32_t f = 0; f < faces.size(); ++f) {
    const double own = faces[f] ? area_in(group, loaded.mesh.triangle(FaceId(f))) : 0;
    if (own > 0) groups_of_[f] |= uint32_t{1} << group;
    area += own;
  }
  areas_.push_back(area);
  return group;
}

size_t FaceWatch::add_part(const Body& loaded, const std::string& part) {
  return add(loaded, faces_of_part(loaded, part), std::nullopt);
}

size_t FaceWatch::add_part_near(const Body& loaded, const std::string& part, const Vec3& point) {
  const std::vector<bool> of = faces_of_part(loaded, part);
  double nearest2 = std::numeric_limits<double>::infinity();
  for (uint32_t f = 0; f < of.size(); ++f) {
    if (of[f]) nearest2 = std::min(nearest2, squared_distance(point, loaded.mesh.triangle(FaceId(f))));
  }
  if (nearest2 == std::numeric_limits<double>::infinity()) return add(loaded, of, std::nullopt);
  const double nearest = std::sqrt(nearest2);
  return add(loaded, of, Ball{point, std::max(1.25 * nearest, nearest + 0.1)});
}

std::vector<double> FaceWatch::areas_in(const Body& body) const {
  std::vector<double> areas(areas_.size(), 0);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    uint32_t groups = groups_of_[body.loaded_face(body.loaded_base(FaceId(f))).index];
    if (groups == 0) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    for (; groups != 0; groups &= groups - 1) {
      const auto group = static_cast<size_t>(std::countr_zero(groups));
      areas[group] += area_in(group, t);
    }
  }
  return areas;
}

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
  f.check(barrel.pivot != barrel.muzzle, "muzzle", "must differ from \"pivot\"");
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

static void describe(Fields& f, TankDescription& tank) {
  f.filled_text("part", tank.part);
  f.filled_text("mount", tank.mount, kOptional);
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
  f.check(!vehicle.wheels.empty() && vehicle.wheels.size() <= 12, "wheels", "must contain 1 to 12 wheels");
  f.object("turret", vehicle.turret);
  f.list("vital", "parts", vehicle.vitals, kOptional);
  const bool may_lack_vitals = !f.present("vital", false);
  f.check(vehicle.vitals.size() <= 8, "vital", "must contain at most 8 parts");
  f.check(may_lack_vitals || !vehicle.vitals.empty(), "vital",
          "must contain at least one part; without the key a vehicle is wrecked when little of it is left");
  if (f.present("tank", vehicle.tank.has_value())) f.object("tank", vehicle.tank.emplace());
  f.vector("driver_eye", vehicle.driver_eye, VectorRule::kNearby, kOptional);
  f.object("engine", vehicle.engine, kOptional);
}

Result<VehicleDescription> read_vehicle(const std::filesystem::path& file) {
  VehicleDescription vehicle;
  vehicle.name = file.stem().string();
  return read_described(file, std::move(vehicle));
}

Result<std::shared_ptr<const VehicleModel>> load_vehicle(VehicleDescription description,
                                                         const Progress* progress) {
  return ModelLoader(std::move(description), progress).load();
}

}  // namespace kerf
