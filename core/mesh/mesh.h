#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/base/geometry.h"
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

// Values per face that clients attach to a mesh; FaceData holds the data that every mesh needs. All edits of
// the mesh keep them up to date:
//
//   split    the parts of a face copy its value, or share it by area, so that the sum is preserved;
//   flip     two faces whose common edge is flipped keep their values, or share their sum by area;
//   move     values stay with the faces when a vertex moves;
//   remove   the value of a removed face becomes T();
//   copy     extract_mesh and copies of the mesh have the same columns with the same values;
//   undo     the columns are a part of Mesh::Change.
//
// A value is T(), all bits zero, until it is set. A mesh in which no value was set has no overhead; a column
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
  // values. O(visited faces + faces / kBlock) if the visited faces are contiguous, up to kBlock per visited
  // face if they are scattered.
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

using Triangle = std::array<Vec3, 3>;

// Area (m^2), accurate for edges of 1e-150 to 1e150 m.
double triangle_area(const Triangle& t);
// Squared length of the longest edge (m^2).
double longest_edge2(const Triangle& t);
// Cosine of the smallest interior angle, i.e. the largest of the three cosines; 1 for a degenerate triangle.
double largest_cosine(const Triangle& t);

// Data of a face. When a face is split, each part gets a copy.
struct FaceData {
  static constexpr uint32_t kNoElement = 0xffffffffu;

  FaceId base;                    // loaded face that contains this one
  uint32_t element = kNoElement;  // green element that contains it as a half (see OneToFour)
  uint32_t piece = 0;             // label of its piece
  uint16_t material = 0;
  uint8_t halvings =
      0;             // number of times the area of the base face was halved; a split into four counts as two
  bool hit = false;  // its bounding box is or was hit by the beam; for display
};

// Direct access to the positions of vertices. Valid until the mesh is edited.
class Positions {
 public:
  static constexpr uint32_t kShift = Records<Vec3>::kShift;

  explicit Positions(const Vec3* const* chunks) : chunks_(chunks) {}
  const Vec3& operator[](VertexId v) const { return (*this)[v.index]; }
  const Vec3& operator[](uint32_t v) const { return chunks_[v >> kShift][v & ((uint32_t{1} << kShift) - 1)]; }
  const Vec3* const* chunks() const { return chunks_; }

 private:
  const Vec3* const* chunks_;
};

// A conforming triangle mesh of half-edges.
//
// Conforming means that two faces share an edge, a corner or nothing, and that splitting an edge splits all
// faces on it. A half-edge structure stores at most two faces per edge. If three or more faces meet, or two
// that cannot be oriented consistently, each closed shell has an edge of its own for its two faces, and each
// other face one for itself (see pair_sides.h). These coincident edges are linked in a *ring*. Faces that
// coincide corner by corner are linked along all their edges and are always split together. Adjacency
// includes rings: two faces are neighbours if they share an edge by position.
//
// Vertices belong to sheets: if sheets touch in a vertex or a ring, each sheet has its own vertex at a
// bit-equal position. The numbers of face and vertex slots never decrease; a removed face keeps its slot,
// which is marked dead.
//
// Growing never moves existing data, and changes can be undone (see Records).
class Mesh {
 public:
  Mesh();
  ~Mesh();
  Mesh(Mesh&&) noexcept;
  Mesh& operator=(Mesh&&) noexcept;
  Mesh(const Mesh&);
  Mesh& operator=(const Mesh&);

  uint32_t face_slots() const;
  uint32_t vertex_slots() const;
  uint32_t edge_slots() const;
  uint32_t live_faces() const;
  bool is_live(FaceId f) const;  // false if the slot does not exist

  Vec3 position(VertexId v) const;
  // The corners of a face, counter-clockwise; edits of adjacent faces may change which corner is first.
  // Precondition of corners, has_side, triangle, data and edit_data: the face is live.
  std::array<VertexId, 3> corners(FaceId f) const;
  bool has_side(FaceId f, VertexId from, VertexId to) const;  // counter-clockwise
  Triangle triangle(FaceId f) const;
  // All positions, for callers that need many of them. Valid until the mesh is edited.
  Positions positions() const;

  const FaceData& data(FaceId f) const;
  FaceData& edit_data(FaceId f);

  // Values attached to the faces (see FaceColumns).
  const FaceColumns& columns() const;
  FaceColumns& columns();

  // Colours of the vertices (see VertexColours).
  const VertexColours& colours() const;
  VertexColours& colours();

  // Appends every other live face that shares an edge with f, including over rings; twice if it shares two
  // edges. Precondition: f is live. Linear in the degrees of the rings.
  void append_neighbours(FaceId f, std::vector<FaceId>& out) const;

  // Like append_neighbours, but appends only the two faces next to f in each ring. They suffice for
  // traversals and connectivity, because the other faces of the ring are reached through them. Constant time.
  void append_nearest_neighbours(FaceId f, std::vector<FaceId>& out) const;

