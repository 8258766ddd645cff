#include "core/document/history/last_cut_graph.h"

namespace kerf {

std::optional<DrawnGraph> graph_around_last_cut(const Document& document) {
  const CutGraph graph = cut_graph(document.world(), document.history().last_cut_faces());
  const std::optional<uint32_t> start = start_beside_cut(graph);
  if (!start) return std::nullopt;
  return draw_graph(graph, traverse_cut(graph, *start), GraphScope::kAroundCut);
}

}  // namespace kerf
