#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/byte_sink.h"
#include "core/base/vec3.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// A view of a triangle mesh that is to be written. The viewed arrays must outlive it.
struct MeshView {
  std::span<const Vec3> positions;                     // finite, metres
  std::span<const std::array<uint32_t, 3>> triangles;  // indices of positions, counter-clockwise
  std::span<const uint16_t> materials;                 // one per triangle, or empty
  std::span<const std::string> material_names;  // by material; covers every material that a triangle has
  std::string_view mtl{};   // name of the MTL file beside it, on one line; empty: none. Only for OBJ
  std::string_view name{};  // of the node in glTF; empty: none
  std::span<const VertexColour> colours{};  // one per position, or empty. Not for STL

  // Whether the opacities of the colours have to be written.
  bool any_translucent() const;
};

// A part of a colour in the eight bits of PLY and OFF, rounded.
inline uint8_t eight_bits(uint16_t part) { return static_cast<uint8_t>((part + 128u) / 257u); }

// Encodes a mesh as the bytes of a file. Positions and triangles keep their order and are read back to the
// bit, except from STL, which stores three positions in single precision per triangle, and from glTF.
// Precondition: the mesh satisfies the requirements stated at MeshView and at its format below. Linear time;
// holds a few megabytes.
void encode(const MeshView& mesh, MeshFormat format, const ByteSink& sink);
// Encodes a mesh as one string, with the preconditions of encode().
std::string encoded(const MeshView& mesh, MeshFormat format);

// OBJ with the shortest decimal numbers that are read back exactly, a mtllib if the mesh has an MTL file, and
// a usemtl wherever the material changes. Colours follow the coordinates as three fractions, and a fourth if
// any is not opaque.
void encode_obj(const MeshView& mesh, const ByteSink& sink);
// OFF with numbers of the same kind, or COFF with colours and opacities of eight bits; without materials.
void encode_off(const MeshView& mesh, const ByteSink& sink);
// Little-endian binary PLY with positions in double precision and colours of eight bits, with opacity if any
// is not opaque; without materials. Precondition: there are at
// most 2^31 positions.
void encode_ply(const MeshView& mesh, const ByteSink& sink);
// Binary STL with positions rounded to single precision and unit normals computed from the corners; without
// materials. Preconditions: positions are within the range of float, and there are fewer than 2^32 triangles.
void encode_stl(const MeshView& mesh, const ByteSink& sink);

// Binary glTF 2.0: one node with the name, with a primitive for each material that triangles have, and the
// triangles of the primitives one after the other. Positions are rounded to single precision relative to the
// middle of the mesh, and colours to 16 bits of linear light. Preconditions: the extent is within the range
// of float, and the bytes are fewer than 2^32.
void encode_glb(const MeshView& mesh, const ByteSink& sink);
// The same as text, with the numbers in base 64. Same preconditions.
void encode_gltf(const MeshView& mesh, const ByteSink& sink);
// The middle of the bounding box of positions, about which glTF holds them; zero if there are none.
Vec3 gltf_middle(std::span<const Vec3> positions);

}  // namespace kerf
