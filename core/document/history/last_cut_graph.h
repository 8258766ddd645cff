#pragma once

#include <optional>

#include "core/document/history/document.h"
#include "core/graph/drawn_graph.h"

namespace kerf {

// What is drawn of the component graph around the last stroke that was not undone, with the traversal from
// start_beside_cut() at its end; without a stroke, of the graph of all bodies. Nothing if no face is live.
// Linear in the faces of the bodies that the stroke cut (see draw_graph).
std::optional<DrawnGraph> graph_around_last_cut(const Document& document);

}  // namespace kerf
