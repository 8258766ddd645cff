#pragma once

#include <optional>
#include <vector>

#include "core/base/vec3.h"
#include "core/graph/drawn_graph.h"

namespace kerf {

// Places of nodes in a plane, one for each node of a drawn graph. The plane is scaled so that the larger side
// of their bounding box is from -1 to 1 and the smaller one is centred.
using GraphLayout = std::vector<Vec2>;

// Where the nodes are in space, projected onto a plane: that of the two directions in which the nodes extend
// most (principal components: K. Pearson: On lines and planes of closest fit to systems of points in space,
// 1901). Linear time.
GraphLayout lay_out_by_position(const DrawnGraph& graph);

// Unrolled along the cut, where the removed faces run around: as if the nodes lay on a ring around the middle
// of the removed faces, which is opened at its widest gap. From left to right is the way around, and upwards
// the distance from the cut, with one of its sides above and the other below; the height is stretched to two
// fifths of the width where it is less. Nothing where the removed faces leave a gap of a quarter turn or run
// through the middle: such a cut is seen as a whole by position. O(n log n).
std::optional<GraphLayout> lay_out_unrolled(const DrawnGraph& graph);

// As if links were springs and nodes repelled each other (T. M. J. Fruchterman, E. M. Reingold: Graph drawing
// by force-directed placement, 1991; nodes farther apart than two lengths of a spring do not repel). Starts
// from the layout by position and takes a fixed number of turns, so that the result is a function of the
// graph. O(turns * (nodes + links)) if the nodes spread evenly; at most quadratic in the nodes.
GraphLayout lay_out_by_force(const DrawnGraph& graph);

}  // namespace kerf
