#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/files/ply_header.h"
#include "core/mesh/files/ply_rows.h"
#include "core/mesh/files/scanner.h"

namespace kerf {

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
