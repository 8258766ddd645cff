#include "core/document/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

#include "core/base/deterministic_math.h"
#include "core/document/scene_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash.h"
#include "core/mesh/measures.h"
#include "core/world/body_creation.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

// The faces of a side of a hinge may extend farther from its pin than as loaded, by this fraction of its
// radius.
constexpr double kPinPlay = 0.1;

class CarrierSearch {
 public:
  CarrierSearch(const SceneJoint& joint, const Body& body) : joint_(joint), body_(body) {}

  Result<JointSide> side(size_t i) const {
    const Vec3 point = joint_.near ? (*joint_.near)[i] : joint_.anchor;
    std::vector<Near> near;
    for (const MeshPart& part : body_.named_parts) {
      if (part.name != joint_.parts[i]) continue;
      for (uint32_t f = part.first; f < part.last; ++f)
        near.push_back({squared_distance(point, body_.mesh.triangle(FaceId(f))), f});
    }
    if (near.empty()) return wrong("the mesh has no part named \"" + joint_.parts[i] + "\"");
    const Near& nearest = *std::min_element(near.begin(), near.end());
    if (joint_.radius && nearest.distance2 > *joint_.radius * *joint_.radius)
      return wrong("no face of \"" + joint_.parts[i] + "\" is within its radius");
    JointSide side;
    side.component = component(nearest.face);
    side.point = point;
    if (joint_.radius) side.radius = *joint_.radius;
    for (const Near& n : near) {
      if (joint_.radius && n.distance2 > *joint_.radius * *joint_.radius) continue;
      if (component(n.face) == side.component) side.faces.push_back(n.face);
    }
    std::sort(side.faces.begin(), side.faces.end());
    side.faces.erase(std::unique(side.faces.begin(), side.faces.end()), side.faces.end());
    return side;
  }

  double distance_to(const JointSide& side, const Vec3& point) const {
    double least2 = std::numeric_limits<double>::infinity();
    for (const uint32_t f : side.faces)
      least2 = std::min(least2, squared_distance(point, body_.mesh.triangle(FaceId(f))));
    return std::sqrt(least2);
  }

  bool is_near_mesh(const Vec3& p) const {
    const MeshReport& loaded = body_.loaded;
    return glm::length(p - body_.middle()) <= 100 * glm::length(loaded.max - loaded.min);
  }

  Error wrong(const std::string& what) const {
    return bad_input("the joint of \"" + joint_.parts[0] + "\" and \"" + joint_.parts[1] + "\" in " +
                     body_.name + ": " + what);
  }

 private:
  struct Near {
    double distance2;
    uint32_t face;
    auto operator<=>(const Near&) const = default;
  };

  uint32_t component(uint32_t face) const {
    const std::vector<uint32_t>& of_base = body_.components.of_base;
    return of_base.empty() ? 0 : of_base[face];
  }

  const SceneJoint& joint_;
  const Body& body_;
};

}  // namespace

Result<Joint> make_joint(const SceneJoint& joint, BodyId id, const Body& body) {
  const CarrierSearch search(joint, body);
  Joint made;
  made.kind = joint.kind;
  made.body = id;
  made.anchor = joint.anchor;
  const Vec3 size = glm::abs(joint.axis);
  made.axis = glm::normalize(joint.axis / std::max({size.x, size.y, size.z}));
  if (!search.is_near_mesh(joint.anchor)) return search.wrong("its anchor is too far from the mesh");
  if (joint.limits) made.limits = Interval{radians_of(joint.limits->low), radians_of(joint.limits->high)};
  for (size_t i = 0; i < 2; ++i) {
    auto side = search.side(i);
    if (!side) return side.error();
    made.sides[i] = std::move(*side);
    if (made.kind == Joint::Kind::kHinge && joint.radius)
      made.sides[i].reaches_pin = search.distance_to(made.sides[i], made.anchor) + kPinPlay * *joint.radius;
  }
  std::vector<uint32_t> both;
  std::set_intersection(made.sides[0].faces.begin(), made.sides[0].faces.end(), made.sides[1].faces.begin(),
                        made.sides[1].faces.end(), std::back_inserter(both));
  if (!both.empty())
    return search.wrong("a face carries both sides: move \"near\" apart or reduce \"radius\"");
  return made;
}

namespace {

constexpr double kHashing = 0.02;  // fraction of the load time of a body with a known hash

Status check_hash(const SceneBody& body, const Progress& progress) {
  const auto hash = file_hash(body.mesh, &progress);
  if (!hash) return hash.error();
  if (*hash == *body.hash) return Done{};
  return bad_input(
      body.mesh.string() +
      ": the mesh differs from the one that the journal was recorded with: restore the original file");
}

bool is_solid(Solidity solid, const Body& loaded) {
  if (solid != Solidity::kAuto) return solid == Solidity::kSolid;
  const EnclosedVolume enclosed = enclosed_volume(loaded.mesh, loaded.middle());
  return enclosed.closed && enclosed.volume > 0;
}

}  // namespace

Result<SceneDescription> read_description(const std::filesystem::path& file) {
  if (file.extension() != ".json") {
    SceneDescription scene;
    scene.bodies.push_back(body_of_file(file));
    return scene;
  }
  return read_described<SceneDescription>(file);
}

Result<BodyId> add_scene_body(const SceneBody& description, Body body, World& world) {
  body.placement = description.placement;
  body.sheet = description.sheet;
  body.cut_material = description.cut_material;
  if (is_solid(description.solid, body)) make_solid(body, true);
  const BodyId id = world.add(std::move(body));
  Joints joints = world.joints();
  for (const SceneJoint& joint : description.joints) {
    auto made = make_joint(joint, id, world.body(id));
    if (!made) return bad_input(description.mesh.string() + ": " + made.error().message);
    joints.all.push_back(std::move(*made));
  }
  if (!description.joints.empty()) world.set_joints(std::move(joints));
  return id;
}

SceneBody body_of_file(const std::filesystem::path& mesh) {
  SceneBody body;
  body.mesh = mesh;
  body.name = mesh.stem().string();
  return body;
}

Result<Scene> load_scene(SceneDescription description, const Progress* progress) {
  Scene scene{std::move(description), {}};
  const double share = 1 / static_cast<double>(scene.bodies.size());
  ProgressShares shares(progress);
  for (const SceneBody& body : scene.bodies) {
    const double hashed = body.hash ? kHashing : 0;
    const Progress hashing = shares.next(hashed * share), loading = shares.next((1 - hashed) * share);
    if (body.hash) {
      if (const auto same = check_hash(body, hashing); !same) return same.error();
    }
    auto loaded = load_body(body.name, body.mesh, &loading);
    if (!loaded) return loaded.error();
    if (const auto added = add_scene_body(body, std::move(*loaded), scene.world); !added)
      return added.error();
  }
  return scene;
}

Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress) {
  auto description = read_description(file);
  if (!description) return description.error();
  return load_scene(std::move(*description), progress);
}

Status record_hashes(SceneDescription& description, const Progress* progress) {
  ProgressShares shares(progress);
  for (SceneBody& body : description.bodies) {
    const Progress hashing = shares.next(1 / static_cast<double>(description.bodies.size()));
    if (body.hash) continue;
    const auto hash = file_hash(body.mesh, &hashing);
    if (!hash) return hash.error();
    body.hash = *hash;
  }
  return Done{};
}

}  // namespace kerf
