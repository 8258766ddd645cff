#pragma once

#include <ostream>
#include <span>

#include "core/graph/component_graph.h"

namespace kerf {

// Export of a component graph as text. Faces and pieces are numbered over all bodies of the world: a face by
// its slot plus the face slots of the preceding bodies, a piece by its label plus the pieces of these bodies,
// so that in a world of one body both are the numbers shown by the editor. History steps count from 1.
//
// Precondition of both functions: the graph and the pieces are those of `world`. O(n), without copying the
// graph.

// Writes JSON: {"nodes": [{"face": 0, "piece": 0, "body": 0}], "edges": [[0, 1]], "bodies": [{"name": "car",
// "first_face": 0, "first_piece": 0}], "pieces": [{"piece": 3, "name": "car 3", "body": 0, "faces": 120,
// "came_off": 0, "step": 2, "held_by": "nothing", "parts": 1}]}. Edges are indices of nodes; bodies have the
// numbers of their first face and piece; pieces have the piece they were cut off and the step, both null if
// unknown, and what holds them (see name_of(Holder)).
void write_graph_json(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                      std::ostream& out);

// Writes the DOT language of Graphviz (E. R. Gansner, S. C. North: An open graph visualization system, 2000):
// faces as nodes named by number, with a colour for each piece; pieces as boxes labelled with what holds
// them, with an arrow from a piece to each one cut off it.
void write_graph_dot(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                     std::ostream& out);

}  // namespace kerf
