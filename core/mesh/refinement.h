#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The replacement of split faces by their parts, which cover the same area. A reused slot is in both lists.
// Lists of replacements are in chronological order, so that a tree can apply them.
struct Replacement {
  std::array<FaceId, 2> removed;
  std::array<FaceId, 4> added;
  uint8_t removed_count = 0;
  uint8_t added_count = 0;
};

// Red-green refinement: the 1-to-4 split of the paper, with conforming closure of the neighbours (R. E. Bank,
// A. H. Sherman, A. Weiser: Refinement algorithms and data structures for regular local mesh refinement,
// 1983).
//
// The mesh is regarded as a set of *elements*, i.e. red triangles. An element without a bisected edge is one
// face. An element with one bisected edge is a green pair of faces; its two halves are removed together, and
// are merged into the element before the element is split. An element with two bisected edges, or with a
// neighbour that must bisect one half of its bisected edge, is split red into four elements of the next
// level. Therefore no face descends from a green face, and every face has the angles of its base face or of a
// single green bisection of it.
class OneToFour {
 public:
  // An element: one face, or a green pair.
  struct Element {
    std::array<VertexId, 3> corners;
    std::array<FaceId, 2> faces;
    uint8_t face_count = 0;
  };
  Element element(const Mesh& mesh, FaceId f) const;
  Triangle triangle(const Mesh& mesh, FaceId f) const;

  // Returns true if the element of f is large enough: the midpoints of its edges differ from their ends.
  bool can_split(const Mesh& mesh, FaceId f) const;

  // Splits the element of f into four, and its neighbours where the mesh must stay conforming. Appends the
  // replacement of every changed element: one face or a green pair is replaced by a green pair or four red
  // faces. Precondition: f is live and can_split(). A neighbour may be split although it cannot be split by
  // itself; some of its faces then have two corners at one position. Linear in the changed elements.
  void split(Mesh& mesh, FaceId f, std::vector<Replacement>& out);

  // Turns the green pair of a face into two ordinary faces. Must be called before the face is removed or
  // split by another scheme. No-op if the face is in no pair.
  void forget(Mesh& mesh, FaceId f);

  // The elements before a command (see ChangeOf).
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
    uint8_t faces_in_tree = 1;  // faces that exist since before this call: 1, or 2 for an earlier green pair
    uint8_t first_edge = 0;     // the edge bisected first; its bisector is flipped at the end
    uint8_t halvings = 0;       // of the element
    bool wanted_red = false;
  };

  uint32_t open_element(const Mesh& mesh, FaceId f);
  void close_element(uint32_t index);
  void make_red(Mesh& mesh, FaceId f, std::vector<Replacement>& out);
  void refine_coarser_neighbours(Mesh& mesh, uint32_t element, std::vector<Replacement>& out);
  bool refine_coarser_across(Mesh& mesh, uint32_t element, int edge, std::vector<Replacement>& out);
  void bisect(Mesh& mesh, uint32_t element, int edge);
  void record_split(Mesh& mesh, const Mesh::FaceSplit& s);
  void finish_red(Mesh& mesh, uint32_t element, std::vector<Replacement>& out);
  void report_green(std::vector<Replacement>& out);
  static int edge_of(const Split& e, VertexId from,
                     VertexId to);  // 3 if the element has no such edge
  FaceId face_at(const Mesh& mesh, const Split& e, VertexId from, VertexId to) const;

  Records<Split> elements_;
  uint32_t free_ = FaceData::kNoElement;  // head of the free list; faces[0] links to the next
  std::vector<uint32_t> changed_;         // elements that this call made green
  std::vector<FaceId> pending_;           // faces of elements with two bisected edges
};

class OneToFour::Change : public ChangeOfParts<OneToFour> {};

// Refinement by bisecting longest edges along their propagation path (M. C. Rivara: New longest-edge
// algorithms for the refinement and/or improvement of unstructured triangulations, 1997).
//
// Bisects f at the midpoint of its longest edge. If a face on that edge has a longer edge, that face is
// bisected first, and so on, so that every bisection splits a whole ring at the longest edge of all its
// faces. The mesh is conforming after each bisection, and no descendant has an angle smaller than half the
// smallest angle of its base face. Edges are ordered by length and then by the positions of their ends, so
// that equal lengths cause no cycle and all sheets of a ring have the same order.
//
// Green pairs on the path become ordinary faces. Appends a replacement for every face that was split. Returns
// false if an edge on the path is so short that its midpoint rounds to one of its ends; f itself is then
// unchanged. Precondition: f is live. Linear in the length of the path, which is short in practice.
bool bisect_longest_edge(Mesh& mesh, OneToFour& greens, FaceId f, std::vector<Replacement>& out);

}  // namespace kerf
