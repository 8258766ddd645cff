#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads a Wavefront OBJ file: the statements v, vt, vn, f, usemtl and mtllib, with indices that count from
// the first vertex or, if negative, back from the last one. Objects and groups become parts. Material
// libraries and their images are read from `folder`, the folder of the file, and below; if it is empty, no
// other files are read. Points, lines and free-form geometry are ignored with a warning, and so are UVs and
// normals that are malformed or missing. A backslash at the end of a line joins it with the next one, except
// in the names of o and usemtl. As in common readers, '#' begins a comment at the start of a line and after
// numbers, but is part of the names of o, g and usemtl, which extend to the end of the line. Vertex colours
// range to 1 or to 255 (see ColourNumbers). A face that refers to a missing vertex or has fewer than three
// corners is dropped and counted. A word in place of a number is an error. Linear in the number of bytes,
// except for large polygons (see Triangulator). `progress` may be null.
Result<Soup> read_obj(std::string_view bytes, const std::string& file_name, const Progress* progress,
                      const std::filesystem::path& folder);
// Likewise without other files.
Result<Soup> read_obj(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

// Returns true if the first word of a file is a keyword of Geomview's OFF family, from OFF and COFF to
// STCN4nOFF. A digit may follow it directly, because files without the line break there are common.
bool is_off_keyword(std::string_view word);

// Reads OFF, COFF, NOFF, STOFF and their combinations in text form, with comments, and with the counts on the
// line of the keyword or on the next one. Reads positions, vertex colours (see ColourNumbers) and faces;
// ignores, with a warning, normals, texture coordinates, numbers after the positions of plain OFF, and face
// colours. Rejects binary OFF and OFF in four or n dimensions. A face that refers to a missing vertex or has
// fewer than three corners is dropped and counted. Linear in the number of bytes, except for large polygons
// (see Triangulator). `progress` may be null.
Result<Soup> read_off(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

// Returns true if the bytes are exactly as long as a binary STL file with the declared number of triangles.
// No text of less than 8 GiB satisfies this.
bool is_exact_binary_stl(std::string_view bytes);

// Reads an STL file, binary or text: it is text if it starts with "solid" or "facet" and contains no zero
// byte. The result has three positions per triangle, which are not welded. Normals are ignored, and so are
// attributes, with a warning; several solids are joined into one soup. Keywords are case-insensitive.
// Accepted with a warning: in text, "end loop" or "end facet", solids that are not ended or ended twice,
// "endsolidNAME", and further lines between facets, although a facet itself must be complete; in binary, a
// wrong number of triangles, if the size of the file is that of whole triangles whose corners are finite, and
// other bytes after the last triangle. Linear in the number of bytes. `progress` may be null.
Result<Soup> read_stl(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

// Reads a PLY file, as text or binary in either byte order, with elements and properties of any type in any
// order. The properties x, y and z of "vertex" give positions; see also PlyLookProperties. Its other scalars
// are custom attributes in single precision, at most kMaxLookAttributes. The list
// vertex_indices (or vertex_index) of "face" gives a polygon, and "texcoord" the UVs of its corners; that of
// "tristrips" gives triangle strips, each ended by an index of -1, whose triangles count as faces. The image
// of the first comment "TextureFile" is read from `folder`, the folder of the file, or below, and gives the
// only material its name; if `folder` is empty, no other file is read. Everything else is ignored; further
// images and colours of faces, with a warning. A face that refers to a missing vertex or has fewer than three
// corners is dropped and counted. Linear in the number of bytes, except for large polygons (see
// Triangulator). `progress` may be null.
Result<Soup> read_ply(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr, const std::filesystem::path& folder = {});

// Reads the triangles of the default scene of a glTF 2.0 file, binary or text (Khronos Group, 2.0.1, 2021):
// all its nodes with their transforms, each a part with the name of the node; also strips and fans. Materials
// have names; they and their textures and samplers are kept as JSON, their images as bytes (see
// SurfaceLibrary). Reads normals, tangents, up to four sets of UVs and custom attributes, "_NAME". Ignores
// animations; with a warning, ignores other scenes, further UVs and colours and variants of materials, skips
// points and lines, and reads meshes with a skin or morph targets in their rest pose. Reads sparse accessors,
// quantised attributes (KHR_mesh_quantization) and instances, each a part with the name of its node
// (EXT_mesh_gpu_instancing). Rejects Draco, meshopt and other required extensions by name. Buffers and images
// are data URIs or files in `folder`, the folder of the file, and below; if it is empty, no other files are
// read. An index that is out of range makes an invalid face. Linear in the number of bytes and of triangles
// of all nodes and instances, at most 10^8, with at most 10^6 instances. `progress` may be null.
Result<Soup> read_gltf(std::string_view bytes, const std::string& file_name,
                       const Progress* progress = nullptr, const std::filesystem::path& folder = {});

// Reads the objects of the build of a 3MF file (3MF Consortium, core specification 1.2.3) with lib3mf, with
// their transforms and components, in metres. Each mesh is a part with the name of its object, or of an
// object that contains it. Base materials become materials with their colours; vertices with several colours
// become several positions. Textures and beam lattices are ignored. The content may have 4 GiB, 10^8
// triangles and 10^6 components. Linear in the uncompressed size and the number of triangles. `progress` may
// be null.
Result<Soup> read_3mf(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
