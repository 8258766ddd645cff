#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/mesh/replacement.h"
#include "core/world/world.h"

namespace kerf {

// What newly came apart in one body after faces were removed.
//
// Faces hang together over shared edges. Whoever edits the mesh tells of it; settling then knows from the
// loops that the cut closed whether anything can have come apart (see CutLoops), and only if so searches for
// it, from what hung on the faces that were removed (see PartSearch). A search may go on over several
// settlings: what is edited in between is told like everything else, and a loop that closes meanwhile starts
// it anew, with twice as long turns. Faces that never hung together are told apart by the removed faces: only
// what a connected removal touched can have been separated by it.

// f is live and about to be removed. To be told before the counts of its piece change.
void note_removal(Body& body, FaceId f);

// Faces were split. Their counts may be told before or after.
void note_replaced(Body& body, const Replacement& replaced);

// The face has other neighbours than before: one of its edges was turned.
void note_turned(Body& body, FaceId f);

struct SettleResult {
  std::vector<uint32_t> new_pieces;  // labels, by the lowest face that they hold
  std::vector<FaceId> relabelled;    // faces of those that have their label from now on, ascending
  size_t looked_at = 0;              // faces whose neighbours a search asked for
};

inline constexpr size_t kNoLimit = std::numeric_limits<size_t>::max();

// Of a component that fell apart the part of the largest area keeps its label (of equal parts, within
// kEqualArea of the whole, the one with the lowest face); each other part gets a new label and an entry in
// body.pieces. Looks at `most` faces or few more; what a search left to do is done by the next settlings.
//
// Constant time where no loop was closed. A search looks at most at twice the faces of what came off, when
// that is also the part with fewer faces; where it has more, at all of both, for each face must get its
// label.
SettleResult settle(Body& body, size_t most = kNoLimit);

// Whether no search is open.
bool is_settled(const Body& body);

// Forgets all that was told, for a mesh that was changed without telling; an open search is lost.
void forget_removals(Body& body);

// Labels every live face with the number of its component, by a full breadth-first search over shared edges
// (the paper's). Dead slots get 0xffffffff. Returns the number of components. O(faces).
uint32_t label_components(const Mesh& mesh, std::vector<uint32_t>& label);

}  // namespace kerf
