#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/result.h"

namespace kerf {

// A pair of lines of a DXF file: a code that gives the meaning, and a value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  // without surrounding blanks
  size_t line = 0;         // of the value, counted from 1
};

// An entity: its groups, of which the first has code 0 and names its type.
class DxfEntity {
 public:
  // Precondition: groups is not empty. `file` names the file in errors; both must outlive the entity.
  DxfEntity(std::span<const DxfGroup> groups, const std::string& file) : groups_(groups), file_(&file) {
    KERF_ASSERT(!groups.empty());
  }

  std::string_view type() const { return groups_.front().value; }
  std::span<const DxfGroup> groups() const { return groups_; }
  // Returns the first value with this code; empty if there is none.
  std::string_view text(int code) const;
  bool has(int code) const;

  // Parse the first value with the code, or the value of a group. Fail for a value that is no finite number
  // of at most 1e15; return `missing` if there is none.
  Result<double> number(int code, double missing) const;
  Result<double> number(const DxfGroup& group) const;
  // Parses a whole number, for flags and counts.
  Result<int> whole(int code, int missing) const;
  // Parses the numbers with the codes x and x + 10.
  Result<Vec2> point(int x) const;
  // Parses the points with the codes x and x + 10, in the order of the file.
  Result<std::vector<Vec2>> points(int x) const;
  // Parses all numbers with the code.
  Result<std::vector<double>> numbers(int code) const;

  // "FILE, line 3, column 1: WHAT", for the entity.
  Error wrong(const std::string& what) const;

 private:
  std::span<const DxfGroup> groups_;
  const std::string* file_;
};

struct DxfBlock {
  Vec2 base{0};  // in units of the file
  std::vector<DxfEntity> entities;
};

// The parts of a DXF file that draw. Views into the text that it was read from.
struct DxfFile {
  std::string name;
  std::vector<DxfGroup> groups;
  double unit = 0.001;                            // m
  std::map<std::string_view, bool> hidden_layer;  // true for those that are frozen or off
  std::map<std::string_view, DxfBlock> blocks;
  std::vector<DxfEntity> entities;
};

// Splits the text of a DXF file. Fails if it is binary, is not made of group codes and values, or ends before
// EOF. `result` is filled in place, because its entities refer to its name and groups.
Status split_dxf(std::string_view text, const std::string& file, DxfFile& result);

}  // namespace kerf
