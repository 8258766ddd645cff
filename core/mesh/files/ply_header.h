#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/files/scanner.h"

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

}  // namespace kerf
