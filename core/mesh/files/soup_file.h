#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Kerf's own mesh file (.kmesh), for meshes that are saved and read back by Kerf only. Unlike the other
// formats it keeps everything to the bit: positions in double precision, the order of vertices and triangles,
// vertex colours, UVs, normals, tangents, custom attributes, materials, images and parts.
inline constexpr std::string_view kSoupFileEnding = "kmesh";

// Encodes a soup, except for its counts of the file that it was read from, and warnings. Linear time.
std::string encode_soup(const Soup& soup);

// Returns true if the bytes begin like those of encode_soup().
bool is_soup_file(std::string_view bytes);

// Decodes the bytes of encode_soup(). Fails with bad input, one sentence that names the file, for any other
// bytes, a newer format and a file without triangles; every index of the result is in range. Linear time.
Result<Soup> read_soup(std::string_view bytes, const std::string& file_name);

}  // namespace kerf
