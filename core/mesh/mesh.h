#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/base/vec3.h"
#include "core/mesh/face_columns.h"

namespace kerf {

using Triangle = std::array<Vec3, 3>;

double triangle_area(const Triangle& t);
// Square of the longest edge.
double longest_edge2(const Triangle& t);
// Smallest of the three angles in radians' cosine form: the largest cosine of the three corners, 1 for a
// triangle without area.
double largest_cosine(const Triangle& t);

// What Kerf remembers of a face; a face that is split hands a copy to each part.
struct FaceData {
  static constexpr uint32_t kNoElement = 0xffffffffu;

  FaceId base;                    // the face as loaded that this one lies in
  uint32_t element = kNoElement;  // the green element that it is a half of (see OneToFour)
  uint32_t piece = 0;             // label of the piece that it hangs together with
  uint16_t material = 0;
  uint8_t halvings = 0;  // how often its area was halved since it was the base face; a split in four is two
};

// The positions of vertices as they lie in memory.
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
// Conforming: two faces meet in a common edge, a common corner or not at all; a split closes itself on all
// faces of the edge. Half-edges hold two faces an edge, so where three or more meet (or two that no turning
// makes consistent) each face has an edge of its own and these coincident edges are linked in a *ring*. Faces
// that lie on one another, corner for corner, are linked along all their edges and are split alike.
// Neighbourhood is asked for over rings: a face is a neighbour when it shares an edge by position.
//
// Vertices are per sheet: where sheets touch in a vertex or a ring, each sheet has a vertex of its own at
// bit-equal position. Slots of faces and vertices only grow; a removed face keeps its slot, marked dead.
//
// Growing never moves what is there, and what a command changes can be taken back (see Records).
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
  uint32_t live_faces() const;
  bool is_live(FaceId f) const;  // false for a slot that is not there

  Vec3 position(VertexId v) const;
  // Of a live face, counter-clockwise; where the turn starts may change with edits nearby.
  std::array<VertexId, 3> corners(FaceId f) const;
  Triangle triangle(FaceId f) const;
  // All of them, for whoever asks for many, until the mesh is edited.
  Positions positions() const;

  const FaceData& data(FaceId f) const;
  FaceData& edit_data(FaceId f);

  // Further values of the faces, which follow all that is done to faces (see FaceColumns).
  const FaceColumns& columns() const;
  FaceColumns& columns();

  // Appends every live face that shares an edge with f, over rings, f itself excepted. A face that shares two
  // edges with f comes twice. Linear in the rings' degrees.
  void append_neighbours(FaceId f, std::vector<FaceId>& out) const;

  // The same, but over a ring only the faces beside f in it. Every other face of the ring is reached from one
  // of those, so that whoever walks to all that hangs together, or asks what f held together, needs no more.
  // Constant time.
  void append_nearest_neighbours(FaceId f, std::vector<FaceId>& out) const;

  // A face and one of its edges as it walks it, counter-clockwise, in the vertices of its own sheet.
  struct Side {
    FaceId face;
    VertexId from;
    VertexId to;
  };
  // Asks for the memory that neighbours and corners of some faces lie in: for whoever asks for many, one
  // after the other. `at` is the face that is asked next.
  void prefetch_neighbours(std::span<const FaceId> faces, size_t at) const;

  // Appends the sides of every other live face on the edge of f from one of its corners to the next.
  void append_edge_sides(FaceId f, VertexId from, VertexId to, std::vector<Side>& out) const;

  // The faces around a vertex on its sheet, and the other ends of its edges that have one face. `alone` is
  // false where an edge at the vertex is linked in a ring: there other sheets hold the same position.
  struct Star {
    std::vector<FaceId> faces;
    std::vector<VertexId> rim;
    bool alone = true;
  };
  // Linear in the degree of the vertex.
  void star(VertexId v, Star& out) const;

  // Moves one vertex of one sheet. What follows positions (a tree) must be told of its faces.
  void move_vertex(VertexId v, const Vec3& to);

  // One face of a ring that was split: `kept` is the old slot, now the half at `kept_end` of the edge;
  // `added` is the new slot, the half at the other end.
  struct FaceSplit {
    FaceId kept;
    FaceId added;
    VertexId midpoint;  // of this face's sheet; bit-equal positions in all sheets of the ring
    VertexId from;      // the edge as this face walked it, counter-clockwise
    VertexId to;
    VertexId kept_end;  // from or to
  };

  // Bisects the edge of f from corner `from` to its next corner `to`, and every face on its ring, at the
  // midpoint (from + to) / 2. Appends one entry a face; each new face copies the data of the old one. Linear
  // in the ring's degree.
  void split_edge(FaceId f, VertexId from, VertexId to, std::vector<FaceSplit>& out);

  // The same at any point of the edge that is neither of its ends.
  void split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at, std::vector<FaceSplit>& out);

  // Turns the edge between the two faces f and its neighbour over (from, to) in the quadrilateral that they
  // make. The edge must have both faces. Face data stay with their slots. Constant time, but for copies of
  // the faces: linear in the ring of a side.
  void flip_edge(FaceId f, VertexId from, VertexId to);

  // Whether that edge has two faces, is in no ring, and its opposite corners have no edge yet.
  bool can_flip_edge(FaceId f, VertexId from, VertexId to) const;

  // Marks f dead and frees its edges; its slot stays. f must be live.
  void remove_face(FaceId f);

  // Memory that the mesh holds.
  size_t bytes() const;

  // What the mesh was before a command or, once exchanged, after it (see ChangeOf). Every function costs what
  // was changed, not what is there.
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

   private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
  };

  struct Kernel;
  Kernel& kernel() { return *kernel_; }
  const Kernel& kernel() const { return *kernel_; }

 private:
  std::unique_ptr<Kernel> kernel_;
};

}  // namespace kerf
