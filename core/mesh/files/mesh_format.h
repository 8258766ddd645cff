#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace kerf
