#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads the triangles of the default scene of a glTF 2.0 file, binary or text (Khronos Group, 2.0.1, 2021):
// all its nodes with their transforms, each a part of its name; strips and fans, too. Materials are told by
// name. Points and lines, images, normals and animations are passed over, and meshes with a skin or with
// morph targets are read as they were modelled, with a warning. Sparse and quantised positions, Draco and
// meshopt are refused by name. Buffers are data URIs or files in `folder` and below, the folder of the file;
// without one, none in other files are read. An index that is out of range is an invalid face. Linear in the
// number of bytes and of triangles of all nodes, of which there may be 10^8. `progress` may be null.
Result<Soup> read_gltf(std::string_view bytes, const std::string& file_name,
                       const Progress* progress = nullptr, const std::filesystem::path& folder = {});

}  // namespace kerf
