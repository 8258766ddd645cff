#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/cut_effects.h"
#include "core/graph/drawn_graph.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// A field of a panel that draws a graph. The wheel zooms to the pointer, and a drag moves the graph. At
// first it shows the neighbourhood of a node, near enough to tell nodes apart.
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
  void fit() { framing_ = Wish::kAll; }
  void show_start() { framing_ = Wish::kStart; }
  // Returns true if the pointer was over it at the last draw().
  bool hovered() const { return hovered_; }

 private:
  enum class Wish { kNone, kAll, kStart };
  void execute_requests(const Drawn& drawn, double link);
  void listen();
  void draw_links(const DrawnGraph& graph, const GraphLayout& places, double link) const;
  std::optional<uint32_t> draw_nodes(const DrawnGraph& graph, const GraphLayout& places) const;
  void draw_ring(const DrawnGraph& graph, const GraphLayout& places, uint32_t node, uint32_t colour) const;
  void draw_scale(const DrawnGraph& graph, const GraphLayout& places, FileUnit unit) const;
  double radius_of(const DrawnGraph::Node& node) const;
  Vec2 on_screen(const Vec2& place) const { return centre_ + (place - middle_) * (half_ * zoom_); }

  Vec2 middle_{0};  // of the view, in the coordinates of the layout
  double zoom_ = 1;
  Vec2 centre_{0}, size_{0};  // of the field, screen coordinates
  double half_ = 1;           // pixels per unit of the layout before zooming
  double radius_ = 1;         // of a node that is a single face, pixels
  bool dragged_ = false, hovered_ = false;
  Wish framing_ = Wish::kStart;
};

struct PieceTreeRow {
  PieceNode origin;
  int depth = 0;  // 0 for the remainder of a body
};

// Builds the tree of pieces: under each piece those that came off it, in the order of their steps.
std::vector<PieceTreeRow> piece_tree(const std::vector<PieceNode>& origins);

// Describes a piece: its origin, its holder, and pieces still in place. Precondition: its body exists.
std::string words_on(const PieceNode& node, const Document& document, FileUnit unit);

// Draws the tree: origin, history step, holder and remaining faces of each piece. A click selects a piece
// and shows its description.
void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view);

}  // namespace kerf
