#include "ui/editor/inspect/graph_state.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/document/edit_piece.h"

namespace kerf {

namespace {

constexpr double kPlaySeconds = 6;  // for a whole traversal

std::vector<size_t> closings_of(const CutFaces& removed) {
  std::vector<size_t> closings;
  size_t removals = 0;
  for (const auto& [body, faces] : removed) {
    for (const CutFace& f : faces) {
      ++removals;
      if (f.closed_loop) closings.push_back(removals);
    }
  }
  return closings;
}

}  // namespace

GraphState::Key GraphState::key_of(const Document& document) const {
  return {document.revision(),
          document.history().position(),
          document.journal().size(),
          document.world().live_faces(),
          document.world().ids().size(),
          piece_,
          true};
}

// Counts the faces of the piece, of the bodies that the last stroke cut, or of all bodies if there is none.
size_t GraphState::faces_to_read(const Document& document) const {
  const World& world = document.world();
  if (shows_piece())
    return piece_ && has_faces(world, *piece_) ? world.body(piece_->body).pieces[piece_->label].faces : 0;
  const CutFaces removed = last_cut_faces(document.history());
  size_t faces = 0;
  for (const BodyId id : world.ids()) {
    if (removed.empty() || removed.contains(id)) faces += world.body(id).mesh.live_faces();
  }
  return faces;
}

void GraphState::show_piece(std::optional<PieceId> piece) {
  if (!shows_piece()) key_.known = false;
  subject_ = Subject::kPiece;
  piece_ = piece;
}

void GraphState::show_cut() {
  if (shows_piece()) key_.known = false;
  subject_ = Subject::kCut;
  piece_.reset();
}

// Skips commands that only let time pass, which leave the graph unchanged.
void GraphState::pass_over_time(const Document& document) {
  const std::vector<Command>& journal = document.journal();
  if (key_.commands >= journal.size()) return;
  const auto in_time = [](const Command& c) {
    return std::visit([]<typename C>(const C&) { return TimedCommand<C>; }, c);
  };
  const auto fresh = journal.begin() + static_cast<ptrdiff_t>(key_.commands);
  if (std::all_of(fresh, journal.end(), in_time)) key_.commands = journal.size();
}

bool GraphState::follow(const Document& document, bool in_single_steps) {
  pass_over_time(document);
  if (!is_old(document)) return false;
  const bool cuts = document.queue().in_stroke() || document.queue().pending().holds_beam() ||
                    document.queue().next_searches();
  const bool cutting = key_.known && cuts;
  if (cutting && !in_single_steps) return false;
  if (cutting && document.world().live_faces() > kMaxAtStages) return false;
  key_ = key_of(document);
  const size_t faces = faces_to_read(document);
  left_out_ = faces > kMaxAtOnce ? faces : 0;
  asked_ = false;
  if (is_left_out()) {
    clear();
  } else {
    read(document, nullptr);
  }
  return true;
}

bool GraphState::read_left_out(const Document& document, const Progress& progress) {
  KERF_ASSERT(is_left_out());
  asked_ = false;
  if (!read(document, &progress)) {
    clear();
    return false;
  }
  left_out_ = 0;
  return true;
}

void GraphState::clear() {
  ++number_;
  graph_ = CutGraph();
  traversal_ = CutTraversal();
  drawn_.reset();
  layout_.clear();
  opened_.clear();
  closings_.clear();
  loops_.clear();
  marked_ = removed_ = removals_ = 0;
  playing_ = false;
}

bool GraphState::read(const Document& document, const Progress* progress) {
  const auto goes_on = [&](double done) { return progress == nullptr || progress->report(done); };
  clear();
  if (!goes_on(0)) return false;
  if (!shows_piece()) {
    read_cut(document);
  } else if (piece_ && has_faces(document.world(), *piece_)) {
    complete_ = true;
    graph_ = piece_graph(document.world(), *piece_);
  }
  if (!goes_on(0.4)) return false;
  const std::optional<uint32_t> start = start_next_to_cut(graph_);
  if (!start) return true;
  traverse_from(*start);
  if (!goes_on(0.7)) return false;
  draw_again();
  return goes_on(1);
}

void GraphState::read_cut(const Document& document) {
  const CutFaces removed = last_cut_faces(document.history());
  const auto cut = document.history().last_cut();
  complete_ = !cut || document.history().step(*cut).totals().has_all_cut_faces();
  graph_ = cut_graph(document.world(), removed);
  removed_ = removals_ = graph_.nodes.size() - graph_.live;
  closings_ = closings_of(removed);
  loops_ = loop_paths(document.world(), removed);
}

void GraphState::traverse_from(uint32_t node) {
  KERF_ASSERT(node < graph_.nodes.size());
  start_ = node;
  traversal_ = traverse_cut(graph_, node);
  marked_ = traversal_.reached();
}

void GraphState::draw_again() {
  const GraphScope shown = shows_piece() ? GraphScope::kWhole : scope_;
  auto drawn = std::make_shared<DrawnGraph>(draw_graph(graph_, traversal_, shown, opened_));
  drawn->marked = marked_;
  drawn->removals = removals_;
  drawn->loops = loops_;
  std::optional<GraphLayout> unrolled;
  if (placing_ == Placing::kUnrolled) unrolled = lay_out_unrolled(*drawn);
  unrolled_ = unrolled.has_value();
  layout_ = unrolled_                     ? std::move(*unrolled)
            : placing_ == Placing::kForce ? lay_out_by_force(*drawn)
                                          : lay_out_by_position(*drawn);
  KERF_ASSERT(layout_.size() == drawn->nodes.size());
  drawn_ = std::move(drawn);
}

void GraphState::show(GraphScope scope) {
  scope_ = scope;
  ++number_;
  opened_.clear();
  if (drawn_) draw_again();
}

void GraphState::place(Placing placing) {
  placing_ = placing;
  ++number_;
  if (drawn_) draw_again();
}

void GraphState::open(uint32_t drawn_node) {
  KERF_ASSERT(drawn_ && drawn_node < drawn_->nodes.size());
  opened_.push_back(drawn_->nodes[drawn_node].lowest);
  draw_again();
}

void GraphState::close_all() {
  opened_.clear();
  if (drawn_) draw_again();
}

void GraphState::start_from(uint32_t drawn_node) {
  KERF_ASSERT(drawn_ && drawn_node < drawn_->nodes.size() && !drawn_->nodes[drawn_node].removed);
  traverse_from(drawn_->nodes[drawn_node].lowest);
  draw_again();
}

void GraphState::set_marked(size_t faces) {
  marked_ = std::min(faces, reached());
  publish_marked();
}

void GraphState::publish_marked() {
  if (!drawn_) return;
  auto drawn = std::make_shared<DrawnGraph>(*drawn_);
  drawn->marked = marked_;
  drawn->removals = removals_;
  drawn_ = std::move(drawn);
}

void GraphState::set_removals(size_t faces) {
  removals_ = std::min(faces, removed_);
  publish_marked();
}

void GraphState::play(bool on) {
  playing_ = on && drawn_ != nullptr;
  if (playing_ && marked_ == reached()) marked_ = 0;
  played_ = static_cast<double>(marked_);
}

bool GraphState::advance(double seconds) {
  if (!playing_) return false;
  played_ += std::max(1.0, static_cast<double>(reached()) * seconds / kPlaySeconds);
  set_marked(static_cast<size_t>(played_));
  playing_ = marked_ < reached();
  return true;
}

std::optional<FaceOfBody> GraphState::face_of(uint32_t drawn_node) const {
  KERF_ASSERT(drawn_ && drawn_node < drawn_->nodes.size());
  const DrawnGraph::Node& n = drawn_->nodes[drawn_node];
  if (n.removed || n.faces != 1) return std::nullopt;
  return FaceOfBody{n.face.body, n.face.face};
}

std::optional<uint32_t> GraphState::node_of(const FaceOfBody& face) const {
  if (!drawn_) return std::nullopt;
  const auto end = graph_.nodes.begin() + graph_.live;
  const auto found =
      std::lower_bound(graph_.nodes.begin(), end, face, [](const GraphNode& n, const FaceOfBody& f) {
        return n.body != f.body ? n.body < f.body : n.face < f.face;
      });
  if (found == end || found->body != face.body || found->face != face.face) return std::nullopt;
  const uint32_t drawn = drawn_->of[static_cast<size_t>(found - graph_.nodes.begin())];
  return drawn == DrawnGraph::kNone ? std::nullopt : std::optional(drawn);
}

}  // namespace kerf
