#pragma once

#include <array>
#include <vector>

#include "core/base/change_of_parts.h"
#include "core/mesh/mesh.h"
#include "core/mesh/replacement.h"

namespace kerf {

// Red-green refinement: the paper's 1-to-4 split, closed on the neighbours (R. E. Bank, A. H. Sherman,
// A. Weiser: Refinement algorithms and data structures for regular local mesh refinement, 1983).
//
// The mesh is seen as *elements*: red triangles. An element whose edges are all whole is one face. An element
// with one bisected edge is a green pair of faces: it lives and dies together, and it is turned back into its
// element before that is split (its one split edge is a part of the red split, so the pair is never cut up).
// Two split edges, or a neighbour that wants to split half of a green edge, make the element red: four faces
// of the next level. So no face descends from a green one, and every descendant has the angles of its base
// face or of one green bisection of it.
class OneToFour {
 public:
  // The element that f is, or is a half of.
  struct Element {
    std::array<VertexId, 3> corners;
    std::array<FaceId, 2> faces;
    uint8_t face_count = 0;
  };
  Element element(const Mesh& mesh, FaceId f) const;
  Triangle triangle(const Mesh& mesh, FaceId f) const;

  // Whether all edges of f's element have a midpoint that is neither of their ends. Coordinates have an end.
  bool can_split(const Mesh& mesh, FaceId f) const;

  // Splits the element of f into four and closes the split on the neighbours, so that the mesh is conforming
  // again. Appends what became of every element that changed: one face or a green pair made way for a green
  // pair or four red faces. The cost is that of the elements that change.
  void split(Mesh& mesh, FaceId f, std::vector<Replacement>& out);

  // Forgets the green pair of a face that is about to be removed with its other half, or to be split by
  // another rule: the halves are faces like others from then on.
  void forget(Mesh& mesh, FaceId f);

  // What it was before a command (see ChangeOf).
  class Change;
  size_t bytes() const;

 private:
  friend class ChangeOfParts<OneToFour>;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.elements_, self.free_);
  }

  // An element with one or more bisected edges. Edge i runs from corner i to the next corner.
  struct Split {
    std::array<VertexId, 3> corners;
    std::array<VertexId, 3> midpoints;
    std::array<FaceId, 4> faces;
    uint8_t face_count = 1;
    uint8_t faces_in_tree = 1;  // 1: the others were made in this call; 2: a green pair from before it
    uint8_t first_edge = 0;     // the edge that was bisected first: its bisector is turned over in the end
    uint8_t halvings = 0;       // of the element
    bool wanted_red = false;
  };

  uint32_t open_element(const Mesh& mesh, FaceId f);
  void close_element(uint32_t index);
  void make_red(Mesh& mesh, FaceId f, std::vector<Replacement>& out);
  void refine_coarser_neighbours(Mesh& mesh, uint32_t element, std::vector<Replacement>& out);
  bool refine_coarser_across(Mesh& mesh, uint32_t element, int edge, std::vector<Replacement>& out);
  void bisect(Mesh& mesh, uint32_t element, int edge);
  void note_split(Mesh& mesh, const Mesh::FaceSplit& s);
  void finish_red(Mesh& mesh, uint32_t element, std::vector<Replacement>& out);
  void report_green(std::vector<Replacement>& out);
  static int edge_of(const Split& e, VertexId from,
                     VertexId to);  // 3 where it is no whole edge of the element
  FaceId face_at(const Mesh& mesh, const Split& e, VertexId from, VertexId to) const;

  Records<Split> elements_;
  uint32_t free_ = FaceData::kNoElement;  // the first of those that are closed; faces[0] is the next
  std::vector<uint32_t> changed_;         // elements that became green in this call
  std::vector<FaceId> pending_;           // faces of elements with two split edges
};

class OneToFour::Change : public ChangeOfParts<OneToFour> {};

}  // namespace kerf
