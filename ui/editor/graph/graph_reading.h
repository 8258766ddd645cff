#pragma once

#include "ui/editor/graph/graph_state.h"
#include "ui/editor/shared/long_change.h"

namespace kerf {

// Reads the graph that was asked for, beside the frames, and hands it to `graph`, which must outlive it; if
// it is stopped, the graph stays left out. The document is not changed. Precondition: graph.is_asked_for().
LongChange graph_reading(GraphState& graph);

}  // namespace kerf
