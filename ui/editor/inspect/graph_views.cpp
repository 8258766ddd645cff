#include "ui/editor/inspect/graph_views.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <system_error>

#include "core/base/assert.h"
#include "core/document/extract.h"
#include "core/joints/joined_parts.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/render/passes/mark_passes.h"
#include "ui/render/view/colours.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kPlaySeconds = 6;  // for a whole traversal

std::vector<size_t> closings_of(const World& world, const CutFaces& removed) {
  std::vector<size_t> closings;
  size_t removals = 0;
  for (const auto& [body, faces] : removed) {
    if (!world.contains(body)) continue;
    for (const CutFace& f : faces) {
      ++removals;
      if (f.closed_loop) closings.push_back(removals);
    }
  }
  return closings;
}

constexpr size_t kMaxRows = 500, kRowsInSight = 14;

// Sorts depth-first, and the pieces of one parent by step.
class TreeOrder {
 public:
  explicit TreeOrder(const std::vector<PieceNode>& origins) {
    for (const PieceNode& o : origins) known_[o.piece] = true;
    for (const PieceNode& o : origins) {
      if (has_parent(o)) children_[*o.came_off].push_back(o);
    }
    for (auto& [parent, children] : children_)
      std::stable_sort(children.begin(), children.end(),
                       [](const PieceNode& a, const PieceNode& b) { return a.step < b.step; });
    for (const PieceNode& o : origins) {
      if (!has_parent(o)) add(o, o.came_off ? 1 : 0);
    }
  }
  std::vector<PieceTreeRow> take() { return std::move(rows_); }

 private:
  // A piece without faces has no row.
  bool has_parent(const PieceNode& o) const { return o.came_off && known_.contains(*o.came_off); }
  void add(const PieceNode& origin, int depth) {
    rows_.push_back({origin, depth});
    const auto found = children_.find(origin.piece);
    if (found == children_.end()) return;
    for (const PieceNode& child : found->second) add(child, depth + 1);
  }

  std::map<PieceId, bool> known_;
  std::map<PieceId, std::vector<PieceNode>> children_;
  std::vector<PieceTreeRow> rows_;
};

ImU32 colour_of_piece(const World& world, const ViewState& view, const PieceId& id) {
  const auto look = view.look.pieces.find(id);
  const bool numbered = look != view.look.pieces.end() && look->second.number != 0;
  const bool part = is_loaded_part(world.body(id.body), id.label);
  const uint32_t number = part ? 0 : numbered ? look->second.number : id.label;
  const Vec3 c = strong_piece_colour(number);
  return ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1});
}

bool is_part(const World& world, const PieceId& id) {
  if (!world.contains(id.body)) return false;
  const Body& body = world.body(id.body);
  return id.label < body.pieces.size() && is_loaded_part(body, id.label);
}

// Returns the name of a piece. `part`: the name that a row has for it as a loaded part.
std::string row_name(const World& world, const PieceMap& looks, const PieceId& id, const std::string& part) {
  return !part.empty() && is_part(world, id) ? part : name_of_piece(world, looks, id);
}

std::string origin_words(const PieceTreeRow& row, const Document& document, const PieceMap& looks,
                         FileUnit unit) {
  const PieceNode& node = row.origin;
  const Body& body = document.world().body(node.piece.body);
  if (is_loaded_part(body, node.piece.label)) return "is a part that no cut separated";
  if (!node.came_off)
    return node.piece.label == 0 ? "is the rest of its body" : "came off in an unknown step";
  const PieceId from = *node.came_off;
  const std::string name = document.world().contains(from.body)
                               ? row_name(document.world(), looks, from, row.parent_name)
                               : "a deleted piece";
  const std::string did = step_words(document.history(), node.step, unit);
  return "came off " + name + " in step " + std::to_string(node.step + 1) + " (" + did + ")";
}

std::string holder_words(const PieceNode& node) {
  const std::string parts = grouped(node.parts) + " parts";
  switch (node.held_by) {
    case Holder::kNothing:
      return node.beside > 0 ? "Nothing holds it: it stays until it is moved or time passes."
                             : "Nothing holds it: it is a body of its own.";
    case Holder::kItself:
      return "The mesh is connected.";
    case Holder::kBody:
      return "Its " + parts + " were never connected; they move together because they are one body.";
    case Holder::kPin:
      return node.parts > 1 ? "Its " + parts + " are one body, which is pinned."
                            : "Its body is pinned: it does not move.";
  }
  return "";
}

