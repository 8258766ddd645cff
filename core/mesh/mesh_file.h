#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads an OBJ, PLY, STL, OFF, glTF or 3MF file, or a Kerf mesh (see read_soup). The content determines the
// format; the extension of the name is only a hint. Fails for anything but a regular file, for files of more
// than 4 GiB, and for errors of the format's reader, with one sentence that names the file and the line or
// byte; fails with cancelled() when stopped. `progress` may be null. Files may be read concurrently. Holds
// the whole file in memory in addition to the result. Linear in its size. Positions of formats that state no
// unit are in `unit` and are converted to metres.
Result<Soup> read_mesh(const std::filesystem::path& path, const Progress* progress = nullptr,
                       FileUnit unit = FileUnit::kMetre);

// Likewise for the bytes of a file, which may refer to no other files. `name`: begins the messages; `format`:
// a hint, the extension of a file name or empty. Throws std::bad_alloc.
Result<Soup> decode_mesh(std::string_view bytes, const std::string& name, const std::string& format,
                         const Progress* progress);

struct MeshReading {
  FileUnit unit = FileUnit::kMetre;  // see read_mesh
  bool keeps_corners = false;        // the mesh has looks even if the file has none (see Soup)
};

// Reads a mesh file with read_mesh and builds its mesh with build_mesh. The message of every failure but
// cancelled() names the file. `progress` may be null.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const Progress* progress,
                            const MeshReading& reading = {});

// Returns notes for the user about the faces of a file, the most important first: dropped faces, changed
// faces, consequences for cuts, and then the reader's warnings. Empty for a file without faults. Omits
// welding and dropped vertices, because they change no face.
std::vector<std::string> load_notes(const MeshReport& report);

// Returns only the notes about dropped faces.
std::vector<std::string> dropped_notes(const Repairs& repairs);

// Writes a mesh: OBJ and OFF as text, PLY, STL and GLB in binary. Positions are read back to the bit and
// triangles in the same order, except that STL stores positions in single precision and no shared vertices,
// glTF positions in single precision relative to the middle of the mesh and triangles by material, and 3MF
// millimetres in single precision; OBJ, glTF and 3MF store the names of materials. The file is written whole
// or not at all (see write_file_atomically). Fails with one sentence if it cannot be written or if the format
// cannot represent the mesh, e.g. coordinates beyond the range of float in STL. Holds all bytes in memory
// before writing. Linear time.
Status write_mesh(const MeshView& mesh, const std::filesystem::path& path, MeshFormat format);
// Returns the bytes that write_mesh writes, or an error for a mesh that the format cannot represent. Throws
// std::bad_alloc.
Result<std::string> encode_mesh(const MeshView& mesh, MeshFormat format);
// Writes several meshes like write_mesh, as nodes of glTF or objects of 3MF. Precondition:
// holds_several_meshes(format).
Status write_meshes(std::span<const MeshView> meshes, const std::filesystem::path& path, MeshFormat format);

// The loss of precision when a mesh is written in a single-precision format.
struct PrecisionLoss {
  double max_move = 0;       // of a vertex, m
  double shortest_edge = 0;  // non-zero, before rounding, m; 0 if there is none
  size_t merged = 0;         // vertices that coincide with one that had another position
  size_t vertices = 0;

  // Returns true if vertices coincide, or move by more than a tenth of the shortest edge.
  bool matters() const { return merged > 0 || max_move > 0.1 * shortest_edge; }
  // Adds the loss of another mesh.
  PrecisionLoss& operator+=(const PrecisionLoss& other);
};

// Measures the loss for positions as encode() writes them: relative to the origin in STL, to the middle of
// the mesh in glTF, to the origin in millimetres in 3MF. The other formats store doubles without loss.
// Precondition: the coordinates fit the format (see write_mesh). Expected linear time.
PrecisionLoss precision_loss(const MeshView& mesh, MeshFormat format);

// Formats a note for the user about meshes written in this format: "STL stores single precision: …". Returns
// nullopt if the loss does not matter. `advice` tells the user what to do instead.
std::optional<std::string> precision_note(const PrecisionLoss& loss, MeshFormat format,
                                          const std::string& advice);

}  // namespace kerf
