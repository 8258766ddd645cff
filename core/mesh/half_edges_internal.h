#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/records.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A directed edge. The half-edges of edge e are 2e and 2e + 1.
using HalfEdgeId = Id<struct HalfEdgeTag>;

inline HalfEdgeId opposite(HalfEdgeId h) { return HalfEdgeId(h.index ^ 1); }
inline EdgeId edge_of(HalfEdgeId h) { return EdgeId(h.index >> 1); }
inline HalfEdgeId half_edge(EdgeId e, uint32_t side) { return HalfEdgeId(2 * e.index + side); }

// The half-edges of a triangle mesh (K. Weiler: Edge-based data structures for solid modeling in
// curved-surface environments, 1985), in arrays that grow by chunks and record the changes of a command. A
// half-edge without a face is a boundary; the boundary half-edges of one hole form a cycle. The numbers of
// slots never decrease.
//
// An edge has at most two faces, and a vertex has one cycle of half-edges; rings represent non-manifold
// meshes (see Mesh).
class HalfEdges {
 public:
  uint32_t vertices() const { return positions_.size(); }
  uint32_t edges() const { return links_.size() / 2; }
  uint32_t faces() const { return first_.size(); }

  // Accessors. Precondition: the id is in range; to(), next(), previous() and face() need an edge in use.
  const Vec3& position(VertexId v) const { return positions_[v.index]; }
  const Vec3* const* position_chunks() const { return positions_.chunks(); }
  VertexId to(HalfEdgeId h) const { return links_[h.index].to; }
  VertexId from(HalfEdgeId h) const { return to(opposite(h)); }
  HalfEdgeId next(HalfEdgeId h) const { return links_[h.index].next; }
  HalfEdgeId previous(HalfEdgeId h) const { return links_[h.index].previous; }
  FaceId face(HalfEdgeId h) const { return links_[h.index].face; }
  // Returns a half-edge that starts at the vertex; invalid if the vertex has no edge.
  HalfEdgeId outgoing(VertexId v) const { return outgoing_[v.index]; }
  // Returns a half-edge of the face; invalid if the face is dead.
  HalfEdgeId first(FaceId f) const { return first_[f.index]; }

  VertexId add_vertex(const Vec3& position);
  // Adds an edge and returns its half-edge from `from` to `to`.
  HalfEdgeId add_edge(VertexId from, VertexId to);
  FaceId add_face(HalfEdgeId first);

  // Grows the arrays for a mesh whose records are set afterwards; every new record must be set. Several
  // threads may set different records concurrently.
  void grow_to(uint32_t vertices, uint32_t edges, uint32_t faces);
  // Sets the sides of a new face, in the order of its corners, and their links.
  void set_face_sides(FaceId f, const std::array<HalfEdgeId, 3>& sides,
                      const std::array<VertexId, 3>& corners);
  // Sets a new half-edge without a face; it must be linked afterwards.
  void set_open(HalfEdgeId h, VertexId to) { links_.edit(h.index) = {to, {}, {}, {}}; }

  void set_position(VertexId v, const Vec3& p) { positions_.edit(v.index) = p; }
  void set_to(HalfEdgeId h, VertexId v) { links_.edit(h.index).to = v; }
  void set_outgoing(VertexId v, HalfEdgeId h) { outgoing_.edit(v.index) = h; }
  // Makes `after` the successor of h.
  void link(HalfEdgeId h, HalfEdgeId after) {
    links_.edit(h.index).next = after;
    links_.edit(after.index).previous = h;
  }
  // Links three half-edges as the sides of a face. Precondition: each ends at the start of the next.
  void close(FaceId f, HalfEdgeId a, HalfEdgeId b, HalfEdgeId c);
  void set_face(HalfEdgeId h, FaceId f) { links_.edit(h.index).face = f; }

  // Splits an edge at a new vertex, and its faces. Afterwards half-edge 0 of the edge runs from the new
  // vertex to its former end, and the first new edge from the new vertex to its former start. Each face,
  // first the left and then the right one, keeps the part at the former end; the other part becomes a new
  // face.
  VertexId split(EdgeId e, const Vec3& at);

  // Removes a face and the edges that no other face uses. Precondition: the face is live.
  void remove(FaceId f);

  // Prefetches a face, its sides and two of its corners in kTurns turns, each of which reads data of the
  // previous one.
  static constexpr int kTurns = 3;
  void prefetch(FaceId f, int turn) const;
  // Prefetch one record each. GCC drops calls of functions that only prefetch, because they have no effect,
  // unless they are inlined early.
  [[gnu::always_inline]] void prefetch_first(FaceId f) const { first_.prefetch(f.index); }
  [[gnu::always_inline]] void prefetch_links(HalfEdgeId h) const { links_.prefetch(h.index); }
  [[gnu::always_inline]] void prefetch_position(VertexId v) const { positions_.prefetch(v.index); }
  // Prefetches a face and its other sides from a known, cached side; the side may be invalid.
  [[gnu::always_inline]] void prefetch_around(FaceId f, HalfEdgeId side) const {
    first_.prefetch(f.index);
    if (!side.valid()) return;
    links_.prefetch(next(side).index);
    links_.prefetch(previous(side).index);
  }

