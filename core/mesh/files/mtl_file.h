#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/files/surfaces.h"

namespace kerf {

// A material of an OBJ library. MtlLine::image is an index of MtlFile::references.
struct MtlEntry {
  std::string name;
  std::vector<MtlLine> lines;
};
struct MtlFile {
  std::vector<MtlEntry> materials;      // in their order; names may repeat
  std::vector<std::string> references;  // to images, as written
};

// Parses a material library (MTL). Every line after newmtl is kept verbatim, without surrounding blanks; a
// reference to an image is the rest of a line after the keyword and its options. Accepts any bytes. Linear.
MtlFile parse_mtl(std::string_view text);

// Returns the folder to which a reference in a library of an OBJ file is relative (see side_file): that of
// the OBJ file, or that of the library if only the latter has the image.
std::filesystem::path image_folder(const std::filesystem::path& folder, const std::filesystem::path& mtl,
                                   std::string_view reference);

// Reads the libraries of an OBJ file from its folder (see read_side_file), and the images of the materials of
// these names (see image_folder). Appends warnings about missing files. Returns null if no library is found.
std::shared_ptr<const SurfaceLibrary> read_mtl_surfaces(const std::filesystem::path& folder,
                                                        std::span<const std::string> libraries,
                                                        std::span<const std::string> material_names,
                                                        std::vector<std::string>& warnings);

// Different statements mtllib of a file that are read; the reader ignores others.
inline constexpr size_t kMaxLibraries = 64;

// Returns the libraries of an OBJ file and the images that they name, as far as they exist. Reads the lines
// of the file up to its last library that the reader does not ignore.
std::vector<std::filesystem::path> files_of_obj(const std::filesystem::path& file);

// Reads an image that a file in this folder refers to (see read_side_file). If it cannot be read, its bytes
// are empty, and a warning is appended.
SurfaceImage read_image(const std::filesystem::path& folder, const std::string& reference,
                        std::vector<std::string>& warnings);

// Returns the MIME type of an image by its first bytes, else by the extension of its name; empty if unknown.
std::string image_mime_type(std::string_view bytes, std::string_view name);

}  // namespace kerf
