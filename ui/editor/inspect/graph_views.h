#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/parallel.h"
#include "core/document/document.h"
#include "core/graph/drawn_graph.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The state of the Graph panel and of its overlay in the viewport: the component graph of the last stroke,
// with an animated traversal.
class GraphState {
 public:
  // Source of the nodes: the bodies that the last stroke cut, or one piece.
  enum class Subject { kCut, kPiece };
  enum class Placing { kUnrolled, kPosition, kForce };

  // Updates the graph to the document, except while a stroke is being cut, when the earlier graph stays. In
  // step mode it is updated then, too, if the world has at most kMaxAtStages faces. Returns true if anything
  // changed. Linear in the faces of the bodies that the last stroke cut if it did.
  bool follow(const Document& document, bool in_single_steps = false);
  // Returns true if the document has changed since follow().
  bool is_old(const Document& document) const { return !(key_ == key_of(document)); }

  // Discards the graph of a document that was closed; the layout and the scope stay.
  void forget();

  // From the next follow() on, shows the graph of one piece (nullopt: of none), or again that of the cut.
  void show_piece(std::optional<PieceId> piece);
  void show_cut();
  bool shows_piece() const { return subject_ == Subject::kPiece; }

  // Larger bodies take too long between two frames: their graph is left out until it is requested, and then
  // read in the background (see graph_reading).
  static constexpr size_t kMaxAtOnce = 300'000, kMaxAtStages = 20'000;
  bool is_left_out() const { return left_out_ > 0; }
  size_t left_out() const { return left_out_; }  // faces
  void request_left_out() { asked_ = is_left_out(); }
  bool is_asked_for() const { return asked_; }
  void cancel_request() { asked_ = false; }
  // Reads the left-out graph of the document that was followed last. Returns false if `progress` stopped it,
  // which leaves the graph empty. Precondition: is_left_out().
  bool read_left_out(const Document& document, const Progress& progress);

  // The drawn graph and its layout; null and empty if no face is live.
  const std::shared_ptr<const DrawnGraph>& drawn() const { return drawn_; }
  const GraphLayout& layout() const { return layout_; }

  // Changes with each graph and each layout, which then have to be framed again.
  size_t number() const { return number_; }

  GraphScope scope() const { return scope_; }
  Placing placing() const { return placing_; }
  // Returns true if the layout is by position because the cut is not a loop (see lay_out_unrolled).
  bool cannot_unroll() const { return placing_ == Placing::kUnrolled && !unrolled_; }
  void show(GraphScope scope);
  void place(Placing placing);

  // Clusters that are drawn expanded.
  void open(uint32_t drawn_node);
  void close_all();
  bool any_open() const { return !opened_.empty(); }

  // The start of the traversal. Precondition of start_from: the node is drawn and not removed.
  void start_from(uint32_t drawn_node);
  uint32_t start() const { return start_; }

  // Progress of the animated traversal, in faces; advance() returns true if anything changed.
  size_t marked() const { return marked_; }
  void set_marked(size_t faces);
  bool playing() const { return playing_; }
  void play(bool on);
  bool advance(double seconds);

  // Number of removals drawn as done; the loops that they closed are drawn in the viewport.
  size_t removals() const { return removals_; }
  void set_removals(size_t faces);

  // Statistics of the traversal, which is complete when marked() == reached().
  size_t reached() const { return traversal_.reached(); }
  size_t total() const { return traversal_.total; }
  bool separated() const { return traversal_.separated(); }
  size_t sets() const { return traversal_.sets; }
  size_t removed() const { return removed_; }
  // The number of pieces that the last stroke cut off. Those that were moved or deleted since are no longer
  // in its bodies, which the traversal does not leave.
  size_t cut_off() const { return cut_off_; }

  // The removals of the stroke that closed a loop of removed faces (see CutLoops), in order and numbered from
  // 1 up to removed(); and whether all faces that the stroke removed are kept.
  const std::vector<size_t>& closings() const { return closings_; }
  bool complete() const { return complete_; }

  // The live face of a drawn node, if it is a single one; the drawn node of a face.
  std::optional<FaceOfBody> face_of(uint32_t drawn_node) const;
  std::optional<uint32_t> node_of(const FaceOfBody& face) const;

 private:
  struct Key {
    size_t revision = 0, position = 0, commands = 0, faces = 0, bodies = 0;
    std::optional<PieceId> piece;
    bool known = false;
    friend bool operator==(const Key&, const Key&) = default;
  };
  Key key_of(const Document& document) const;
  void pass_over_time(const Document& document);
  size_t faces_to_read(const Document& document) const;
  bool read(const Document& document, const Progress* progress);
  void read_cut(const Document& document);
  void clear();
  void traverse_from(uint32_t node);
  void draw_again();
  void publish_marked();

  Key key_;
  Subject subject_ = Subject::kCut;
  std::optional<PieceId> piece_;
  CutGraph graph_;
  CutTraversal traversal_;
  uint32_t start_ = 0;  // node of graph_
  std::vector<uint32_t> opened_;
  GraphScope scope_ = GraphScope::kAroundCut;
  Placing placing_ = Placing::kUnrolled;
  std::shared_ptr<const DrawnGraph> drawn_;
  GraphLayout layout_;
  size_t marked_ = 0, removed_ = 0, removals_ = 0, left_out_ = 0, cut_off_ = 0;
  bool asked_ = false;
  double played_ = 0;  // faces, with a fraction
  bool playing_ = false, complete_ = true, unrolled_ = false;
  size_t number_ = 0;
  std::vector<size_t> closings_;
  std::vector<LoopPath> loops_;
};

// Returns the face of a typed number; nullopt if the text is not a whole number or too large.
std::optional<FaceId> face_of_text(std::string_view text);

struct PieceTreeRow {
  PieceNode origin;
  int depth = 0;  // 0 for the remainder of a body
  // Names of the piece and of the one that it came off, if they are loaded parts; else empty.
  std::string name = {}, parent_name = {};
};

// Builds the tree of pieces. The children of a piece are the pieces cut off it, in the order of their steps.
std::vector<PieceTreeRow> piece_tree(const std::vector<PieceNode>& origins);

// Names the loaded parts among the pieces of the rows that the panel lists, so that drawing does not search
// their faces again. O(faces) per part. Precondition: the bodies of the rows exist.
void name_loaded_parts(std::vector<PieceTreeRow>& rows, const World& world, const PieceMap& looks);

// Describes a piece: its origin, its holder, and pieces still in place. O(faces) for loaded parts that
// name_loaded_parts() has not named. Precondition: its body exists.
std::string words_on(const PieceTreeRow& row, const Document& document, const PieceMap& looks, FileUnit unit);

// Draws the tree: origin, history step, holder and remaining faces of each piece. A click selects a visible
// piece and shows its description.
void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view);

}  // namespace kerf
