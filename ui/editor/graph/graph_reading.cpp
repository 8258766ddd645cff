#include "ui/editor/graph/graph_reading.h"

#include "core/base/assert.h"
#include "ui/window/number_text.h"

namespace kerf {

LongChange graph_reading(GraphState& graph) {
  KERF_ASSERT(graph.is_asked_for());
  graph.no_longer_ask();
  struct Reading {
    GraphState graph;
    bool done = false;
  };
  const auto reading = std::make_shared<Reading>(Reading{graph});
  return {"Reading the graph of " + grouped(graph.left_out()) + " faces",
          [reading](Document& document, const Progress& progress) {
            reading->done = reading->graph.read_left_out(document, progress);
            return Outcome();
          },
          [reading, &graph](const Outcome&) {
            if (reading->done) graph = std::move(reading->graph);
          }};
}

}  // namespace kerf
