#include "core/document/files/scene.h"

#include "core/document/files/file_hash.h"
#include "core/document/files/scene_text.h"
#include "core/document/text/fields.h"
#include "core/mesh/enclosed_volume.h"
#include "core/world/load_body.h"
#include "core/world/solid_body.h"

namespace kerf {

namespace {

constexpr double kHashing = 0.02;  // of the time that loading a body takes whose hash is known

Status check_hash(const SceneBody& body, const Progress& progress) {
  const auto hash = file_hash(body.mesh, &progress);
  if (!hash) return hash.error();
  if (*hash == *body.hash) return Done{};
  return bad_input(body.mesh.string() +
                   ": this mesh is another one than the journal was made with: put the old file back");
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

Status note_hashes(SceneDescription& description, const Progress* progress) {
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
