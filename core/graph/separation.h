#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/union_find.h"
#include "core/world/world.h"

namespace kerf {

// Finds what newly came apart in one body after faces were removed.
//
// Faces hang together over shared edges. Tell it of every face before it is removed; then settle() searches
// from the rim of what was removed, one face at a time from each place in turn. Fronts that meet are one; a
// front that runs out of faces before it meets the others has come off. Faces that never hung together are
// told apart by the removed faces: only what a connected removal touched can have been separated by it.
class Separation {
 public:
  // f is live and about to be removed. Split faces may follow; slots carry the memory to their parts.
  void note_removal(const Mesh& mesh, FaceId f);

  struct Result {
    std::vector<uint32_t> new_pieces;  // labels, by the lowest face that they hold
    std::vector<FaceId> relabelled;    // the faces of those
  };
  // Of a component that fell apart the part of the largest area keeps its label (of equal parts the one with
  // the lowest face); each other part gets a new label and an entry in body.pieces. Forgets the removals.
  Result settle(Body& body);

 private:
  uint32_t place(FaceId f);

  std::unordered_map<uint32_t, uint32_t>
      place_of_;               // face slot -> index into faces_; looked up, never walked
  std::vector<FaceId> faces_;  // removed faces and their neighbours
  std::vector<std::pair<uint32_t, uint32_t>> ties_;  // places that hung together
  std::vector<FaceId> neighbours_;
};

// Labels every live face with the number of its component, by a full breadth-first search over shared edges
// (the paper's). Dead slots get 0xffffffff. Returns the number of components. O(faces).
uint32_t label_components(const Mesh& mesh, std::vector<uint32_t>& label);

}  // namespace kerf
