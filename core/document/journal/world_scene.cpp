#include "core/document/journal/world_scene.h"

#include <cstdio>

#include "core/document/files/extract.h"
#include "core/document/journal/save.h"
#include "core/mesh/write_mesh.h"

namespace kerf {

Result<std::filesystem::path> save_world_as_scene(const World& world, SceneDescription description,
                                                  const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return failed(folder.string() + ": the folder cannot be made");
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
    const MeshView view{e.positions, e.triangles, e.materials, body.material_names};
    if (const Status written = write_mesh(view, folder / name, MeshFormat::kObj); !written)
      return written.error();
    SceneBody entry;
    entry.mesh = folder / name;
    entry.name = body.name;
    entry.sheet = body.sheet;
    description.bodies.push_back(std::move(entry));
  }
  const std::filesystem::path file = folder / "scene.json";
  if (const Status saved = save_scene(file, description); !saved) return saved.error();
  return file;
}

}  // namespace kerf
