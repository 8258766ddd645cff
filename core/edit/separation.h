#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/mesh/refinement.h"
#include "core/world/connectivity.h"
#include "core/world/world.h"

namespace kerf {

// Counts the loops that a cut closes, one removed face at a time and without a search.
//
// Let K be the complex of the removed faces with their edges and vertices. By Alexander duality (J. W.
// Alexander, 1922; A. Hatcher: Algebraic Topology, 2002, theorem 3.44), removing K from a closed surface
// increases its number of components by the number of independent loops of K, minus those that are loops of
// the surface itself. Removing a face can therefore separate something only if it adds a loop to K. That
// follows from the connections of its three edges and corners with the rest of K, for which a union-find over
// vertices suffices.
//
// A boundary is treated as filled by a disc that was removed before: the vertices of a boundary loop are
// united when one of them is met first, and so are the vertices at which a boundary edge is split later. No
// disc describes surfaces that meet at an edge of three or more faces; the state is set to is_inconclusive
// there.
class CutLoops {
 public:
  CutLoops(const Mesh& mesh, SeparationState& state) : mesh_(mesh), state_(state) {}

  // Adds f to K. Preconditions: f is live, about to be removed, and state.neighbours holds its nearest
  // neighbours. Amortised nearly constant time, plus one traversal of each boundary loop met.
  void remove(FaceId f);

 private:
  struct Edges {
    int shared = 0;       // edges of f shared with a live face of the same sheet
    bool others = false;  // true if a neighbour is connected over a ring only
  };
  Edges edges_of(FaceId f) const;
  void meet(VertexId v);
  void meet_along_rim(VertexId v);
  uint32_t find(VertexId v);
  bool unite(VertexId a, VertexId b);

  const Mesh& mesh_;
  SeparationState& state_;
};

// Separation: finds the parts of one body disconnected by the removal of faces.
//
// Faces are connected over shared edges. Only BodyEdit reports edits of the mesh, by the functions below.
// settle() then decides from the loops closed by the cut whether anything can have been separated (see
// CutLoops), and only then searches for it, starting from the former neighbours of removed faces (see
// PartSearch). A search may extend over several calls of settle(); edits between the calls are reported as
// usual, and if they close further loops, another search follows. A connected set of removed faces can only
// separate faces that it touched, so that faces that were never connected do not count as separated.

// Reports that f is about to be removed. Preconditions: f is live and included in the counts of its piece.
void record_removed_part(Body& body, FaceId f);

// Reports that faces were split, before their counts are updated and before the new faces are edited again.
void record_replaced(Body& body, const Replacement& replaced);

// Reports that the neighbours of a face changed by an edge flip, and the growth of its area (m^2).
// Precondition: f is live.
void record_flipped(Body& body, FaceId f, double area_gained);

struct SettleResult {
  std::vector<uint32_t> new_pieces;  // their labels, in the order of their lowest faces
  std::vector<FaceId> relabelled;    // faces that this call gave the label of a new piece, ascending
  size_t visited = 0;                // number of faces that the search visited
};

inline constexpr size_t kNoLimit = std::numeric_limits<size_t>::max();

// Permits or excludes edits of the body while a search waits for the next call of settle().
enum class EditPolicy { kAllowEdits, kNoEdits };

// Finds the parts into which components were separated. The part with the largest area keeps the label of its
// component (of equally large parts, see kEqualArea, the one with the lowest face); each other part gets a
// new label and an entry in body.pieces. Visits about `most` faces; later calls continue an unfinished
// search.
//
// O(1) if no loop was closed. Otherwise it visits at most twice as many faces as were separated if they are
// the minority, else all faces of both parts, because every face needs its label. With kNoEdits, it estimates
// which part is the smaller one and visits few faces of the other: 1.25 times as many as were separated, and
// at most five times as many if the estimate is wrong. The result is the same.
SettleResult settle(Body& body, size_t most = kNoLimit, EditPolicy policy = EditPolicy::kAllowEdits);

// Merges the connected parts of two faces that added faces join: separate loaded components, or one and a
// part cut off another. Precondition: both faces have the same label, and no search is open. O(1).
void join_parts(Body& body, FaceId a, FaceId b);

// Makes settle() search for parts, regardless of loops, from `faces` and the former neighbours of reported
// removed faces: each separated part must contain one of them. Precondition: no search is open.
void search_from(Body& body, std::span<const FaceId> faces);

// Returns true if no search is open.
bool is_settled(const Body& body);

// Discards all reports, including an open search, after a change of the mesh without reports.
void forget_removals(Body& body);

// Labels every live face with the number of its component by a complete breadth-first search over shared
// edges, the method of the paper. Dead slots get 0xffffffff. Returns the number of components. O(n).
uint32_t label_components(const Mesh& mesh, std::vector<uint32_t>& label);

}  // namespace kerf