void draw_row(const PieceTreeRow& row, const Document& document, ViewState& view) {
  const PieceId id = row.origin.piece;
  const Body& body = document.world().body(id.body);
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const auto look = view.look.pieces.find(id);
  const bool selected = look != view.look.pieces.end() && look->second.selected;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float x = at.x + em * (0.5f + static_cast<float>(row.depth)), y = at.y + 0.5f * line;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (row.depth > 0) {
    list.AddLine({x - em, at.y - 0.3f * line}, {x - em, y}, colours::secondary());
    list.AddLine({x - em, y}, {x - 0.4f * em, y}, colours::secondary());
  }
  list.AddCircleFilled({x, y}, 0.32f * em, colour_of_piece(document.world(), view, id));
  ImGui::SetCursorScreenPos({x + 0.8f * em, at.y});
  const std::string name = row_name(document.world(), view.look.pieces, id, row.name);
  const std::string label = whole_label(fitted_text(name, ImGui::GetContentRegionAvail().x)) + "###name";
  if (ImGui::Selectable(label.c_str(), selected, ImGuiSelectableFlags_SpanAllColumns)) {
    select_piece(view.look.pieces, id, ImGui::GetIO().KeyShift);
    view.picture_old = true;
  }
  mark_last_item("piece node", static_cast<int>(id.label));
  if (!selected && ImGui::IsItemHovered())
    tooltip(words_on(row, document, view.look.pieces, view.frame.unit).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.origin.came_off ? ("step " + std::to_string(row.origin.step + 1)).c_str() : "");
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name_of(row.origin.held_by));
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(grouped(body.pieces[id.label].faces).c_str());
}

void draw_words(const std::vector<PieceTreeRow>& rows, const Document& document, const ViewState& view) {
  const std::optional<PieceId> selected = first_selected(view.look.pieces);
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const PieceTreeRow& r) { return r.origin.piece == selected; });
  if (row == rows.end()) return;
  ImGui::TextWrapped("%s", words_on(*row, document, view.look.pieces, view.frame.unit).c_str());
  mark_last_item("piece words");
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
  marked_ = removed_ = removals_ = cut_off_ = 0;
  playing_ = false;
}

void GraphState::forget() {
  clear();
  key_ = {};
  piece_.reset();
  left_out_ = 0;
  asked_ = false;
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
  cut_off_ = cut ? document.history().step(*cut).totals().came_off.size() : 0;
  graph_ = cut_graph(document.world(), removed);
  removed_ = removals_ = graph_.nodes.size() - graph_.live;
  closings_ = closings_of(document.world(), removed);
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

std::optional<FaceId> face_of_text(std::string_view text) {
  uint32_t number = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  return end == last && error == std::errc() ? std::optional(FaceId(number)) : std::nullopt;
}

void name_loaded_parts(std::vector<PieceTreeRow>& rows, const World& world, const PieceMap& looks) {
  std::map<PieceId, std::string> names;
  const auto name_of_part = [&](const PieceId& id) -> std::string {
    if (!is_part(world, id)) return "";
    const auto [entry, added] = names.try_emplace(id);
    if (added) entry->second = name_of_piece(world, looks, id);
    return entry->second;
  };
  for (size_t i = 0; i < std::min(rows.size(), kMaxRows); ++i) {
    const PieceNode& origin = rows[i].origin;
    rows[i].name = name_of_part(origin.piece);
    if (origin.came_off) rows[i].parent_name = name_of_part(*origin.came_off);
  }
}

std::string words_on(const PieceTreeRow& row, const Document& document, const PieceMap& looks,
                     FileUnit unit) {
  const PieceNode& node = row.origin;
  const std::string name = row_name(document.world(), looks, node.piece, row.name);
  const std::string others = node.piece.label != 0 || node.beside == 0 ? ""
                             : node.beside == 1
                                 ? " One piece that came off still stands with it."
                                 : " " + grouped(node.beside) + " pieces that came off still stand with it.";
  return name + " " + origin_words(row, document, looks, unit) + ". " + holder_words(node) + others;
}

std::vector<PieceTreeRow> piece_tree(const std::vector<PieceNode>& origins) {
  return TreeOrder(origins).take();
}

void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const auto lines = static_cast<float>(std::clamp<size_t>(rows.size() + 1, 2, kRowsInSight));
  const float height = lines * (ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y);
  if (!ImGui::BeginTable("piece nodes", 4, kList, {0, height})) return;
  ImGui::TableSetupColumn("Piece", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Came Off", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("Held By", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("Faces", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableHeadersRow();
  for (size_t i = 0; i < std::min(rows.size(), kMaxRows); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_row(rows[i], document, view);
    ImGui::PopID();
  }
  ImGui::EndTable();
  if (rows.size() > kMaxRows)
    ImGui::TextDisabled("%s more not listed.", grouped(rows.size() - kMaxRows).c_str());
  draw_words(rows, document, view);
}

}  // namespace kerf
