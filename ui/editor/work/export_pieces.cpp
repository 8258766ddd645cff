#include "ui/editor/work/export_pieces.h"

#include "core/document/extract.h"
#include "core/mesh/write_mesh.h"

namespace kerf {

namespace {

Status export_piece(const Body& body, std::span<const FaceId> faces, const std::filesystem::path& file,
                    MeshFormat format) {
  const Extract extract = extract_faces(body, faces);
  return write_mesh({extract.positions, extract.triangles, extract.materials, body.material_names}, file,
                    format);
}

bool is_chosen(const EditorState& state, const PieceId& id) {
  const auto found = state.look.pieces.find(id);
  return found != state.look.pieces.end() && found->second.selected;
}

}  // namespace

std::filesystem::path numbered(const std::filesystem::path& file, size_t number) {
  std::filesystem::path result = file.parent_path() / file.stem();
  result += "-" + std::to_string(number);
  result += file.extension();
  return result;
}

Result<size_t> export_chosen(const EditorState& state, const std::filesystem::path& file) {
  const auto format = mesh_format(file.extension().string());
  if (!format) return bad_input("The name must end in .obj, .ply, .stl or .off");
  size_t count = 0;
  for (const auto& [id, look] : state.look.pieces) count += look.selected ? 1 : 0;
  if (count == 0) return bad_input("No piece is chosen");
  size_t written = 0;
  const World& world = state.document.world();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (const std::vector<FaceId>& faces : faces_by_piece(body, false)) {
      if (!is_chosen(state, {id, body.mesh.data(faces.front()).piece})) continue;
      const Status status =
          export_piece(body, faces, count == 1 ? file : numbered(file, written + 1), *format);
      if (!status) return status.error();
      ++written;
    }
  }
  return written;
}

}  // namespace kerf
