#include "core/document/scene.h"

#include "core/document/file_hash.h"
#include "core/document/json_value.h"
#include "core/document/scene_text.h"
#include "core/mesh/load_mesh.h"

namespace kerf {

namespace {

Status check_hash(const SceneBody& body) {
  if (!body.hash) return Done{};
  const auto hash = file_hash(body.mesh);
  if (!hash) return hash.error();
  if (*hash == *body.hash) return Done{};
  return bad_input(body.mesh.string() +
                   ": this mesh is another one than the journal was made with: put the old file back");
}

Result<SceneDescription> read_description(const std::filesystem::path& file) {
  if (file.extension() != ".json") {
    SceneDescription scene;
    scene.bodies.push_back(body_of_file(file));
    return scene;
  }
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file.string());
  if (!json) return json.error();
  return parse_scene(JsonValue(*json, file.string()), file.parent_path());
}

}  // namespace

SceneBody body_of_file(const std::filesystem::path& mesh) {
  SceneBody body;
  body.mesh = mesh;
  body.name = mesh.stem().string();
  return body;
}

Result<Scene> load_scene(SceneDescription description, const Progress* progress) {
  Scene scene{std::move(description), {}};
  const double share = 1 / static_cast<double>(scene.bodies.size());
  for (const SceneBody& body : scene.bodies) {
    if (const auto same = check_hash(body); !same) return same.error();
    const double before = share * static_cast<double>(&body - scene.bodies.data());
    const Progress loading = share_of(progress, before, before + share);
    auto built = load_mesh(body.mesh, &loading);
    if (!built) return built.error();
    const BodyId id = scene.world.add(make_body(body.name, std::move(*built)));
    scene.world.body(id).placement = body.placement;
  }
  return scene;
}

Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress) {
  auto description = read_description(file);
  if (!description) return description.error();
  return load_scene(std::move(*description), progress);
}

Status note_hashes(SceneDescription& description) {
  for (SceneBody& body : description.bodies) {
    if (body.hash) continue;
    const auto hash = file_hash(body.mesh);
    if (!hash) return hash.error();
    body.hash = *hash;
  }
  return Done{};
}

}  // namespace kerf
