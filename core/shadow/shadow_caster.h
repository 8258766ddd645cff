#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/float_frame.h"
#include "core/base/key_table.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The triangles of a body as shadow casters, independent of any light: the edge that each side of a triangle
// lies on, identified by position alone. Half-edges cannot serve, because they have no edge of three faces.
//
// Positions are those that the GPU draws: floats of a FloatFrame. Two corners are the same vertex if these
// floats are equal to the bit (-0.0 counts as +0.0) and their faces belong to the same piece, so that a piece
// can be drawn displaced or hidden. A triangle with two equal corners casts no shadow; of several triangles
// with the same three corners only the one in the lowest slot casts.
//
// The numbers of vertex and edge slots never decrease. Takes about 82 bytes per face.
class ShadowCaster {
 public:
  // By face slot the label that stands for the piece of a face where loose parts are drawn apart from it;
  // faces beyond the end have the label of their piece.
  using Labels = std::span<const uint32_t>;

  // Adds all live faces of the mesh. Expected linear time.
  ShadowCaster(const Mesh& mesh, const FloatFrame& frame, Labels labels = {});
  // Makes a caster of all live faces, or fails with cancelled() when stopped. `progress` may be null.
  static Result<ShadowCaster> build(const Mesh& mesh, const FloatFrame& frame, const Progress* progress);

  // The slots of faces and edges that update() changed, ascending, each once.
  struct Change {
    std::vector<uint32_t> faces, edges;
  };
  // Brings these face slots up to date with the mesh; they may be new, dead or unchanged, and a slot that
  // undo took away from the mesh is dead. `relabelled` are slots whose label alone may have changed since,
  // which saves looking at their corners; slots that are listed in both are treated as the others. Expected
  // time linear in the number of slots times the number of faces on their edges. Where all faces at a vertex
  // get the same new label, the vertex and its edges keep their slots.
  Change update(const Mesh& mesh, std::span<const uint32_t> slots, std::span<const uint32_t> relabelled = {},
                Labels labels = {});

  uint32_t face_slots() const { return static_cast<uint32_t>(casts_.size()); }
  uint32_t edge_slots() const { return static_cast<uint32_t>(edges_.size()); }

  // Whether the face exists and casts a shadow. Precondition: face < face_slots().
  bool casts(uint32_t face) const {
    assert(face < face_slots());
    return casts_[face] != 0;
  }
  // The corners of a face in the float frame, and its piece. Precondition: the face casts a shadow.
  std::array<glm::vec3, 3> corners(uint32_t face) const;
  uint32_t piece(uint32_t face) const {
    assert(casts(face));
    return vertices_[corner_[3 * face]].piece;
  }

  // The ends of an edge in the float frame. `low` precedes `high` in the lexicographic order of x, y and z,
  // so that equal edges of different bodies and pieces are drawn identically to the bit.
  struct Ends {
    glm::vec3 low, high;
    uint32_t piece;
  };
  // Precondition: edge < edge_slots().
  Ends ends(uint32_t edge) const;

  // Calls visit(face, along) for every triangle on the edge, whether it casts a shadow or not; `along` is 1
  // if the triangle's boundary runs from low to high there, else -1. Precondition: edge < edge_slots().
  template <typename Visit>
  void for_each_face_on(uint32_t edge, const Visit& visit) const {
    assert(edge < edge_slots());
    for (uint32_t side = edges_[edge].first; side != kNone; side = sides_[side].next) {
      visit(side / 3, sides_[side].edge & 1u ? -1 : 1);
    }
  }

  const FloatFrame& frame() const { return frame_; }

  // Memory allocated, in bytes.
  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Vertex {
    glm::vec3 at;
    uint32_t piece;
    uint32_t uses;  // corners of faces that are there
  };
  // A face whose corners stay where they are while its label changes.
  struct Relabelled {
    uint32_t face, from, to;
  };
  struct Edge {
    uint32_t low, high;  // vertices
    uint32_t first;      // side
    uint32_t faces;
  };
  // Side 3 f + i of face f runs from its corner i to its next corner.
  struct Side {
    uint32_t edge;  // twice its edge, plus one if it runs from high to low
    uint32_t next;  // the next side on the same edge
  };

  explicit ShadowCaster(const FloatFrame& frame) : frame_(frame) {}

  // Adds all faces of a mesh to an empty caster. Returns false if it was stopped.
  bool add_all(const Mesh& mesh, Labels labels, const Progress* progress);
  void grow(uint32_t faces);
  uint32_t find_vertex(const Vec3& p, uint32_t piece);
  uint32_t known_vertex(const glm::vec3& at, uint32_t piece) const;
  uint32_t find_side_edge(uint32_t from, uint32_t to);
  bool there(uint32_t face) const { return corner_[3 * face] != kNone; }
  std::array<uint32_t, 3> sorted_corners(uint32_t face) const;
  bool stands_still(const Mesh& mesh, uint32_t face) const;
  void note_label(uint32_t face, uint32_t label, std::vector<Relabelled>& out) const;
  std::vector<uint32_t> relabel(std::span<const Relabelled> faces, Change& change);
  void rename_vertex(uint32_t vertex, uint32_t piece);
  // add, put and find_copies leave in `copies_` the faces with the same corners as `face`, itself included;
  // take_away leaves the others.
  void add(const Mesh& mesh, uint32_t face, Labels labels);
  void put(uint32_t face, const std::array<uint32_t, 3>& corners);
  void take_away(uint32_t face);
  void find_copies(uint32_t face);
  void let_lowest_cast();
  void append_edges(uint32_t face, std::vector<uint32_t>& out) const;
  void link(uint32_t side, uint32_t edge_and_way);
  void unlink(uint32_t side);

  FloatFrame frame_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<uint32_t> corner_;  // three per face slot; kNone where there is no face that could cast
  std::vector<Side> sides_;       // three per face slot
  std::vector<uint8_t> casts_;    // by face slot
  KeyTable vertex_table_, edge_table_;
  std::vector<uint32_t> copies_;  // scratch memory
};

}  // namespace kerf
