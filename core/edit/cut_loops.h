#pragma once

#include "core/world/separation_state.h"

namespace kerf {

// Counts the loops that a cut closes, one removed face at a time and without a search.
//
// Let K be the complex of the removed faces with their edges and vertices. By Alexander duality (J. W.
// Alexander, 1922; A. Hatcher: Algebraic Topology, 2002, theorem 3.44), removing K from a closed surface
// increases its number of components by the number of independent loops of K, minus those that are loops of
// the surface itself. Removing a face can therefore separate something only if it adds a loop to K. Whether
// it does follows from how its three edges and corners are connected with the rest of K, for which a
// union-find over vertices suffices.
//
// A boundary is treated as filled by a disc that was removed before: the vertices of a boundary loop are
// united when one of them is met first, and so are the vertices at which a boundary edge was split later.
// Surfaces that meet at an edge of three or more faces are connected in a way that no disc describes; the
// state is set to cannot_know there.
class CutLoops {
 public:
  CutLoops(const Mesh& mesh, SeparationState& state) : mesh_(mesh), state_(state) {}

  // Adds f to K. Preconditions: f is live, still in the mesh and about to be removed, and state.neighbours
  // holds its nearest neighbours. Amortised nearly constant time, plus one traversal of each boundary loop
  // that is met.
  void remove(FaceId f);

 private:
  struct Edges {
    int shared = 0;       // edges of f that a live face of the same sheet shares
    bool others = false;  // whether a neighbour is connected over a ring only
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
