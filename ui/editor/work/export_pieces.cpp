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

bool is_chosen(const PieceMap& looks, const PieceId& id) {
  const auto found = looks.find(id);
  return found != looks.end() && found->second.selected;
}

}  // namespace

std::filesystem::path numbered(const std::filesystem::path& file, size_t number) {
  std::filesystem::path result = file.parent_path() / file.stem();
  result += "-" + std::to_string(number);
  result += file.extension();
  return result;
}

Result<size_t> export_chosen(const World& world, const PieceMap& looks, const std::filesystem::path& file) {
  const auto format = mesh_format(file.extension().string());
  if (!format) return bad_input("The name must end in .obj, .ply, .stl or .off");
  const size_t count = chosen_pieces(looks);
  if (count == 0) return bad_input("No piece is chosen");
  size_t written = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (const std::vector<FaceId>& faces : faces_by_piece(body, false)) {
      if (!is_chosen(looks, {id, body.mesh.data(faces.front()).piece})) continue;
      const Status status =
          export_piece(body, faces, count == 1 ? file : numbered(file, written + 1), *format);
      if (!status) return status.error();
      ++written;
    }
  }
  return written;
}

}  // namespace kerf
