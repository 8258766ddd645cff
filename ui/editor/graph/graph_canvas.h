#pragma once

#include <optional>

#include "core/graph/drawn_graph.h"
#include "core/graph/graph_layout.h"

namespace kerf {

// A field of a panel in which a graph is drawn. The wheel zooms to the pointer, and a drag moves the graph.
class GraphCanvas {
 public:
  struct Pointer {
    std::optional<uint32_t> over, clicked;  // drawn nodes
  };

  // Draws the graph in the full width of the panel, `height` pixels high, with a ring around the nodes `lit`
  // and `start`. Preconditions: there is one place for each node, and these are nodes.
  Pointer draw(const DrawnGraph& graph, const GraphLayout& places, float height, std::optional<uint32_t> lit,
               std::optional<uint32_t> start);

  // Shows the whole graph again.
  void fit() {
    middle_ = Vec2(0);
    zoom_ = 1;
  }

 private:
  void listen(Vec2 at);
  void draw_links(const DrawnGraph& graph, const GraphLayout& places) const;
  std::optional<uint32_t> draw_nodes(const DrawnGraph& graph, const GraphLayout& places) const;
  void draw_ring(const DrawnGraph& graph, const GraphLayout& places, uint32_t node, uint32_t colour) const;
  double radius_of(const DrawnGraph::Node& node) const;
  Vec2 on_screen(const Vec2& place) const { return centre_ + (place - middle_) * (half_ * zoom_); }

  Vec2 middle_{0};  // of what is seen, in the coordinates of the layout
  double zoom_ = 1;
  Vec2 centre_{0}, size_{0};  // of the field, screen coordinates
  double half_ = 1;           // pixels of the unit of the layout before zooming
  double radius_ = 1;         // of a node that is a single face, pixels
  bool dragged_ = false;
};

}  // namespace kerf
