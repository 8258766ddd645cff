#pragma once

#include <optional>
#include <string_view>

namespace kerf {

enum class MeshFormat { kObj, kPly, kStl, kOff };

// "obj", "ply", "stl" or "off", in any case and with or without a leading dot; nothing for any other name.
std::optional<MeshFormat> mesh_format(std::string_view name);

// The name as mesh_format() takes it.
std::string_view format_name(MeshFormat format);

// The format that the bytes of a file are in. Content decides; the ending of the file's name is asked only
// where the content could be anything (a damaged file, so that the reader can say what is wrong with it).
std::optional<MeshFormat> recognise_format(std::string_view bytes, std::string_view ending);

}  // namespace kerf
