#pragma once

#include <vector>

#include "core/world/world.h"

namespace kerf {

// How the faces of a body are grouped where its pieces are shown apart. The faces of a piece form one group,
// except its loose parts: components that were never connected with the largest component of the piece, such
// as the wheels and door handles of a car. A loose part goes with the piece whose surface is nearest.
struct PieceGroups {
  // The loose parts of one piece that go with another one.
  struct Loose {
    uint32_t piece, goes_with;  // labels, which differ
    friend bool operator==(const Loose&, const Loose&) = default;
  };
  std::vector<Loose> loose;  // ascending, each pair once
  // By face slot: the label of the piece with which the face goes if that is its own piece, else the number
  // of pieces of the body plus the index in `loose`. Empty if nothing is loose: then the group of each face
  // is the label of its piece.
  std::vector<uint32_t> of_face;
  std::vector<Vec3>
      middles;  // by label: centre of area of all that goes with the piece, m, in the body frame

  uint32_t of(const Mesh& mesh, FaceId f) const {
    return f.index < of_face.size() ? of_face[f.index] : mesh.data(f).piece;
  }
};

// Groups the faces of a body. Nearness is measured in cells of a 64th of the body's longest side. O(n) if the
// body has more than one piece, else O(1).
PieceGroups group_pieces(const Body& body);

// The live faces whose group differs between two groupings, ascending; null stands for one without loose
// parts. O(n), or O(1) if neither has loose parts.
std::vector<FaceId> regrouped(const Mesh& mesh, const PieceGroups* before, const PieceGroups* after);

}  // namespace kerf
