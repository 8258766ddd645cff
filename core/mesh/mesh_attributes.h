#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// Identifies one column of FaceColumns, i.e. one value of type T per face of a mesh. Also valid for copies of
// the mesh and for meshes extracted from it.
template <typename T>
class FaceColumn {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(uint64_t));

 public:
  FaceColumn() = default;  // identifies no column
  bool valid() const { return index_ != kNone; }

 private:
  friend class FaceColumns;
  static constexpr uint32_t kNone = 0xffffffffu;
  explicit FaceColumn(uint32_t index) : index_(index) {}
  uint32_t index_ = kNone;
};

// Values of the faces of a mesh that its clients attach (FaceData holds the data that every mesh needs). All
// edits of the mesh keep them up to date:
//
//   split    the parts of a face copy its value, or share it by area, so that the sum is preserved;
//   flip     two faces whose common edge is flipped keep their values, or share their sum by area;
//   move     values stay with the faces when a vertex moves;
//   remove   the value of a removed face becomes T();
//   copy     extract_mesh and copies of the mesh have the same columns with the same values;
//   undo     the columns are a part of Mesh::Change.
//
// A value is T(), all bits zero, until it is set. A mesh without any set value has no overhead, and a column
// takes memory up to the last face whose value was set.
class FaceColumns {
 public:
  // Attaches a column whose values are copied to the parts of a split face. Precondition: no change is open.
  template <typename T>
  FaceColumn<T> attach_copied() {
    return FaceColumn<T>(attach(Rule::kCopy));
  }
  // Attaches a column for a quantity shared by area, such as an energy in joules. Same precondition.
  FaceColumn<double> attach_shared_by_area() { return FaceColumn<double>(attach(Rule::kShareByArea)); }

  // Returns true if no value of any column was ever set.
  bool blank() const;

  template <typename T>
  T get(FaceColumn<T> column, FaceId f) const {
    assert(column.index_ < columns_.size());
    return from_cell<T>(columns_[column.index_].get(f));
  }
  template <typename T>
  void set(FaceColumn<T> column, FaceId f, const T& value) {
    assert(column.index_ < columns_.size() && f.valid());
    columns_[column.index_].set(f, to_cell(value));
  }

  // Calls visit(f) for the faces whose value in the column is not T(), ascending; `visit` may set their
  // values. O(these faces + faces / kBlock), but up to kBlock times the faces found if they are scattered.
  template <typename T, typename Visit>
  void for_each_set(FaceColumn<T> column, Visit visit) const {
    assert(column.index_ < columns_.size());
    const Column& own = columns_[column.index_];
    for (uint32_t block = 0; block < own.filled.size(); ++block) {
      if (own.filled[block] == 0) continue;
      const uint32_t end = std::min(own.cells.size(), (block + 1) * kBlock);
      for (uint32_t f = block * kBlock; f < end; ++f) {
        if (own.cells[f] != 0) visit(FaceId(f));
      }
    }
  }

  // Returns true if any face has a value that is not T(). O(faces / kBlock).
  template <typename T>
  bool any_set(FaceColumn<T> column) const {
    assert(column.index_ < columns_.size());
    const Records<uint32_t>& filled = columns_[column.index_].filled;
    for (uint32_t block = 0; block < filled.size(); ++block) {
      if (filled[block] != 0) return true;
    }
    return false;
  }

  // Returns the columns for a mesh that consists of these faces, in their order.
  FaceColumns extract(std::span<const FaceId> faces) const;

  size_t bytes() const;

  // The columns before a command; see ChangeOf.
  class Change;

 private:
  friend class Mesh;
  enum class Rule : uint8_t { kCopy, kShareByArea };

  static constexpr uint32_t kBlock = 1024;  // faces

  // The bits of the values, whatever their type; zero beyond the last one.
  struct Column {
    Rule rule;
    Records<uint64_t> cells;
    Records<uint32_t> filled;  // by block of kBlock faces: the number of its non-zero cells

    uint64_t get(FaceId f) const { return f.index < cells.size() ? cells[f.index] : 0; }
    void set(FaceId f, uint64_t cell);
    // Divides the sum of the values of two faces between them; `share` is the fraction of the first one.
    void share_sum(FaceId a, FaceId b, double share);

    template <typename Self>
    static auto parts(Self& self) {
      return std::tie(self.cells, self.filled);
    }
  };

  template <typename T>
  static T from_cell(uint64_t cell) {
    T value;
    std::memcpy(&value, &cell, sizeof(T));
    return value;
  }
  template <typename T>
  static uint64_t to_cell(const T& value) {
    uint64_t cell = 0;
    std::memcpy(&cell, &value, sizeof(T));
    return cell;
  }

  uint32_t attach(Rule rule);

  // Called by the mesh. `share` is the fraction of the first face in the area of both, 0 .. 1.
  void record_split(FaceId kept, FaceId added, double share);
  void record_flipped(FaceId a, FaceId b, double share);
  void record_removed(FaceId f);

  std::vector<Column> columns_;
};

class FaceColumns::Change {
 public:
  void begin(FaceColumns& columns);
  void end(FaceColumns& columns);
  bool any() const;
  void exchange(FaceColumns& columns);
  void restore(FaceColumns& columns) const;
  size_t bytes() const;

 private:
  std::vector<ChangeOfParts<Column>> changes_;  // by column
};

// The colours of the vertices of a mesh, kept up to date by its edits: a vertex that splits an edge gets the
// interpolated colour of its ends, a moved vertex keeps its own, and copies, extracts and Mesh::Change
// include colours. They are not part of the state of a world (see state_hash). A mesh without colours has no
// overhead; otherwise vertices whose colour was not set are white and opaque.
class VertexColours {
 public:
  // Returns true if no colour was ever set.
  bool blank() const { return cells_.empty(); }
  VertexColour get(VertexId v) const { return v.index < cells_.size() ? cells_[v.index] : VertexColour(); }
  void set(VertexId v, const VertexColour& colour);

  // The colours before a command; see ChangeOf.
  class Change;

 private:
  friend class ChangeOfParts<VertexColours>;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.cells_);
  }

  Records<VertexColour> cells_;  // up to the last vertex whose colour was set
};

class VertexColours::Change : public ChangeOfParts<VertexColours> {};

}  // namespace kerf