  // A face and one of its edges in the face's counter-clockwise direction, by vertices of its own sheet.
  struct Side {
    FaceId face;
    VertexId from;
    VertexId to;
  };

  // Appends the sides of all other live faces on the edge of f from corner `from` to its next corner `to`.
  void append_edge_sides(FaceId f, VertexId from, VertexId to, std::vector<Side>& out) const;

  // Append the sides of live faces that no other face shares: of all faces, in O(edges); of one live face; or
  // along the edges in slots first .. end - 1, where `end` may exceed edge_slots().
  void append_open_sides(std::vector<Side>& out) const { append_open_sides_in(0, edge_slots(), out); }
  void append_open_sides_of(FaceId f, std::vector<Side>& out) const;
  void append_open_sides_in(uint32_t first, uint32_t end, std::vector<Side>& out) const;

  // The faces around a vertex on its sheet, and the other ends of its boundary edges. `alone` is false if an
  // edge at the vertex is in a ring, i.e. if other sheets have a vertex at the same position.
  struct Star {
    std::vector<FaceId> faces;
    std::vector<VertexId> rim;
    bool alone = true;
  };
  // Finds the star of a vertex. Linear in its degree.
  void star(VertexId v, Star& out) const;

  // Moves a vertex of one sheet. The caller must update structures that depend on positions, e.g. a tree.
  void move_vertex(VertexId v, const Vec3& to);

  // One face that was split at an edge: `kept` is its old slot, now the half at `kept_end`, and `added` is
  // the new slot with the other half.
  struct FaceSplit {
    FaceId kept;
    FaceId added;
    VertexId midpoint;  // of this face's sheet; bit-equal positions in all sheets of the ring
    VertexId from;      // the edge in this face's counter-clockwise direction
    VertexId to;
    VertexId kept_end;  // from or to
  };

  // Splits the edge of f from corner `from` to its next corner `to`, and every face on its ring, at the
  // midpoint (from + to) / 2. Appends one entry per face; a new face gets a copy of the data of the old one.
  // Precondition: f is live and has this edge. Linear in the degree of the ring.
  void split_edge(FaceId f, VertexId from, VertexId to, std::vector<FaceSplit>& out);

  // Like split_edge, but splits at any point of the edge. Precondition: `at` is neither of its ends.
  void split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at, std::vector<FaceSplit>& out);

  // Flips the edge (from, to) between f and its neighbour, i.e. replaces it by the other diagonal of their
  // quadrilateral. Face data stay with their slots. Precondition: can_flip_edge(). Constant time, or linear
  // in the degree of a ring if other faces coincide with these.
  void flip_edge(FaceId f, VertexId from, VertexId to);

  // Returns true if the edge has two faces and is in no ring, and its opposite corners share no edge.
  bool can_flip_edge(FaceId f, VertexId from, VertexId to) const;

  VertexId add_vertex(const Vec3& position);
  // Adds faces with these corners, counter-clockwise, and returns their slots. Each face becomes its own base
  // face; the rest of its data is that given. Two new faces with a common side share one edge, and a side
  // along a boundary closes the boundary; columns of new faces are zero. A vertex whose faces are
  // no longer connected over edges is replaced by several at its position. Precondition: the mesh stays
  // orientable, i.e. no side occurs twice in one direction, or along a live face that already has it. New
  // edges are in no ring, even if they coincide with edges of other sheets. O(n log n) in the new faces and
  // those around them.
  std::vector<FaceId> add_faces(std::span<const std::array<VertexId, 3>> corners,
                                std::span<const FaceData> data);

  // Disconnects sides from all other faces on their edges. Listed sides of one edge stay connected, and so do
  // the others. A vertex whose faces are no longer connected over edges is replaced by several at its
  // position; appends the faces whose corners change. Precondition: the faces are live and have the sides.
  // O(n log n) in the sides and the degrees of their rings and vertices.
  void open_edges(std::span<const Side> sides, std::vector<FaceId>& changed);

  // Removes a face; its slot remains and is marked dead. Precondition: f is live.
  void remove_face(FaceId f);

  size_t bytes() const;

  // The mesh before a command or, once exchanged, after it (see ChangeOf). The cost of every function depends
  // on the size of the change, not on that of the mesh.
  class Change {
   public:
    Change();
    ~Change();
    Change(Change&&) noexcept;
    Change& operator=(Change&&) noexcept;
    void begin(Mesh& mesh);
    void end(Mesh& mesh);
    bool any() const;
    void exchange(Mesh& mesh);
    void restore(Mesh& mesh) const;
    size_t bytes() const;
    // Appends every face that differs between the states before and after the change: faces that are dead in
    // one of them, or have other corners. May also list unchanged or non-existent faces, and repeat faces.
    void append_faces(const Mesh& mesh, std::vector<FaceId>& out) const;

   private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
  };

  struct Kernel;
  friend class FaceAddition;
  Kernel& kernel() { return *kernel_; }
  const Kernel& kernel() const { return *kernel_; }

 private:
  std::unique_ptr<Kernel> kernel_;
};

