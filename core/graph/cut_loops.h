#pragma once

#include "core/world/separation_state.h"

namespace kerf {

// Counts the loops that a cut closes, face by face, without searching.
//
// By the duality of J. W. Alexander (1922; A. Hatcher: Algebraic Topology, 2002, theorem 3.44) a closed
// surface from which the complex K of the removed faces, with their edges and vertices, is taken has as many
// parts more as K has independent loops more, less those that are loops of the surface itself. So taking a
// face away can separate something only when it adds a loop to K, and that shows in how its three edges and
// corners hang together with the rest of K: a union-find over vertices is all the memory that it takes.
//
// A boundary counts as filled with a disc that was removed: the vertices of a boundary loop are one, joined
// when one of them is met first. So are the vertices by which an edge of the rim was split since. Where an
// edge holds three faces or more, surfaces hang together in a way that no disc describes: cannot_know.
class CutLoops {
 public:
  CutLoops(const Mesh& mesh, SeparationState& state) : mesh_(mesh), state_(state) {}

  // Takes f away, which is live and still in the mesh; the state has its nearest neighbours. Constant time
  // near enough, but that a boundary loop is walked once.
  void remove(FaceId f);

 private:
  struct Edges {
    int shared = 0;  // with a live face beside f, which the same two vertices bound
    bool others = false;
  };
  Edges edges_of(FaceId f) const;
  void meet(VertexId v);
  void meet_along_rim(VertexId v);
  uint32_t find(VertexId v);
  bool unite(VertexId a, VertexId b);

  const Mesh& mesh_;
  SeparationState& state_;
};

}  // namespace kerf
