#pragma once

#include <vector>

#include "core/world/world.h"

namespace kerf {

// Groups of the faces of a body whose pieces are shown apart. The faces of a piece form one group, except
// its loose parts: components never connected to the largest component of the piece, such as the wheels and
// door handles of a car. A loose part moves with the piece whose surface is nearest.
struct PieceGroups {
  // Loose parts of one piece that move with another one.
  struct Loose {
    uint32_t piece, goes_with;  // labels, different
    friend bool operator==(const Loose&, const Loose&) = default;
  };
  std::vector<Loose> loose;  // ascending, each pair once
  // By face slot: the label of the face's own piece if the face moves with it, else the number of pieces of
  // the body plus the index in `loose`. Empty if nothing is loose; the group of each face is then the label
  // of its piece.
  std::vector<uint32_t> of_face;
  std::vector<Vec3>
      middles;  // by label: centre of area of all faces that move with the piece, in the body frame [m]

  uint32_t of(const Mesh& mesh, FaceId f) const {
    return f.index < of_face.size() ? of_face[f.index] : mesh.data(f).piece;
  }
};

// Groups the faces of a body; resolves distances to 1/64 of its longest side. O(n), O(1) for a single piece.
PieceGroups group_pieces(const Body& body);

// Returns the live faces whose group differs between two groupings, ascending; null stands for a grouping
// without loose parts. O(n), or O(1) if neither has loose parts.
std::vector<FaceId> regrouped(const Mesh& mesh, const PieceGroups* before, const PieceGroups* after);

}  // namespace kerf
