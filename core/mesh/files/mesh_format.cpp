#include "core/mesh/files/mesh_format.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/files/scanner.h"

namespace kerf {

namespace {

constexpr bool are_in_order() {
  for (size_t i = 0; i < kMeshFormats.size(); ++i) {
    if (static_cast<size_t>(kMeshFormats[i].format) != i) return false;
  }
  return true;
}
static_assert(are_in_order());

constexpr std::array<std::string_view, 13> kObjKeywords{"v", "vt",     "vn",     "vp", "f", "g", "o",
                                                        "s", "usemtl", "mtllib", "l",  "p", "mg"};

// Maximum length of comments and blanks searched before the first word of a text file [bytes].
constexpr size_t kMaxPreface = 1 << 20;

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return result;
}

std::optional<MeshFormat> format_of_first_word(std::string_view bytes) {
  Scanner scanner(bytes.substr(0, kMaxPreface), {}, {.comments = true, .continuations = false}, nullptr);
  scanner.at_end();
  const std::string_view word = scanner.word();
  if (word == "ply") return MeshFormat::kPly;
  if (is_off_keyword(word)) return MeshFormat::kOff;
  if (lower(word) == "solid") return MeshFormat::kStl;
  if (std::find(kObjKeywords.begin(), kObjKeywords.end(), word) != kObjKeywords.end())
    return MeshFormat::kObj;
  return std::nullopt;
}

// Returns true for a JSON object with the member that every glTF file has.
bool is_gltf_text(std::string_view bytes) {
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' &&
         bytes.find("\"asset\"") != std::string_view::npos;
}

// Returns true for a ZIP archive with the model of a 3MF file, which need not have the usual name.
bool is_3mf(std::string_view bytes) {
  const auto has = [&](std::string_view text) { return bytes.find(text) != std::string_view::npos; };
  return bytes.starts_with("PK\x03\x04") &&
         (has("3D/3dmodel") || (has("[Content_Types].xml") && has(".model")));
}

// A kind of file that begins with `start`, at the byte `at`, and contains `word` unless that is empty.
struct Signature {
  std::string_view start;
  std::string_view kind;
  std::string_view word{};
  size_t at = 0;
};

// Bytes that never begin a text, and lines that are invalid in supported formats. The first match applies.
constexpr std::array kSignatures{
    Signature{"\x89PNG", "a PNG image"},
    Signature{"\xff\xd8\xff", "a JPEG image"},
    Signature{"GIF8", "a GIF image"},
    Signature{"WEBP", "a WebP image", {}, 8},
    Signature{std::string_view("MM\0*", 4), "a TIFF image"},
    Signature{std::string_view("II*\0", 4), "a TIFF image"},
    Signature{"%PDF", "a PDF document"},
    Signature{"PK\x03\x04", "a USDZ file", ".usd"},
    Signature{"PK\x03\x04", "a ZIP archive"},
    Signature{"\x1f\x8b", "a file packed with gzip"},
    Signature{"7z\xbc\xaf", "a 7z archive"},
    Signature{"\3757zXZ", "a file packed with xz"},
    Signature{"\x28\xb5\x2f\xfd", "a file packed with Zstandard"},
    Signature{"BZh", "a file packed with bzip2"},
    Signature{"\177ELF", "a compiled program or library"},
    Signature{"\x4c\x01", "object code of a compiler"},
    Signature{"\x64\x86", "object code of a compiler"},
    Signature{"Kaydara FBX", "an FBX file"},
    Signature{"; FBX", "an FBX file"},
    Signature{"BLENDER", "a Blender file"},
    Signature{"ISO-10303-21", "a STEP file"},
    Signature{"PXR-USDC", "a USD file"},
    Signature{"#usda", "a USD file"},
    Signature{"#VRML", "a VRML file"},
    Signature{"# vtk", "a VTK file"},
    Signature{"$MeshFormat", "a Gmsh file"},
    Signature{"MeshVersionFormatted", "a Medit file"},
    Signature{"3D Geometry File Format", "a Rhino file"},
    Signature{"*3DSMAX_ASCIIEXPORT", "an ASE file"},
    Signature{"xof 0", "a DirectX file"},
    Signature{"DRACO", "a Draco file"},
    Signature{"AutoCAD Binary DXF", "a DXF drawing"},
    Signature{"MM", "a 3DS file", "\x3d\x3d"},
};

// Likewise for text, after leading blanks.
constexpr std::array kTextSignatures{
    Signature{"0", "a DXF drawing", "SECTION"},
    Signature{"<", "a Collada file", "<COLLADA"},
    Signature{"<", "an X3D file", "<X3D"},
    Signature{"<", "an AMF file", "<amf"},
    Signature{"<", "an SVG drawing", "<svg"},
    Signature{"<", "a web page", "<html"},
    Signature{"<", "a web page", "<!DOCTYPE html"},
    Signature{"<", "an XML file", "<?xml"},
    Signature{"{", "a Kerf journal", "\"kerf\":\"journal\""},
    Signature{"{", "a Kerf scene", "\"bodies\""},
    Signature{"{", "a Kerf path", "\"strokes\""},
};

template <size_t N>
std::string_view kind_by(const std::array<Signature, N>& signatures, std::string_view bytes) {
  const auto fits = [&](const Signature& s) {
    return bytes.size() >= s.at && bytes.substr(s.at).starts_with(s.start) &&
           bytes.find(s.word) != std::string_view::npos;
  };
  const auto found = std::find_if(signatures.begin(), signatures.end(), fits);
  return found == signatures.end() ? std::string_view() : found->kind;
}

// Lengths in the units of the file.
constexpr double kLargestModelInMetres = 50;         // a lorry, a house, an airliner's fuselage
constexpr double kLargestModelInCentimetres = 1000;  // a car is 450 long, and 4,500 in millimetres
constexpr double kSmallestPart = 2.5;  // in millimetres; smaller STL files are models of about unit size

// Maximum distance of a standing mesh from the ground plane, relative to its height.
constexpr double kStandingSlack = 0.01;

bool touches_zero(double low, double high) {
  const double slack = kStandingSlack * (high - low);
  return low < high && -slack <= low && low <= slack;
}

FileUnit guess_unit(MeshFormat format, double longest) {
  if (format == MeshFormat::k3mf) return FileUnit::kMetre;
  if (format == MeshFormat::kStl) return longest < kSmallestPart ? FileUnit::kMetre : FileUnit::kMillimetre;
  if (longest <= kLargestModelInMetres) return FileUnit::kMetre;
  return longest <= kLargestModelInCentimetres ? FileUnit::kCentimetre : FileUnit::kMillimetre;
}

UpAxis guess_up(MeshFormat format, const Vec3& min, const Vec3& max) {
  const bool on_y = touches_zero(min.y, max.y), on_z = touches_zero(min.z, max.z);
  if (on_y != on_z) return on_y ? UpAxis::kY : UpAxis::kZ;
  return format == MeshFormat::kStl || format == MeshFormat::k3mf ? UpAxis::kZ : UpAxis::kY;
}

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view name) {
  if (name.starts_with('.')) name.remove_prefix(1);
  const auto found = std::find_if(kMeshFormats.begin(), kMeshFormats.end(),
                                  [&](const MeshFormatRow& row) { return row.ending == lower(name); });
  if (found == kMeshFormats.end()) return std::nullopt;
  return found->format;
}

