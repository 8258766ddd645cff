#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/number_format.h"

namespace kerf {

enum class MeshFormat { kObj, kPly, kStl, kOff, kGlb, kGltf };

// What the formats are called, and what a file of one holds.
struct MeshFormatRow {
  MeshFormat format;
  std::string_view ending;  // of the names of files, without a dot
  std::string_view title;   // "OBJ"; both kinds of glTF files have one
  std::string_view a_file;  // "an OBJ mesh"
  std::string_view mime_type;
  bool single_precision;  // the positions
  bool materials;
};
// All formats that are read and written, in the order of MeshFormat.
inline constexpr std::array kMeshFormats{
    MeshFormatRow{MeshFormat::kObj, "obj", "OBJ", "an OBJ mesh", "model/obj", false, true},
    MeshFormatRow{MeshFormat::kPly, "ply", "PLY", "a PLY mesh", "application/x-ply", false, false},
    MeshFormatRow{MeshFormat::kStl, "stl", "STL", "an STL mesh", "model/stl", true, false},
    MeshFormatRow{MeshFormat::kOff, "off", "OFF", "an OFF mesh", "application/x-off", false, false},
    MeshFormatRow{MeshFormat::kGlb, "glb", "glTF", "a glTF file", "model/gltf-binary", true, true},
    MeshFormatRow{MeshFormat::kGltf, "gltf", "glTF", "a glTF file", "model/gltf+json", true, true}};

constexpr const MeshFormatRow& format_row(MeshFormat format) {
  return kMeshFormats[static_cast<size_t>(format)];
}

// The endings, each after `before`, and the titles, as a sentence lists them:
// ".obj, .ply, .stl, .off, .glb or .gltf" and "OBJ, PLY, STL, OFF or glTF".
std::string list_mesh_endings(std::string_view before = ".", std::string_view last = " or ");
std::string list_mesh_titles(std::string_view last = " or ");

// The format of a file name's extension in upper or lower case, with or without a leading dot; nothing for
// any other name.
std::optional<MeshFormat> mesh_format(std::string_view name);

// The format of a file, recognised by its bytes. Only if they fit no format (a damaged file) does `ending`,
// the extension of its name, decide, so that a reader can report what is wrong with it.
std::optional<MeshFormat> recognise_format(std::string_view bytes, std::string_view ending);

// The kind of a file, for an error message: "an OBJ mesh", "a PNG image", "a Kerf scene"; empty if its bytes
// are not known. Linear in the number of bytes, which it searches up to a mebibyte.
std::string_view kind_of_file(std::string_view bytes);

// The unit of the numbers in a mesh file.
enum class FileUnit { kMillimetre, kCentimetre, kMetre, kInch };

// The axis of a mesh file that points upwards. Both conventions are right-handed.
enum class UpAxis { kY, kZ };

// How the coordinates of a mesh file are to be understood. The files hold neither, so that both are guessed
// and may be changed by the user. They change only what is shown: positions stay as they were read.
struct FileFrame {
  FileUnit unit = FileUnit::kMetre;
  UpAxis up = UpAxis::kY;

  // Kerf's own convention, in which nothing is converted.
  bool is_default() const { return *this == FileFrame(); }
  friend bool operator==(const FileFrame&, const FileFrame&) = default;
};

// The unit and the upward axis that a file most probably has, from its format and the bounding box of its
// mesh in the numbers of the file. STL files usually come from CAD and 3D printing, in millimetres with +Z
// upwards; the other formats from modelling tools, games and research, in metres with +Y upwards, or in
// centimetres or millimetres where the mesh would be larger than a lorry. The format does not decide the axis
// if the mesh stands on exactly one of the planes y = 0 and z = 0: then that axis points upwards.
// Precondition: min <= max, and both are finite. Constant time.
FileFrame guess_frame(MeshFormat format, const Vec3& min, const Vec3& max);

// How many metres one unit is.
double metres_per_unit(FileUnit unit);

// "mm", "cm", "m" or "in".
std::string_view unit_symbol(FileUnit unit);

// Converts a direction or point into a frame in which +Y points upwards: (x, z, -y) for kZ. Exact.
Vec3 to_y_up(const Vec3& v, UpAxis up);
// The inverse of to_y_up().
Vec3 from_y_up(const Vec3& v, UpAxis up);
// The coordinate of v along the upward axis.
double height_of(const Vec3& v, UpAxis up);

// Lengths for people in the unit in which the open work is shown. They are given in the numbers of the file.

// "2.75 mm", "0.3 in", with three significant digits.
std::string length_label(double length, FileUnit unit);
// The unit of that label, with its size in the numbers of the file.
LengthUnit label_unit(double length, FileUnit unit);

}  // namespace kerf
