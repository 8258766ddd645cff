#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/number_format.h"

namespace kerf {

enum class MeshFormat { kObj, kPly, kStl, kOff, kGlb, kGltf, k3mf };

struct MeshFormatRow {
  MeshFormat format;
  std::string_view ending;  // file name extension, without a dot
  std::string_view title;   // "OBJ"; the same for both kinds of glTF files
  std::string_view a_file;  // "an OBJ mesh"
  std::string_view mime_type;
  bool single_precision;  // of the positions
  bool materials;
  bool textures;
  bool uvs_and_normals;
  bool attributes;  // custom ones
};
// All supported formats, in the order of MeshFormat.
inline constexpr std::array kMeshFormats{
    MeshFormatRow{MeshFormat::kObj, "obj", "OBJ", "an OBJ mesh", "model/obj", false, true, true, true, false},
    MeshFormatRow{MeshFormat::kPly, "ply", "PLY", "a PLY mesh", "application/x-ply", false, false, false,
                  true, true},
    MeshFormatRow{MeshFormat::kStl, "stl", "STL", "an STL mesh", "model/stl", true, false, false, false,
                  false},
    MeshFormatRow{MeshFormat::kOff, "off", "OFF", "an OFF mesh", "application/x-off", false, false, false,
                  false, false},
    MeshFormatRow{MeshFormat::kGlb, "glb", "glTF", "a glTF file", "model/gltf-binary", true, true, true, true,
                  true},
    MeshFormatRow{MeshFormat::kGltf, "gltf", "glTF", "a glTF file", "model/gltf+json", true, true, true, true,
                  true},
    MeshFormatRow{MeshFormat::k3mf, "3mf", "3MF", "a 3MF file", "model/3mf", true, true, false, false,
                  false}};

constexpr const MeshFormatRow& format_row(MeshFormat format) {
  return kMeshFormats[static_cast<size_t>(format)];
}

// Returns true for both kinds of glTF files.
constexpr bool is_gltf(MeshFormat format) {
  return format == MeshFormat::kGlb || format == MeshFormat::kGltf;
}

// Returns true for formats whose lengths are in metres or in a unit that the file states.
constexpr bool states_unit(MeshFormat format) { return is_gltf(format) || format == MeshFormat::k3mf; }

// Returns true for the formats that write_meshes() writes.
constexpr bool holds_several_meshes(MeshFormat format) {
  return is_gltf(format) || format == MeshFormat::k3mf;
}

// Return the extensions, each after `before`, and the titles, as lists in a sentence: ".obj, .ply, .stl,
// .off, .glb, .gltf or .3mf" and "OBJ, PLY, STL, OFF, glTF or 3MF".
std::string list_mesh_endings(std::string_view before = ".", std::string_view last = " or ");
std::string list_mesh_titles(std::string_view last = " or ");

// Returns the format of a file name extension, in any case and with or without a dot; nullopt if unknown.
std::optional<MeshFormat> mesh_format(std::string_view name);

// Recognises the format of a file by its bytes. Only if they fit no format (a damaged file), `ending`, the
// extension of its name, decides, so that a reader can report the damage.
std::optional<MeshFormat> recognise_format(std::string_view bytes, std::string_view ending);

// Returns the kind of a file, for an error message: "an OBJ mesh", "a PNG image", "a Kerf scene"; empty if
// unknown. Linear in the number of bytes; searches at most a mebibyte.
std::string_view kind_of_file(std::string_view bytes);

// The unit of the numbers in a mesh file.
enum class FileUnit { kMillimetre, kCentimetre, kMetre, kInch };

// The axis of a mesh file that points upwards. Both conventions are right-handed.
enum class UpAxis { kY, kZ };

// The interpretation of the coordinates of a mesh file. Except for 3MF, whose positions are converted to
// metres, the file stores neither unit nor axis, so both are guessed and the user may change them. They
// affect only the display: positions stay as read.
struct FileFrame {
  FileUnit unit = FileUnit::kMetre;
  UpAxis up = UpAxis::kY;

  // Returns true for Kerf's own convention, which needs no conversion.
  bool is_default() const { return *this == FileFrame(); }
  friend bool operator==(const FileFrame&, const FileFrame&) = default;
};

// Guesses the unit and the upward axis of a file, from its format and the bounding box of its mesh in file
// units. STL files usually come from CAD and 3D printing, in millimetres with +Z upwards; other formats from
// modelling tools, games and research, in metres with +Y upwards, or in centimetres or millimetres if the
// mesh would otherwise be larger than a lorry. If the mesh stands on exactly one of the planes y = 0 and z =
// 0, that axis points upwards regardless of the format. Precondition: min <= max, both finite.
FileFrame guess_frame(MeshFormat format, const Vec3& min, const Vec3& max);

double metres_per_unit(FileUnit unit);

// Returns "mm", "cm", "m" or "in".
std::string_view unit_symbol(FileUnit unit);
// The inverse of unit_symbol(); nullopt for any other text.
std::optional<FileUnit> unit_named(std::string_view symbol);

// Converts a direction or point into a frame in which +Y points upwards: (x, z, -y) for kZ. Exact.
Vec3 to_y_up(const Vec3& v, UpAxis up);
// The inverse of to_y_up().
Vec3 from_y_up(const Vec3& v, UpAxis up);
// The coordinate of v along the upward axis.
double height_of(const Vec3& v, UpAxis up);

}  // namespace kerf
