#pragma once

#include <ostream>
#include <span>

#include "core/graph/component_graph.h"

namespace kerf {

// A component graph as text. Faces and pieces are numbered over all bodies of the world: the number of a face
// is its slot plus the face slots of the bodies before its own, and that of a piece is its label plus the
// pieces of these bodies, so that in a world of one body both are the numbers that the editor shows.
//
// Steps of the history are counted from 1.
//
// Precondition of both functions: the graph and the pieces are those of `world`. Linear time; nothing of the
// size of the graph is held in memory.

// {"nodes": [{"face": 0, "piece": 0, "body": 0}], "edges": [[0, 1]], "bodies": [{"name": "car", "first_face":
// 0, "first_piece": 0}], "pieces": [{"piece": 3, "name": "car 3", "body": 0, "faces": 120, "came_off": 0,
// "step": 2, "held_by": "nothing", "parts": 1}]}: edges by index of nodes; the bodies of the world with the
// numbers at which their faces and pieces start; the pieces with what they came off and in which step, both
// null where it is not known, and what holds them (see name_of(Holder)).
void write_graph_json(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                      std::ostream& out);

// The language of Graphviz (E. R. Gansner, S. C. North: An open graph visualization system, 2000), with the
// numbers of faces as names and a colour for each piece, and the pieces as boxes that say what holds them,
// with an arrow from a piece to each that came off it.
void write_graph_dot(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                     std::ostream& out);

}  // namespace kerf
