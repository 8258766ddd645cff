#pragma once

#include <ostream>

#include "core/graph/component_graph.h"

namespace kerf {

// A component graph as text. Faces and pieces are numbered over all bodies of the world: the number of a face
// is its slot plus the face slots of the bodies before its own, and that of a piece is its label plus the
// pieces of these bodies, so that in a world of one body both are the numbers that the editor shows.
//
// Precondition of both functions: the graph is one of `world`. Linear time; nothing of the size of the graph
// is held in memory.

// {"nodes": [{"face": 0, "piece": 0, "body": 0}], "edges": [[0, 1]], "bodies": [{"name": "car", "first_face":
// 0, "first_piece": 0}]}: edges by index of nodes; the bodies of the world with the numbers at which their
// faces and pieces start.
void write_graph_json(const ComponentGraph& graph, const World& world, std::ostream& out);

// The language of Graphviz (E. R. Gansner, S. C. North: An open graph visualization system, 2000), with the
// numbers of faces as names and a colour for each piece.
void write_graph_dot(const ComponentGraph& graph, const World& world, std::ostream& out);

}  // namespace kerf
