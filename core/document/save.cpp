#include "core/document/save.h"

#include <cstdio>

#include "core/base/platform.h"
#include "core/document/extract.h"
#include "core/document/input_files.h"
#include "core/document/scene_text.h"
#include "core/document/stroke_path.h"
#include "core/document/text/json.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  return (error ? file : whole).parent_path();
}

// Atomically makes `previous` a hard link to the file, or a copy if the file system does not support links.
Status keep(const fs::path& file, const fs::path& previous) {
  fs::path fresh = previous;
  fresh += ".new";
  std::error_code error;
  fs::remove(fresh, error);
  fs::create_hard_link(file, fresh, error);
  if (error) fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, error);
  if (!error) fs::rename(fresh, previous, error);
  if (!error) return Done{};
  return failed("cannot keep the previous version of " + file.string() + " as " + previous.string() + ": " +
                error.message());
}

}  // namespace

fs::path previous_version(const fs::path& file) {
  fs::path previous = file;
  previous += "~";
  return previous;
}

Status save_file(const fs::path& file, std::string_view bytes) {
  std::error_code error;
  const fs::path target = fs::is_regular_file(file, error) ? fs::canonical(file, error) : file;
  if (!error && fs::is_regular_file(target, error)) {
    if (const auto kept = keep(target, previous_version(target)); !kept) return kept;
  }
  return write_file_atomically(file, bytes);
}

Status save_journal(const fs::path& file, const SceneDescription& scene, std::span<const Command> commands,
                    std::span<const StateMark> marks) {
  InputFiles inputs;
  inputs.add_meshes(scene);
  inputs.add_meshes(commands);
  if (const Status free = inputs.check("journal", file); !free) return free;
  const fs::path folder = folder_of(file);
  const auto head = journal_head(scene, {}, folder);
  if (!head) return head.error();
  const auto lines = journal_lines(commands, marks, folder);
  if (!lines) return lines.error();
  return save_file(file, *head + *lines);
}

Status save_scene(const fs::path& file, const SceneDescription& scene) {
  InputFiles inputs;
  inputs.add_meshes(scene);
  if (const Status free = inputs.check("scene", file); !free) return free;
  SceneDescription without_hashes = scene;
  for (SceneBody& body : without_hashes.bodies) body.hash.reset();
  const auto text = dump_json(scene_json(without_hashes, folder_of(file)), 2);
  if (!text) return text.error();
  return save_file(file, *text + "\n");
}

Status save_path(const fs::path& file, std::span<const StrokePath> strokes) {
  return save_file(file, path_file_text(strokes));
}

Result<std::filesystem::path> save_world_as_scene(const World& world, SceneDescription description,
                                                  const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return failed(folder.string() + ": cannot create the folder");
  description.bodies.clear();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden || body.mesh.live_faces() == 0) continue;
    std::vector<FaceId> faces;
    for (const auto& piece : faces_by_piece(body, false))
      faces.insert(faces.end(), piece.begin(), piece.end());
    std::sort(faces.begin(), faces.end());
    const Extract e = extract_faces(body, faces);
    char name[40];
    std::snprintf(name, sizeof name, "body-%04zu.obj", description.bodies.size() + 1);
    const MeshView view{e.positions, e.triangles, e.materials, body.material_names, {}, {}, e.colours};
    if (const Status written = write_mesh(view, folder / name, MeshFormat::kObj); !written)
      return written.error();
    SceneBody entry;
    entry.mesh = folder / name;
    entry.name = body.name;
    entry.sheet = body.sheet;
    entry.solid = body.solid ? Solidity::kSolid : Solidity::kSheet;
    description.bodies.push_back(std::move(entry));
  }
  const std::filesystem::path file = folder / "scene.json";
  if (const Status saved = save_scene(file, description); !saved) return saved.error();
  return file;
}

}  // namespace kerf
