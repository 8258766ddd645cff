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
  uint64_t count = 0;  // as announced; no more than the bytes after the header can hold
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;   // in the order of the data, each name once
  std::vector<std::string> warnings;  // a sentence each, for the load report
};

// Reads the header of a PLY file (G. Turk, The PLY polygon file format, 1994) and leaves the scanner at the
// first byte of the data. Comments and obj_info are passed over, and so are lines of text before the first
// element that the format does not know, with a warning. Any other line that the format does not know is an
// error, and the scanner is then left within the header.
Result<PlyHeader> read_ply_header(Scanner& scanner);

// A fast way through large binary PLY files, for elements of the usual kind whose rows all have the same
// number of bytes. Where the rows are of another kind, nothing is returned and the general reader must be
// used.

// A column of values and the number of bytes that it takes.
template <typename T>
struct PlyRows {
  std::vector<T> values;
  size_t bytes = 0;
};

// The places of red, green, blue and opacity among the properties of a vertex. Nothing if one of the first
// three is missing; the last one may be, and is kNoProperty then. Opacity is called alpha, and a name may
// start with "diffuse_".
inline constexpr size_t kNoProperty = ~size_t{0};
std::optional<std::array<size_t, 4>> colour_properties_of(const PlyElement& element);

// Positions from little-endian rows of scalars; `bytes` starts at the first row. x, y and z must all be
// floats or all doubles, and colours numbers of eight bits. On several threads.
struct PlyVertices {
  std::vector<Vec3> positions;
  std::vector<VertexColour> colours;  // one per position, or empty if there are none
};
struct PlyVertexRows {
  PlyVertices values;
  size_t bytes = 0;
};
std::optional<PlyVertexRows> read_vertex_rows(const PlyElement& element, std::string_view bytes);

// Triangles from little-endian rows with one list, whose length is a uchar and is 3 in every row and whose
// corners are ints. A corner that is no index becomes one that is out of range. On several threads.
std::optional<PlyRows<Soup::Triangle>> read_triangle_rows(const PlyElement& element, std::string_view bytes);

// Readers for the values of a PLY file, one for text and one for binary data, with the same interface.
// number, integer and skip return false if a value is missing or is not a number; missing() then makes the
// error.

// Values as text.
class PlyTextValues {
 public:
  explicit PlyTextValues(Scanner& scanner) : scanner_(scanner) {}

  bool number(PlyType type, double& value);
  bool integer(PlyType type, int64_t& value);
  bool skip(PlyType type, uint64_t count);
  // Whether the rest of the file is long enough for `count` values.
  bool can_hold(PlyType, uint64_t count) const { return count <= scanner_.left(); }
  // All vertices or triangles of an element whose rows are of the usual binary kind; see ply_rows.h.
  std::optional<PlyVertices> vertices(const PlyElement&) { return std::nullopt; }
  std::optional<std::vector<Soup::Triangle>> triangles(const PlyElement&) { return std::nullopt; }
  // Ends an element. Returns false if its line holds further values.
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
