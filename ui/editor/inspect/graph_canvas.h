#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/graph/drawn_graph.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

// Returns the distance of each place from the nearest other one, at most `most`. Expected linear time if
// places are spread evenly. Precondition: most > 0.
std::vector<double> nearest_distances(const GraphLayout& places, double most);

// Formats the graph as an SVG image, 1000 units wide, with the colours and rings of the panel.
std::string graph_svg(const DrawnGraph& graph, const GraphLayout& places);

// A field of a panel that draws a graph with a legend. The wheel zooms to the pointer, and a drag moves the
// graph. At first it shows the whole graph. Nodes shrink rather than overlap.
class GraphCanvas {
 public:
  struct Pointer {
    std::optional<uint32_t> over, clicked;  // drawn nodes
  };
  // Input of draw(): the nodes `lit` and `start` get a ring; `scale` adds a bar with a length in file units,
  // from the average length of links, for layouts with distances like those of the faces.
  struct Drawn {
    const DrawnGraph& graph;
    const GraphLayout& places;
    std::optional<uint32_t> lit, start;
    std::optional<FileUnit> scale;
  };

  // Draws the graph in the remaining width, `height` pixels high. Preconditions: there is one place for each
  // node, and `lit` and `start` are nodes.
  Pointer draw(const Drawn& drawn, float height);

  // From the next draw() on, shows the whole graph, or the neighbourhood of its `start`.
  void fit() { framing_ = Framing::kAll; }
  void show_start() { framing_ = Framing::kStart; }
  // Returns true if the pointer was over it at the last draw().
  bool hovered() const { return hovered_; }

 private:
  enum class Framing { kNone, kAll, kStart };
  void execute_requests(const Drawn& drawn, double link);
  void listen();
  void draw_links(const DrawnGraph& graph, const GraphLayout& places, double link) const;
  std::optional<uint32_t> draw_nodes(const DrawnGraph& graph, const GraphLayout& places) const;
  void draw_ring(const DrawnGraph& graph, const GraphLayout& places, uint32_t node, uint32_t colour) const;
  void draw_scale(const DrawnGraph& graph, const GraphLayout& places, FileUnit unit) const;
  double radius_of(const DrawnGraph& graph, uint32_t node) const;
  void draw_legend(const DrawnGraph& graph) const;
  Vec2 on_screen(const Vec2& place) const { return centre_ + (place - middle_) * (half_ * zoom_); }

  Vec2 middle_{0};  // of the view, in the coordinates of the layout
  double zoom_ = 1;
  Vec2 centre_{0}, size_{0};  // of the field, screen coordinates
  double half_ = 1;           // pixels per unit of the layout before zooming
  double radius_ = 1;         // of a node that is a single face, pixels
  bool dragged_ = false, hovered_ = false;
  std::vector<double> room_;  // distance of each node from the nearest other one, in the layout
  Framing framing_ = Framing::kAll;
};

}  // namespace kerf
