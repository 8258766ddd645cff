#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/cut_effects.h"
#include "core/graph/drawn_graph.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// A field of a panel in which a graph is drawn. The wheel zooms to the pointer, and a drag moves the graph.
// At first the environment of a node are shown, as near as it takes to tell nodes apart.
class GraphCanvas {
 public:
  struct Pointer {
    std::optional<uint32_t> over, clicked;  // drawn nodes
  };
  // What is drawn: the nodes `lit` and `start` with a ring around them, and a bar of so many lengths of the
  // file as a link is long on average, where places are as far from each other as the faces are.
  struct Drawn {
    const DrawnGraph& graph;
    const GraphLayout& places;
    std::optional<uint32_t> lit, start;
    std::optional<FileUnit> scale;
  };

  // Draws the graph in the full width that is left, `height` pixels high. Preconditions: there is one place
  // for each node, and `lit` and `start` are nodes.
  Pointer draw(const Drawn& drawn, float height);

  // Shows the whole graph from the next draw() on, or the environment of its `start`.
  void fit() { wish_ = Wish::kAll; }
  void come_near() { wish_ = Wish::kStart; }
  // Whether the pointer was over it when it was drawn last.
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

  Vec2 middle_{0};  // of what is seen, in the coordinates of the layout
  double zoom_ = 1;
  Vec2 centre_{0}, size_{0};  // of the field, screen coordinates
  double half_ = 1;           // pixels of the unit of the layout before zooming
  double radius_ = 1;         // of a node that is a single face, pixels
  bool dragged_ = false, hovered_ = false;
  Wish wish_ = Wish::kStart;
};

// A row of the tree of pieces.
struct PieceTreeRow {
  PieceNode origin;
  int depth = 0;  // 0 for what is left of a body
};

// The pieces as a tree: under each piece those that came off it, in the order of their steps.
std::vector<PieceTreeRow> piece_tree(const std::vector<PieceNode>& origins);

// What a piece came off, what holds it, and what stands with it, in sentences. Precondition: its body exists.
std::string words_on(const PieceNode& node, const Document& document, FileUnit unit);

// Draws them: what came off what, in which step of the history, what holds it, and how many faces are left of
// it. A click chooses a piece, on which there are a few words then.
void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view);

}  // namespace kerf