using HalfEdgeId = Id<struct HalfEdgeTag>;

// Adds new faces to a mesh in parts; Mesh::add_faces adds them at once. Between the parts all queries of the
// mesh work, except that the star of a vertex lacks faces that are not connected to the others yet. No other
// code may edit the mesh until the addition is complete.
class FaceAddition {
 public:
  // `corners` index `vertices`, which are distinct. Preconditions as for Mesh::add_faces.
  FaceAddition(std::vector<VertexId> vertices, std::vector<std::array<uint32_t, 3>> corners);

  size_t faces() const { return corners_.size(); }
  size_t added() const { return added_; }

  // Merges another vertex of the mesh at the position of vertices[v] with it, before any face is added.
  // Appends the faces whose corners change.
  void weld(Mesh& mesh, uint32_t v, VertexId other, std::vector<FaceId>& changed);

  // Adds the next data.size() faces and returns their slots. Precondition: added() + data.size() <= faces().
  std::vector<FaceId> add(Mesh& mesh, std::span<const FaceData> data);

  // Processes the next `most` vertices: splits a vertex into one per fan if its faces are not connected over
  // edges. Appends the faces whose corners change. Returns true if the addition is complete. Precondition:
  // all faces were added.
  bool split_fans(Mesh& mesh, size_t most, std::vector<FaceId>& changed);

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  // The half-edges that start at a vertex: a chain of entries.
  struct Chain {
    uint32_t first = kNone, last = kNone;
    uint32_t count = 0;  // entries
  };
  struct Entry {
    HalfEdgeId half_edge;
    uint32_t next;
  };

  template <typename Visit>
  void for_each_at(uint32_t v, Visit visit) const {
    for (uint32_t e = chains_[v].first; e != kNone; e = entries_[e].next) visit(entries_[e].half_edge);
  }
  friend class Mesh;
  void open(Mesh& mesh, std::span<const Mesh::Side> sides);
  HalfEdgeId part_from(Mesh::Kernel& kernel, HalfEdgeId side);
  uint32_t index_of(VertexId v) const;
  void append(uint32_t v, HalfEdgeId h);
  void record_half_edges(const Mesh::Kernel& kernel, uint32_t v);
  HalfEdgeId side(Mesh::Kernel& kernel, uint32_t from, uint32_t to);
  void link_boundaries(Mesh::Kernel& kernel, uint32_t v) const;
  bool is_one_fan(const Mesh::Kernel& kernel, uint32_t v) const;
  void part_fans_at(Mesh::Kernel& kernel, uint32_t v, std::vector<FaceId>& changed) const;

  std::vector<VertexId> vertices_;
  std::vector<std::array<uint32_t, 3>> corners_;
  std::vector<bool> is_noted_;  // by vertex: true if its half-edges are listed
  std::vector<Chain> chains_;   // by vertex
  std::vector<Entry> entries_;
  size_t added_ = 0, parted_ = 0;  // faces added, vertices processed by split_fans()
};

// Copies some faces of a mesh into a new mesh. Positions, orientation, the order of faces around vertices,
// rings, face data, columns and colours are preserved to the bit. References to other faces change: green
// pairs are dropped, and the base of a face becomes the face itself if it was never split, otherwise the
// first of the extracted faces with the same base. Slots have the order of `faces`. Parts that touch in a
// vertex get separate vertices.
//
// Preconditions: `faces` are live, ascending and not empty, and contain with each face all faces connected to
// it over edges. O(n log n).
Mesh extract_mesh(const Mesh& mesh, std::span<const FaceId> faces);

// Boundaries of single sheets, including those that touch other sheets, i.e. whose edges are in rings.
// Mesh::append_open_sides omits the latter.

// A side on the boundary of a sheet, and whether its edge is in a ring.
struct SheetSide {
  Mesh::Side side;
  bool is_shared;
};

// Append the sides on boundaries of sheets: of a live face, or along the edges in slots first .. end - 1,
// where `end` may exceed edge_slots(). Linear in the edges.
void append_sheet_sides_of(const Mesh& mesh, FaceId f, std::vector<SheetSide>& out);
void append_sheet_sides_in(const Mesh& mesh, uint32_t first, uint32_t end, std::vector<SheetSide>& out);

// A side of a face, and the other face of its edge on the same sheet, which is invalid on a boundary.
struct SheetEdge {
  VertexId from, to;
  FaceId across;
  bool is_shared;  // the edge is in a ring
};
// Returns the sides of a live face, in the order of its corners.
std::array<SheetEdge, 3> sheet_edges_of(const Mesh& mesh, FaceId f);

// Appends the neighbours of a live face on its sheet: the other face on each edge, without faces reached over
// rings.
void append_sheet_neighbours(const Mesh& mesh, FaceId f, std::vector<FaceId>& out);

}  // namespace kerf
