#pragma once

#include <vector>

#include "ui/editor/inspect/graph_state.h"
#include "ui/editor/inspect/graph_views.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// The panel of the component graph of the last stroke: nodes and links in a plane, the traversal that
// detects separation, and, as a second view, the tree of pieces.
class GraphPanel {
 public:
  // `pointer` is the place of the pointer in the window if it is over the viewport of the open document. A
  // wide panel has the graph next to its rows, a narrow one below them.
  void draw(GraphState& graph, const Document& document, ViewState& view, std::optional<Vec2> pointer);
  // Frames the whole graph. Returns false if the pointer is not over it.
  bool fit_under_pointer();

 private:
  void draw_rows(GraphState& graph, const Document& document, ViewState& view);
  void draw_rows_of_faces(GraphState& graph, const ViewState& view);
  void draw_view_row(GraphState& graph, std::optional<PieceId> selected);
  void show_nodes(GraphState& graph, int view, std::optional<PieceId> selected);
  void draw_canvas(GraphState& graph, const Document& document, ViewState& view, std::optional<Vec2> pointer,
                   float height);
  void light(const GraphState& graph, const Document& document, ViewState& view,
             const GraphCanvas::Pointer& on_canvas, std::optional<FaceOfBody> in_picture);
  void draw_pieces(const Document& document, ViewState& view);

  GraphCanvas canvas_;
  size_t framed_ = 0;  // number() of the graph framed last
  bool pieces_shown_ = false;
  std::vector<PieceTreeRow> rows_;
  size_t origins_of_ = static_cast<size_t>(-1);  // length of the journal for which the rows were computed
};

}  // namespace kerf
