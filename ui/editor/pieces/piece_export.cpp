#include "ui/editor/pieces/piece_export.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "core/document/extract.h"
#include "core/document/lost_looks.h"
#include "core/document/piece_looks.h"
#include "core/document/surface_files.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/looks.h"
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

const SurfaceLibrary* surfaces_of(const Body& body) {
  return body.looks ? body.looks->surfaces().get() : nullptr;
}

// Writes pieces in one format, and collects what that loses.
class PieceWriter {
 public:
  PieceWriter(const World& world, const std::map<std::string, Paint>& paints, MeshFormat format)
      : world_(world), paints_(paints), format_(format) {}

  // Writes the materials that the mesh files describe, for OBJ.
  Status write_surfaces(std::span<const PieceFile> files, const fs::path& folder) {
    std::set<BodyId> bodies;
    for (const PieceFile& to : files) {
      const Body& body = world_.body(to.piece.body);
      if (surfaces_of(body) && bodies.insert(to.piece.body).second) surfaces_.add(body);
    }
    return format_ == MeshFormat::kObj ? surfaces_.write(folder) : Status(Done{});
  }

  // Precondition: write_surfaces() has succeeded.
  Status write(const PieceFile& to) {
    const Body& body = world_.body(to.piece.body);
    const std::vector<FaceId> faces = faces_of(body, to.piece.label);
    const Extract extract = extract_faces(body, faces);
    const std::string name = to.mesh.stem().string(), mtl = to.mtl.filename().string();
    if (!mtl.empty()) {
      const Status written =
          write_file_atomically(to.mtl, materials_text(extract, body.material_names, paints_));
      if (!written) return written;
    }
    MeshView view{extract.positions, extract.triangles, extract.materials, body.material_names, mtl, name,
                  extract.colours};
    CornerLooks looks;
    if (format_row(format_).uvs_and_normals)
      looks = looks_of(body, faces, is_gltf(format_) ? LookNormals::kAll : LookNormals::kSmooth);
    if (looks.any()) view.looks = &looks;
    view.surfaces = surfaces_of(body);
    if (view.surfaces && !surfaces_.library().empty()) {
      view.mtl = surfaces_.library();
      view.material_names = surfaces_.names(body);
    }
    if (const Status written = write_mesh(view, to.mesh, format_); !written) return written;
    precision_ += precision_loss(view, format_);
    lost_.add(body, extract, format_);
    return Done{};
  }

  // Returns sentences for the user, each without its full stop; nullopt if nothing was lost.
  std::optional<std::string> note() const {
    std::vector<std::string> notes;
    lost_.add_notes(format_, notes);
    if (const auto note = precision_note(precision_, format_, "export OBJ, PLY or OFF"))
      notes.push_back(*note);
    if (notes.empty()) return std::nullopt;
    std::string text;
    for (const std::string& note : notes) text += (text.empty() ? "" : ". ") + note;
    return text;
  }

 private:
  const World& world_;
  const std::map<std::string, Paint>& paints_;
  MeshFormat format_;
  SurfaceFiles surfaces_;
  PrecisionLoss precision_;
  LostLooks lost_;
};

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
  const size_t selected = selected_count(looks);
  const bool by_name = file.filename().string().find('*') != std::string::npos;
  const bool is_obj = mesh_format(file.extension().string()) == MeshFormat::kObj;
  std::vector<PieceFile> files;
  std::set<fs::path> taken;
  for (const PieceRow& row : list_pieces(world, looks)) {
    const auto look = looks.find(row.id);
    if (look == looks.end() || !look->second.selected) continue;
    fs::path mesh = file.parent_path() / replaced(file.filename().string(), file_name_of(row.name));
    if (!by_name && selected > 1) mesh = with_suffix(file, "-" + std::to_string(files.size() + 1));
    const fs::path wanted = mesh;
    for (int i = 2; !taken.insert(mesh).second; ++i) mesh = with_suffix(wanted, "-" + std::to_string(i));
    const Body& body = world.body(row.id.body);
    const bool has_mtl = is_obj && has_materials(body) && !surfaces_of(body);
    files.push_back({row.id, mesh, has_mtl ? fs::path(mesh).replace_extension(".mtl") : fs::path()});
  }
  return files;
}

Result<ExportedPieces> export_selected(const World& world, const PieceMap& looks,
                                       const std::map<std::string, Paint>& paints, const fs::path& file) {
  const auto format = mesh_format(file.extension().string());
  if (!format) return bad_input("The name must end in " + list_mesh_endings());
  std::vector<PieceFile> files = files_to_export(world, looks, file);
  if (files.empty()) return bad_input("No piece is selected");
  PieceWriter writer(world, paints, *format);
  Status written = writer.write_surfaces(files, file.parent_path());
  for (size_t i = 0; i < files.size() && written; ++i) written = writer.write(files[i]);
  if (!written) return written.error();
  return ExportedPieces{std::move(files), writer.note()};
}

// Returns the name of the selected piece, or with "*" for several.
std::string PieceExport::suggested_name() const {
  const PieceMap& looks = workspace_.view.look.pieces;
  const std::string ending = "." + std::string(format_row(workspace_.services.browser.format).ending);
  if (selected_count(looks) != 1) return "*" + ending;
  for (const PieceRow& row : list_pieces(workspace_.world(), looks)) {
    if (row.id == first_selected(looks)) return file_name_of(row.name) + ending;
  }
  return "piece" + ending;
}

void PieceExport::select_file() {
  browse(workspace_.services.browser,
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
          .inputs = [this] { return inputs_of(workspace_.session); }},
         workspace_.settings.folder, suggested_name());
}

std::string PieceExport::export_to(const std::filesystem::path& file) {
  const auto written =
      export_selected(workspace_.world(), workspace_.view.look.pieces, workspace_.session.paints, file);
  if (!written) return written.error().message;
  const std::string first = written->files.front().mesh.string();
  const std::string done = written->files.size() == 1 ? "Exported " + first
                                                      : std::to_string(written->files.size()) +
                                                            " pieces exported, the first: " + first;
  workspace_.message.show(written->note ? done + ". " + *written->note + "." : done,
                          written->note.has_value());
  return "";
}

}  // namespace kerf
