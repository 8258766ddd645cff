#pragma once

#include <optional>
#include <string_view>

namespace kerf {

enum class MeshFormat { kObj, kPly, kStl, kOff, kGlb, kGltf };

// The format of a file name's extension: "obj", "ply", "stl", "off", "glb" or "gltf" in upper or lower case,
// with or without a leading dot; nothing for any other name.
std::optional<MeshFormat> mesh_format(std::string_view name);

// The lower-case name of a format, without a dot.
std::string_view format_name(MeshFormat format);

// The format of a file, recognised by its bytes. Only if they fit no format (a damaged file) does `ending`,
// the extension of its name, decide, so that a reader can report what is wrong with it.
std::optional<MeshFormat> recognise_format(std::string_view bytes, std::string_view ending);

// The kind of a file, for an error message: "an OBJ mesh", "a PNG image", "a Kerf scene"; empty if its bytes
// are not known. Linear in the number of bytes, which it searches up to a mebibyte.
std::string_view kind_of_file(std::string_view bytes);

}  // namespace kerf
