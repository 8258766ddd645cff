#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"

namespace kerf {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kInt64, kUint64, kFloat32, kFloat64 };

size_t byte_size(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;   // of the value, or of each value of a list
  std::optional<PlyType> count_type;  // of a list, an integer type
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;  // as declared; no more than the bytes after the header can hold
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;   // in the order of the data, with distinct names
  std::string texture_file;           // of the first comment "TextureFile"; empty if there is none
  size_t textures = 0;                // comments "TextureFile"
  std::vector<std::string> warnings;  // a sentence each, for the load report
};

// Reads the header of a PLY file (G. Turk, The PLY polygon file format, 1994) and leaves the scanner at the
// first byte of the data. Skips comments and obj_info, and also, with a warning, unknown lines of text before
// the first element. Any other unknown line is an error, which leaves the scanner within the header.
Result<PlyHeader> read_ply_header(Scanner& scanner);

// Fast readers of large binary PLY files, for elements of the usual layout whose rows all have the same
// number of bytes. They return nullopt for other layouts, which the general reader must handle.

// A column of values, and its size in bytes.
template <typename T>
struct PlyRows {
  std::vector<T> values;
  size_t bytes = 0;
};

// Returns the indices of red, green, blue and opacity among the properties of a vertex. Returns nullopt if
// one of the first three is missing; a missing opacity is kNoProperty. Opacity is "alpha"; names may start
// with "diffuse_".
inline constexpr size_t kNoProperty = ~size_t{0};
std::optional<std::array<size_t, 4>> colour_properties_of(const PlyElement& element);

// Likewise for the normal, "nx", "ny" and "nz", and for the UVs, "s" and "t", "u" and "v" or "texture_u" and
// "texture_v". Either is kNoProperty if one of its names is missing. The first scalars that are none of
// these, nor a part of the position or the colour, are custom attributes.
struct PlyLookProperties {
  std::array<size_t, 3> normal{kNoProperty, kNoProperty, kNoProperty};
  std::array<size_t, 2> uv{kNoProperty, kNoProperty};
  std::vector<size_t> attributes{};
  size_t ignored = 0;  // scalars beyond the limit of attributes
};
PlyLookProperties look_properties_of(const PlyElement& element);

// Positions and looks from little-endian rows of scalars; `bytes` starts at the first row. x, y and z must be
// all floats or all doubles, colours numbers of eight bits, and normals and UVs floats. Multithreaded.
struct PlyVertices {
  std::vector<Vec3> positions;
  std::vector<VertexColour> colours;  // one per position, or empty if there are none, as are the next two
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<std::vector<float>> attributes;  // by attribute, then one per position
};
struct PlyVertexRows {
  PlyVertices values;
  size_t bytes = 0;
};
std::optional<PlyVertexRows> read_vertex_rows(const PlyElement& element, std::string_view bytes);

// Reads triangles from little-endian rows with one list, whose length is a uchar and is 3 in every row and
// whose corners are ints. A corner that is no index becomes one that is out of range. Multithreaded.
std::optional<PlyRows<Soup::Triangle>> read_triangle_rows(const PlyElement& element, std::string_view bytes);

// Readers of the values of a PLY file, one for text and one for binary data, with the same interface. number,
// integer and skip return false if a value is missing or is not a number; missing() then creates the error.

// Values as text.
class PlyTextValues {
 public:
  explicit PlyTextValues(Scanner& scanner) : scanner_(scanner) {}

  bool number(PlyType type, double& value);
  bool integer(PlyType type, int64_t& value);
  bool skip(PlyType type, uint64_t count);
  // Returns true if the rest of the file is long enough for `count` values.
  bool can_hold(PlyType, uint64_t count) const { return count <= scanner_.left(); }
  // All vertices or triangles of an element in the usual binary layout; none in text.
  std::optional<PlyVertices> vertices(const PlyElement&) { return std::nullopt; }
  std::optional<std::vector<Soup::Triangle>> triangles(const PlyElement&) { return std::nullopt; }
  // Ends an element. Returns false if its line has further values.
  bool end_element();
  Error error(const std::string& what) const { return scanner_.line_error(what); }
  Error missing(const std::string& what) const { return scanner_.expected(what); }

 private:
  Scanner& scanner_;
};

// Values as bytes in the given order.
class PlyBinaryValues {
 public:
  PlyBinaryValues(Scanner& scanner, std::endian order) : scanner_(scanner), order_(order) {}

  bool number(PlyType type, double& value);
  bool integer(PlyType type, int64_t& value);
  bool skip(PlyType type, uint64_t count);
  bool can_hold(PlyType type, uint64_t count) const { return count <= scanner_.left() / byte_size(type); }
  std::optional<PlyVertices> vertices(const PlyElement& element);
  std::optional<std::vector<Soup::Triangle>> triangles(const PlyElement& element);
  bool end_element() { return true; }
  Error error(const std::string& what) const { return scanner_.byte_error(what); }
  Error missing(const std::string& what) const;

 private:
  Scanner& scanner_;
  std::endian order_;
};

}  // namespace kerf
