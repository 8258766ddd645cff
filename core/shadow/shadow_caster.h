#pragma once

#include <array>
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

// The triangles of a body as they cast shadows, whatever the light: which edge each side of a triangle lies
// on, found by position alone. Half-edges are not asked, since they have no edge of three faces.
//
// Positions are those that the GPU draws: floats of a FloatFrame. Two corners are one vertex when these
// floats are equal to the bit (-0.0 is +0.0) and the faces belong to one piece, so that a piece can be drawn
// elsewhere or not at all. A triangle with two equal corners casts nothing; of triangles with the same three
// corners only the one in the lowest slot casts.
//
// Slots of vertices and edges only grow. About 80 bytes a face.
class ShadowCaster {
 public:
  // Expected linear time.
  ShadowCaster(const Mesh& mesh, const FloatFrame& frame);
  // The same, or that it was stopped. `progress` may be null.
  static Result<ShadowCaster> build(const Mesh& mesh, const FloatFrame& frame, const Progress* progress);

  // What update() changed, for those who keep something by face or edge: slots, each once, in no order.
  struct Change {
    std::vector<uint32_t> faces, edges;
  };
  // Takes these face slots as they are in the mesh now. Slots may be new, dead or unchanged. Expected time
  // linear in the number of slots, times the number of faces on their edges.
  Change update(const Mesh& mesh, std::span<const uint32_t> slots);

  uint32_t face_slots() const { return static_cast<uint32_t>(casts_.size()); }
  uint32_t edge_slots() const { return static_cast<uint32_t>(edges_.size()); }

  // Whether the face is there and casts.
  bool casts(uint32_t face) const { return casts_[face] != 0; }
  // Of a face that casts: its corners in the float frame and its piece.
  std::array<glm::vec3, 3> corners(uint32_t face) const;
  uint32_t piece(uint32_t face) const { return vertices_[corner_[3 * face]].piece; }

  // The ends of an edge in the float frame: `low` comes first in the order of x, then y, then z, so that
  // equal edges of different bodies and pieces are drawn alike to the bit.
  struct Ends {
    glm::vec3 low, high;
    uint32_t piece;
  };
  Ends ends(uint32_t edge) const;

  // Calls visit(face, along) for every triangle on the edge that is there, whether it casts or not; `along`
  // is 1 where it walks the edge from low to high, -1 where from high to low.
  template <typename Visit>
  void for_each_face_on(uint32_t edge, const Visit& visit) const {
    for (uint32_t side = edges_[edge].first; side != kNone; side = sides_[side].next) {
      visit(side / 3, sides_[side].edge & 1u ? -1 : 1);
    }
  }

  const FloatFrame& frame() const { return frame_; }

  // Memory that it holds.
  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Vertex {
    glm::vec3 at;
    uint32_t piece;
  };
  struct Edge {
    uint32_t low, high;  // vertices
    uint32_t first;      // side
    uint32_t faces;
  };
  // Side 3 f + i of face f runs from its corner i to the next.
  struct Side {
    uint32_t edge;  // twice its edge, and one more where it runs from high to low
    uint32_t next;  // on the edge
  };

  explicit ShadowCaster(const FloatFrame& frame) : frame_(frame) {}

  // Adds the faces of a mesh to none; whether it was not stopped.
  bool add_all(const Mesh& mesh, const Progress* progress);
  void grow(uint32_t faces);
  uint32_t find_vertex(const Vec3& p, uint32_t piece);
  uint32_t find_side_edge(uint32_t from, uint32_t to);
  bool there(uint32_t face) const { return corner_[3 * face] != kNone; }
  std::array<uint32_t, 3> sorted_corners(uint32_t face) const;
  // The first three leave in `copies_` the faces that have the corners of `face`, itself included.
  void add(const Mesh& mesh, uint32_t face);
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
  std::vector<uint32_t> corner_;  // three a face slot; kNone where no face casts or could cast
  std::vector<Side> sides_;       // three a face slot
  std::vector<uint8_t> casts_;    // by face slot
  KeyTable vertex_table_, edge_table_;
  std::vector<uint32_t> copies_;  // between calls: nothing of meaning
};

}  // namespace kerf