std::string list_mesh_endings(std::string_view before, std::string_view last) {
  std::vector<std::string> names;
  for (const MeshFormatRow& row : kMeshFormats) names.push_back(std::string(before) += row.ending);
  return listed(names, last);
}

std::string list_mesh_titles(std::string_view last) {
  std::vector<std::string> names;
  for (const MeshFormatRow& row : kMeshFormats) {
    if (names.empty() || names.back() != row.title) names.emplace_back(row.title);
  }
  return listed(names, last);
}

std::optional<MeshFormat> recognise_format(std::string_view bytes, std::string_view ending) {
  if (GltfFile::is_binary(bytes)) return MeshFormat::kGlb;
  if (is_exact_binary_stl(bytes)) return MeshFormat::kStl;
  if (is_3mf(bytes)) return MeshFormat::k3mf;
  if (is_gltf_text(bytes)) return MeshFormat::kGltf;
  const std::optional<MeshFormat> by_content = format_of_first_word(bytes);
  return by_content ? by_content : mesh_format(ending);
}

std::string_view kind_of_file(std::string_view bytes) {
  if (is_3mf(bytes)) return format_row(MeshFormat::k3mf).a_file;
  const std::string_view start = bytes.substr(0, kMaxPreface);
  const std::string_view foreign = kind_by(kSignatures, start);
  if (!foreign.empty()) return foreign;
  if (const auto format = recognise_format(bytes, {})) return format_row(*format).a_file;
  const size_t first = start.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : kind_by(kTextSignatures, start.substr(first));
}

FileFrame guess_frame(MeshFormat format, const Vec3& min, const Vec3& max) {
  KERF_ASSERT(min.x <= max.x && min.y <= max.y && min.z <= max.z);
  const Vec3 size = max - min;
  return {guess_unit(format, std::max({size.x, size.y, size.z})), guess_up(format, min, max)};
}

double metres_per_unit(FileUnit unit) {
  constexpr std::array kMetres{0.001, 0.01, 1.0, 0.0254};
  return kMetres.at(static_cast<size_t>(unit));
}

namespace {

constexpr std::array<std::string_view, 4> kUnitSymbols{"mm", "cm", "m", "in"};

}  // namespace

std::string_view unit_symbol(FileUnit unit) { return kUnitSymbols.at(static_cast<size_t>(unit)); }

std::optional<FileUnit> unit_named(std::string_view symbol) {
  const auto found = std::ranges::find(kUnitSymbols, symbol);
  if (found == kUnitSymbols.end()) return std::nullopt;
  return static_cast<FileUnit>(found - kUnitSymbols.begin());
}

Vec3 to_y_up(const Vec3& v, UpAxis up) { return up == UpAxis::kZ ? Vec3(v.x, v.z, -v.y) : v; }

Vec3 from_y_up(const Vec3& v, UpAxis up) { return up == UpAxis::kZ ? Vec3(v.x, -v.z, v.y) : v; }

double height_of(const Vec3& v, UpAxis up) { return up == UpAxis::kZ ? v.z : v.y; }

}  // namespace kerf