  template <typename Visit>
  void for_each_outgoing(VertexId v, Visit visit) const {
    const HalfEdgeId first = outgoing(v);
    if (!first.valid()) return;
    HalfEdgeId h = first;
    do {
      visit(h);
      h = next(opposite(h));
    } while (h != first);
  }

  size_t bytes() const;

  // The arrays before a command (see ChangeOf).
  class Change;

 private:
  friend class ChangeOfParts<HalfEdges>;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.links_, self.positions_, self.outgoing_, self.first_);
  }
  static constexpr size_t kLinks = 0, kPositions = 1, kFirst = 3;  // among the parts

  struct Links {
    VertexId to;
    HalfEdgeId next, previous;
    FaceId face;
  };
  void open(HalfEdgeId h) { set_face(h, FaceId()); }
  void remove_edge(EdgeId e);
  void leave(VertexId v, HalfEdgeId removed, HalfEdgeId other);

  Records<Links> links_;
  Records<Vec3> positions_;
  Records<HalfEdgeId> outgoing_;  // one per vertex
  Records<HalfEdgeId> first_;     // one per face
};

class HalfEdges::Change : public ChangeOfParts<HalfEdges> {
 public:
  // See Mesh::Change::append_faces.
  void append_faces(const HalfEdges& mesh, std::vector<FaceId>& out) const;
};

// The next and previous half-edge in a ring, in the direction of half-edge 0; the edge itself if in no ring.
struct RingLink {
  HalfEdgeId next;
  HalfEdgeId previous;
};

struct Mesh::Kernel {
  HalfEdges half_edges;
  Records<RingLink> rings;  // one per edge, or empty if the mesh has no ring
  Records<FaceData> faces;  // one per face slot
  FaceColumns columns;
  VertexColours colours;
  uint32_t live_faces = 0;

  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.half_edges, self.rings, self.faces, self.columns, self.colours, self.live_faces);
  }
};

struct Mesh::Change::Parts : ChangeOfParts<Mesh::Kernel> {};

// Rings, which link the coincident edges of a mesh (see Mesh). A mesh without rings stores no links.

// Return the next and the previous half-edge in the ring of h, in its direction; h if in no ring.
HalfEdgeId next_in_ring(const Mesh::Kernel& k, HalfEdgeId h);
HalfEdgeId previous_in_ring(const Mesh::Kernel& k, HalfEdgeId h);

// Gives every edge without a link a ring of its own.
void add_isolated_rings(Mesh::Kernel& k);

// Links half-edges into one ring. Precondition: they have the same direction and bit-equal ends.
void link_ring(Mesh::Kernel& k, const std::vector<HalfEdgeId>& members);

// Inserts h after `member` into its ring. Preconditions: the edge of h is in no ring, and both half-edges
// have the same direction and bit-equal ends.
void join_ring(Mesh::Kernel& k, HalfEdgeId h, HalfEdgeId member);

// Removes an edge from its ring; no-op if it is in none.
void leave_ring(Mesh::Kernel& k, EdgeId e);

// The vertices of a mesh: one per fan of triangles around a position. Sorted by position and then by the
// lowest side that starts there.
struct VertexFans {
  std::vector<uint32_t> position;   // by vertex
  std::vector<uint32_t> last_side;  // by vertex: the highest side that starts there

  uint32_t count() const { return static_cast<uint32_t>(position.size()); }
};

// Finds the fans, i.e. the sets of sides with one start that are connected over paired sides, and replaces
// the corners of the triangles, which are position numbers, by vertices. Side 3 t + i runs from corner i of
// triangle t to its next corner; partner[side] is the opposite side of another triangle on the same edge, or
// kNoSide. Fails with cancelled() when stopped, and leaves the triangles unusable then. `progress` may be
// null. Precondition: all corners are below `positions`. Linear time, multithreaded.
inline constexpr uint32_t kNoSide = 0xffffffffu;
Result<VertexFans> name_vertices(std::vector<std::array<uint32_t, 3>>& triangles, size_t positions,
                                 std::span<const uint32_t> partner, const Progress* progress);

// Fills empty half-edge arrays from triangles of vertices. partner[side] is as in name_vertices(), and
// last_side[v] is the highest side that starts at vertex v; its half-edge becomes the vertex's. Edges have
// the order of their lower sides, whose direction is that of half-edge 0. Does not set vertex positions.
// Returns the half-edge of each side; fails with cancelled() when stopped. `progress` may be null.
// Precondition: every vertex has one fan of triangles. Linear time, multithreaded.
Result<std::vector<HalfEdgeId>> fill_half_edges(HalfEdges& half_edges,
                                                std::span<const std::array<uint32_t, 3>> triangles,
                                                std::span<const uint32_t> partner,
                                                std::span<const uint32_t> last_side,
                                                const Progress* progress);

}  // namespace kerf
