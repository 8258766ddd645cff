#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>

#include "core/mesh/files/ply_header.h"
#include "core/mesh/files/scanner.h"

namespace kerf {

// The values of a PLY file in the order of the data, as text or as bytes. Both classes have the same
// functions; those that return a bool return false when the value is not there or is no number, and error()
// says why.

class PlyTextValues {
 public:
  explicit PlyTextValues(Scanner& scanner) : scanner_(scanner) {}

  bool number(PlyType type, double& value);
  bool integer(PlyType type, int64_t& value);
  bool skip(PlyType type, uint64_t count);
  // Whether so many values can be there at all.
  bool can_hold(PlyType, uint64_t count) const { return count <= scanner_.left(); }
  // An element of text ends with its line.
  bool end_element();
  Error error(const std::string& what) const { return scanner_.line_error(what); }
  Error missing(const std::string& what) const { return scanner_.expected(what); }

 private:
  Scanner& scanner_;
};

class PlyBinaryValues {
 public:
  PlyBinaryValues(Scanner& scanner, std::endian order) : scanner_(scanner), order_(order) {}

  bool number(PlyType type, double& value);
  bool integer(PlyType type, int64_t& value);
  bool skip(PlyType type, uint64_t count);
  bool can_hold(PlyType type, uint64_t count) const { return count <= scanner_.left() / byte_size(type); }
  bool end_element() { return true; }
  Error error(const std::string& what) const { return scanner_.byte_error(what); }
  Error missing(const std::string& what) const;

 private:
  Scanner& scanner_;
  std::endian order_;
};

}  // namespace kerf
