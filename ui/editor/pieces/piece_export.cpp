#include "ui/editor/pieces/piece_export.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "core/document/extract.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/mesh_file.h"
#include "ui/editor/shared/piece_set.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

// Converts linear light to sRGB, as stored in files, rounded to four digits.
double to_srgb(double x) {
  x = std::clamp(x, 0.0, 1.0);
  const double shown = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return std::round(1e4 * shown) / 1e4;
}

bool has_materials(const Body& body) {
  return std::any_of(body.material_names.begin(), body.material_names.end(),
                     [](const std::string& name) { return !name.empty(); });
}

std::string replaced(std::string text, const std::string& name) {
  for (size_t at = 0; (at = text.find('*', at)) != std::string::npos; at += name.size())
    text.replace(at, 1, name);
  return text;
}

fs::path with_suffix(const fs::path& file, const std::string& suffix) {
  return file.parent_path() / (file.stem().string() + suffix + file.extension().string());
}

std::string materials_text(const Extract& extract, const std::vector<std::string>& names,
                           const std::map<std::string, Paint>& paints) {
  std::set<uint16_t> used(extract.materials.begin(), extract.materials.end());
  std::vector<MaterialLook> looks;
  for (const uint16_t material : used) {
    KERF_ASSERT(material < names.size());
    const auto found = paints.find(names[material]);
    const Paint paint = found != paints.end() ? found->second : Paint();
    const Vec3& c = paint.colour;
    looks.push_back({names[material], {to_srgb(c.x), to_srgb(c.y), to_srgb(c.z)}, paint.gloss});
  }
  return encode_mtl(looks);
}

std::vector<FaceId> faces_of(const Body& body, uint32_t label) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f)) && body.mesh.data(FaceId(f)).piece == label) faces.emplace_back(f);
  }
  return faces;
}

Result<PrecisionLoss> write_piece(const World& world, const PieceFile& to,
                                  const std::map<std::string, Paint>& paints, MeshFormat format) {
  const Body& body = world.body(to.piece.body);
  const Extract extract = extract_faces(body, faces_of(body, to.piece.label));
  const std::string mtl = to.mtl.filename().string();
  if (!mtl.empty()) {
    const Status written =
        write_file_atomically(to.mtl, materials_text(extract, body.material_names, paints));
    if (!written) return written.error();
  }
  const std::string name = to.mesh.stem().string();
  const MeshView view{extract.positions, extract.triangles, extract.materials, body.material_names, mtl, name,
                      extract.colours};
  if (const Status written = write_mesh(view, to.mesh, format); !written) return written.error();
  return precision_loss(view, format);
}

}  // namespace

std::string file_name_of(const std::string& piece) {
  std::string name;
  for (const char c : piece) {
    const auto byte = static_cast<unsigned char>(c);
    const bool usable =
        byte > 0x20 && byte != 0x7f && std::string_view("/\\:*?\"<>|").find(c) == std::string_view::npos;
    name += usable ? c : '-';
  }
  if (!name.empty() && name.front() == '.') name.front() = '-';
  return name.empty() ? "piece" : name;
}

std::vector<PieceFile> files_to_export(const World& world, const PieceMap& looks, const fs::path& file) {
  const size_t chosen = chosen_pieces(looks);
  const bool by_name = file.filename().string().find('*') != std::string::npos;
  const bool is_obj = mesh_format(file.extension().string()) == MeshFormat::kObj;
  std::vector<PieceFile> files;
  std::set<fs::path> taken;
  for (const PieceRow& row : list_pieces(world, looks)) {
    const auto look = looks.find(row.id);
    if (look == looks.end() || !look->second.selected) continue;
    fs::path mesh = file.parent_path() / replaced(file.filename().string(), file_name_of(row.name));
    if (!by_name && chosen > 1) mesh = with_suffix(file, "-" + std::to_string(files.size() + 1));
    const fs::path wanted = mesh;
    for (int i = 2; !taken.insert(mesh).second; ++i) mesh = with_suffix(wanted, "-" + std::to_string(i));
    const bool has_mtl = is_obj && has_materials(world.body(row.id.body));
    files.push_back({row.id, mesh, has_mtl ? fs::path(mesh).replace_extension(".mtl") : fs::path()});
  }
  return files;
}

Result<ExportedPieces> export_chosen(const World& world, const PieceMap& looks,
                                     const std::map<std::string, Paint>& paints, const fs::path& file) {
  const auto format = mesh_format(file.extension().string());
  if (!format) return bad_input("The name must end in " + list_mesh_endings());
  std::vector<PieceFile> files = files_to_export(world, looks, file);
  if (files.empty()) return bad_input("No piece is selected");
  PrecisionLoss precision;
  for (const PieceFile& to : files) {
    const auto written = write_piece(world, to, paints, *format);
    if (!written) return written.error();
    precision += *written;
  }
  return ExportedPieces{std::move(files), precision_note(precision, *format, "export OBJ, PLY or OFF")};
}

// Returns the name of the selected piece, or with "*" for several.
std::string PieceExport::suggested_name() const {
  const PieceMap& looks = workspace_.view.look.pieces;
  const std::string ending = "." + std::string(format_row(workspace_.browser.format).ending);
  if (chosen_pieces(looks) != 1) return "*" + ending;
  for (const PieceRow& row : list_pieces(workspace_.world(), looks)) {
    if (row.id == first_chosen(looks)) return file_name_of(row.name) + ending;
  }
  return "piece" + ending;
}

void PieceExport::choose_file() {
  browse(workspace_.browser,
         {.title = "Export Selected",
          .verb = "Export",
          .hint = "File name; * stands for the name of each piece",
          .take = [this](const std::filesystem::path& file) { return export_to(file); },
          .writes =
              [this](const std::filesystem::path& file) {
                std::vector<std::filesystem::path> files;
                for (const PieceFile& f :
                     files_to_export(workspace_.world(), workspace_.view.look.pieces, file)) {
                  files.push_back(f.mesh);
                  if (!f.mtl.empty()) files.push_back(f.mtl);
                }
                return files;
              },
          .inputs = [this] { return inputs_of(workspace_.work); }},
         workspace_.settings.folder, suggested_name());
}

std::string PieceExport::export_to(const std::filesystem::path& file) {
  const auto written =
      export_chosen(workspace_.world(), workspace_.view.look.pieces, workspace_.work.paints, file);
  if (!written) return written.error().message;
  const std::string first = written->files.front().mesh.string();
  const std::string done = written->files.size() == 1 ? "Exported " + first
                                                      : std::to_string(written->files.size()) +
                                                            " pieces exported, the first: " + first;
  workspace_.message.say(written->note ? done + ". " + *written->note + "." : done,
                         written->note.has_value());
  return "";
}

}  // namespace kerf
