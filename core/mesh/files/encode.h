#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/platform.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/surfaces.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// A convex hull around a mesh and its mass properties, for physics engines. In the coordinates of the mesh.
struct NodeCollider {
  std::string name;  // of its node
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;  // none: only the mass properties are written
  double mass = 0;                                 // kg
  Vec3 centre_of_mass{0};                          // m
  std::array<double, 6> inertia{};                 // kg m^2, about the centre of mass: xx, yy, zz, xy, xz, yz
};

// A view of a triangle mesh to be written. The viewed arrays must outlive it.
struct MeshView {
  std::span<const Vec3> positions;                     // finite, metres
  std::span<const std::array<uint32_t, 3>> triangles;  // indices of positions, counter-clockwise
  std::span<const uint16_t> materials;                 // one per triangle, or empty
  std::span<const std::string> material_names;         // by material; covers every material of a triangle
  std::string_view mtl{};   // name of the MTL file in the same folder, on one line; empty: none. Only for OBJ
  std::string_view name{};  // of the node in glTF and of the object in 3MF; empty: none
  std::span<const VertexColour> colours{};   // one per position, or empty. Not for STL
  const CornerLooks* looks = nullptr;        // of the triangles; null: none. For OBJ, PLY, glTF
  const SurfaceLibrary* surfaces = nullptr;  // describes the materials; null: none. For glTF and 3MF
  std::string_view object{};                 // name of the object in OBJ, on one line; empty: none
  const NodeCollider* collider = nullptr;    // null: none. For glTF

  // Returns true if the opacities of the colours must be written.
  bool any_translucent() const;
};

// Returns a component of a colour in the eight bits of PLY and OFF, rounded.
inline uint8_t eight_bits(uint16_t part) { return static_cast<uint8_t>((part + 128u) / 257u); }

// Encodes a mesh as the bytes of a file. Positions and triangles keep their order and are read back to the
// bit, except from STL, which stores three positions in single precision per triangle, and from glTF.
// Precondition: the mesh satisfies the requirements of MeshView and its format. Linear time; uses a few
// megabytes.
void encode(const MeshView& mesh, MeshFormat format, const ByteSink& sink);
// Likewise as one string.
std::string encoded(const MeshView& mesh, MeshFormat format);

// OBJ with the shortest decimal numbers that are read back exactly, a mtllib if the mesh has an MTL file, the
// first set of UVs and the normals, and a usemtl at each change of the material. Colours follow the
// coordinates as three fractions, four if any is not opaque.
void encode_obj(const MeshView& mesh, const ByteSink& sink);
// OFF with numbers likewise, or COFF with colours and opacities of eight bits; without materials.
void encode_off(const MeshView& mesh, const ByteSink& sink);
// Little-endian binary PLY with positions in double precision, colours of eight bits, with opacity if any is
// not opaque, the normals, the first set of UVs and custom attributes as floats, those of vectors as NAME_x
// and so on; without materials. With looks, vertices are separate as in glTF. Precondition: there are at most
// 2^31 positions. Properties have distinct names, see distinct_names().
void encode_ply(const MeshView& mesh, const ByteSink& sink);
// Binary STL with positions rounded to single precision and unit normals computed from the corners; without
// materials. Preconditions: positions are within the range of float, and there are fewer than 2^32 triangles.
void encode_stl(const MeshView& mesh, const ByteSink& sink);

// Binary glTF 2.0: a node a mesh with its name, with a primitive for each material in use; the triangles of
// the primitives follow one another. Positions are rounded to single precision relative to the middle of the
// mesh, and colours to 16 bits of linear light. Vertices with different looks are separate. Only the kinds of
// looks of the mesh are written; faces without UVs get zeros, faces without normals their own. Normals get
// unit length. Tangents and custom attributes, "_NAME" with distinct names, are floats. Materials have the
// surfaces, whose images are embedded byte for byte; meshes share them. A collider is a node after that of
// its mesh, at the same place; the mass properties become extras of the node of the mesh, relative to its
// origin. Preconditions: the extent is within the range of float, and the file has fewer than 2^32 bytes.
void encode_glb(std::span<const MeshView> meshes, const ByteSink& sink);
// Text glTF with the numbers in base 64. Same preconditions.
void encode_gltf(std::span<const MeshView> meshes, const ByteSink& sink);
// 3MF in millimetres in single precision with six decimal places: an object and an item of the build a mesh,
// with its name, and its colours or, without any, its materials with the colours of their surfaces; meshes
// share these. The same meshes give the same bytes. Holds the whole file in memory; throws std::bad_alloc.
// Preconditions: there are triangles in each mesh, each with three different corners, and no coordinate is
// beyond kMaxThreeMf.
void encode_3mf(std::span<const MeshView> meshes, const ByteSink& sink);
inline constexpr double kMaxThreeMf = 1e6;  // m
// Returns a position as 3MF stores it, in millimetres in single precision with six decimal places, in metres.
// Precondition: no coordinate is beyond kMaxThreeMf.
Vec3 three_mf_position(const Vec3& p);

// Returns the triangles of a mesh in their order in glTF, by material.
std::vector<uint32_t> gltf_order(const MeshView& mesh);
// Returns the middle of the bounding box, relative to which glTF stores positions; zero without any.
Vec3 gltf_middle(std::span<const Vec3> positions);

// Returns the unit normal of a triangle, zero if it is degenerate.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c);

// A material of an OBJ file, as described by its library (MTL).
struct MaterialLook {
  std::string name;  // as in usemtl; empty: the unnamed material, which OBJ calls "default"
  Vec3 colour{0};    // sRGB, 0 .. 1
  double gloss = 0;  // 0 matt .. 1 polished
};

// Encodes a library of materials: the colour as Kd, and the gloss as Ks and as the exponent Ns, 0 .. 1000.
// Numbers are the shortest that are read back exactly. Linear time.
std::string encode_mtl(std::span<const MaterialLook> materials);

// Makes names distinct: each that equals an earlier one gets the lowest number that makes it a new name, such
// as "NAME_2". O(n log n) without equal names.
std::vector<std::string> distinct_names(std::vector<std::string> names);

// Passes the bytes of many items to a sink in order. encode(first, end, part) appends those of a range of
// items; a limited number of ranges is encoded concurrently and held in memory. Returns false if the sink
// did.
bool emit_ranges(size_t items, const ByteSink& sink,
                 const std::function<void(size_t first, size_t end, std::string& part)>& encode);

}  // namespace kerf
