#include "core/face/face_journal.h"

#include <cstdio>

#include "core/document/journal/journal.h"
#include "core/document/journal/save.h"
#include "core/mesh/write_mesh.h"

namespace kerf {

void Beginning::set_substance(const Substance& substance) {
  const auto give = [&](Sheet& sheet) {
    sheet.substance = substance;
    sheet.density = substance.density;
  };
  for (SceneBody& body : scene_.bodies) give(body.sheet);
  give(sheet_);
}

Status Beginning::save(const Document& document, const std::filesystem::path& file) const {
  if (lost_)
    return bad_input(
        "the world has no journal, because a body was added or the material was changed after a cut; save "
        "the "
        "scene instead");
  if (document.world().ids().empty() && document.journal().empty())
    return bad_input("the world has no mesh; add one before its journal is saved");
  // Where the journal cannot be, its meshes must not be either.
  std::error_code error;
  const auto type = std::filesystem::status(file, error).type();
  if (!file.has_filename() ||
      (type != std::filesystem::file_type::regular && type != std::filesystem::file_type::not_found))
    return bad_input("path: must be the name of a file");
  SceneDescription scene = scene_;
  scene.strokes.clear();  // which are commands of the document
  for (const auto& [mesh, name] : added_) {
    char ending[24];
    std::snprintf(ending, sizeof ending, "-mesh-%04zu.obj", scene.bodies.size() + 1);
    SceneBody body;
    body.mesh = file.parent_path() / (file.stem().string() + ending);
    body.name = name;
    body.sheet = sheet_;
    const MeshView view{mesh.positions, mesh.triangles, mesh.materials, mesh.material_names, {}, {},
                        mesh.colours};
    if (const Status written = write_mesh(view, body.mesh, MeshFormat::kObj); !written) return written;
    scene.bodies.push_back(std::move(body));
  }
  if (const Status noted = note_hashes(scene); !noted) return noted;
  std::vector<StateMark> marks;
  // The journal that was opened may end within a stroke.
  if (!document.execution().in_stroke() && document.waiting() == 0) marks.push_back(state_mark(document));
  return save_journal(file, scene, document.journal(), marks);
}

}  // namespace kerf
