#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/cut_effects.h"
#include "ui/editor/inspect/graph_canvas.h"
#include "ui/editor/inspect/graph_views.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_browser.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/render/view/view_options.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

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
  // Discards the pieces and the typed face of a document that was closed.
  void forget();

 private:
  // The pieces are unchanged while these are equal.
  struct PiecesKey {
    size_t commands = 0, revision = 0, pieces = 0, position = 0;
    friend bool operator==(const PiecesKey&, const PiecesKey&) = default;
  };
  void draw_rows(GraphState& graph, const Document& document, ViewState& view);
  void draw_rows_of_faces(GraphState& graph, const Document& document, const ViewState& view);
  void find_row(GraphState& graph, const Document& document);
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
  std::array<char, 12> typed_{};      // number of the face to find
  std::optional<size_t> missing_in_;  // number() of a graph of which no node shows it
  std::vector<PieceTreeRow> rows_;
  std::optional<PiecesKey> rows_of_;  // nullopt: the rows were not computed
};

namespace {

constexpr std::array kNodes{"Faces Around the Cut", "Faces of Whole Bodies", "Faces of Selected Piece",
                            "Pieces"};

constexpr std::array kPlacings{"Unrolled Along the Cut", "By Position", "By Force"};
constexpr float kMinGap = 3;            // pixels, between two marks of loops
constexpr float kHeightOfWidth = 0.8f;  // of the canvas below the rows
// Sizes of the text: the width of a panel from which on its rows are next to the canvas, and their width.
constexpr float kWide = 44, kRows = 24;

void placing_row(GraphState& graph) {
  property("Layout");
  const bool positioned = graph.cannot_unroll() && graph.removed() > 0;
  const char* shown =
      positioned ? "By Position (Cut Is Not a Loop)" : kPlacings.at(static_cast<size_t>(graph.placing()));
  if (begin_fitted_combo("##placing", shown)) {
    for (size_t i = 0; i < kPlacings.size(); ++i) {
      const auto placing = static_cast<GraphState::Placing>(i);
      if (ImGui::Selectable(kPlacings.at(i), placing == graph.placing())) graph.place(placing);
    }
    ImGui::EndCombo();
    return;
  }
  mark_last_item("graph placing");
  tooltip(
      "Unrolled along a closed cut; by position along the thinnest direction; or by forces between nodes.");
}

// Draws the slider of the traversal, which the button plays.
void traversal_row(GraphState& graph) {
  property("Traversal");
  if (ImGui::Button(graph.playing() ? "Stop" : "Play")) graph.play(!graph.playing());
  mark_last_item("graph play");
  tooltip("Plays the breadth-first search from the ringed node; reached faces are blue.");
  ImGui::SameLine();
  int marked = static_cast<int>(graph.marked());
  ImGui::SetNextItemWidth(-1);
  if (whole_slider(
          {"Traversal", "##marked", "Faces marked by the search. Click a single face to start from it."},
          marked, 0, static_cast<int>(graph.reached()), count_text(graph.marked(), "face"))) {
    graph.play(false);
    graph.set_marked(static_cast<size_t>(marked));
  }
  mark_last_item("graph slider");
}

// Draws a line below the last slider for each removal that closed a loop.
void mark_closings(const GraphState& graph) {
  const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
  const float em = ImGui::GetFontSize(), grab = ImGui::GetStyle().GrabMinSize;
  const float width = most.x - least.x - grab - 4;
  float last = -kMinGap;
  for (const size_t closing : graph.closings()) {
    const float share = static_cast<float>(closing) / static_cast<float>(graph.removed());
    const float x = std::round(least.x + 2 + 0.5f * grab + share * width);
    if (x < last + kMinGap) continue;
    last = x;
    ImGui::GetWindowDrawList()->AddLine({x, most.y + 1}, {x, most.y + 0.4f * em}, colours::secondary(), 1);
  }
  ImGui::Dummy({0, 0.1f * em});
}

// Draws the removals in their order, and marks those that closed a loop.
void removals_row(GraphState& graph, const ViewState& view) {
  property("Removals");
  int removals = static_cast<int>(graph.removals());
  ImGui::SetNextItemWidth(-1);
  const auto& closings = graph.closings();
  const auto closed = std::upper_bound(closings.begin(), closings.end(), graph.removals()) - closings.begin();
  const std::string loops = count_text(static_cast<size_t>(closed), "loop");
  const std::string meaning = with_shortcut(
      view, ("Removed faces, which closed " + loops + " (ticks). The viewport can show them.").c_str(),
      action_id(view_switch(SwitchId::kGraph)));
  if (whole_slider({"Removals", "##removals", meaning.c_str()}, removals, 0,
                   static_cast<int>(graph.removed()), grouped(graph.removals())))
    graph.set_removals(static_cast<size_t>(removals));
  mark_last_item("graph removals");
  mark_closings(graph);
}

std::string verdict(const GraphState& graph) {
  if (graph.marked() < graph.reached()) return "Searching...";
  if (graph.shows_piece()) return "The search reached every face connected to the first.";
  if (graph.removed() == 0) return "No cut yet.";
  const size_t rest = graph.total() - graph.reached();
  if (!graph.separated() && graph.cut_off() > 0)
    return "Separated: the stroke cut off " + count_text(graph.cut_off(), "piece") +
           (graph.cut_off() == 1 ? ", which is" : ", which are") + " no longer in this body.";
  if (!graph.separated()) return "Not separated: the search reached every face that was connected before.";
  const size_t others = graph.sets() - 1;
  return "Separated: " + count_text(rest, "face") + " in " + count_text(others, "other part") +
         (rest == 1 ? " was" : " were") + " not reached.";
}

// Describes the search by Kerf, which differs from this one.
std::string loops_text(const GraphState& graph) {
  const std::vector<size_t>& closings = graph.closings();
  const std::string of = " of " + grouped(graph.removed()) + " removals";
  if (closings.empty()) return "Kerf itself did not search: none" + of + " closed a loop.";
  return "Kerf only searches when removed faces close a loop: " + grouped(closings.size()) + of +
         " closed one, the first with removal " + grouped(closings.front()) + ".";
}

void draw_verdict(const GraphState& graph) {
  ImGui::TextWrapped("Reached %s of %s", grouped(graph.marked()).c_str(), grouped(graph.total()).c_str());
  ImGui::TextWrapped("%s", verdict(graph).c_str());
  mark_last_item("graph verdict");
  if (graph.removed() > 0) secondary_text(loops_text(graph));
  if (!graph.complete()) secondary_text("Some faces that the stroke removed are no longer stored.");
}

void explain(const GraphState& graph, const Document& document, const PieceMap& looks, uint32_t node) {
  const DrawnGraph::Node& n = graph.drawn()->nodes[node];
  if (!document.world().contains(n.face.body)) return;
  const std::string piece = name_of_piece(document.world(), looks, {n.face.body, n.face.piece});
  std::string text = n.faces == 1 ? "Face " + std::to_string(n.face.face.index) : grouped(n.faces) + " faces";
  text += (n.removed ? ", removed from " : " of ") + piece;
  if (n.faces > 1) text += " - click to expand";
  ImGui::SetTooltip("%s", text.c_str());
}

// Reads the requested graph in the background and passes it to `graph`, which must outlive it; if stopped,
// the graph stays left out. Does not change the document. Precondition: graph.is_asked_for().
LongChange graph_reading(GraphState& graph) {
  KERF_ASSERT(graph.is_asked_for());
  graph.cancel_request();
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

constexpr const char* kGraphPanel = "graph";

class GraphFeature : public Feature {
 public:
  explicit GraphFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{kGraphPanel, [this] {
               const bool seen = workspace_.input.points() && !workspace_.view.in_second;
               panel_.draw(graph_, workspace_.session.document, workspace_.view,
                           seen ? std::optional(workspace_.input.pointer) : std::nullopt);
             }}};
  }
  std::vector<UserAction> actions() override {
    return {make_action("graph.export", "Export Graph...", "",
                        "Writes the graph of the Graph panel to an image (.svg).", [this] { select_file(); },
                        {.disabled_reason = [this] {
                          return graph_.drawn() ? nullptr : "Open the Graph panel first: it reads the graph.";
                        }})};
  }
  std::vector<Gesture> gestures() const override {
    return {{"fit_graph", "F over the graph", "Show all of it, while the pointer is over it"}};
  }
  bool handle_event(const InputEvent& event, bool) override {
    const bool fits = event.kind == InputEvent::Kind::kKey && event.button == GLFW_KEY_F && event.mods == 0;
    return fits && panel_.fit_under_pointer();
  }

  void on_document_opened() override {
    graph_.forget();
    panel_.forget();
    workspace_.view.look.graph.reset();
    workspace_.view.look.lit_face.reset();
  }
  void after_queue(double seconds) override {
    ViewState& view = workspace_.view;
    const Document& document = workspace_.session.document;
    const bool panel = workspace_.services.panels.shows(kGraphPanel);
    if (!panel && view.look.lit_face) {
      view.look.lit_face.reset();
      view.picture_old = true;
    }
    if (!panel && !view.look.show.graph) return graph_.play(false);
    graph_.follow(document, workspace_.links.holds_back());
    graph_.advance(std::min(seconds, Workspace::kLongestStep));
    if (graph_.is_asked_for() && !workspace_.changes.is_pending() && !document.queue().in_stroke() &&
        document.waiting() == 0)
      workspace_.changes.begin(graph_reading(graph_));
    if (view.look.graph == graph_.drawn()) return;
    view.look.graph = graph_.drawn();
    if (view.look.show.graph) view.picture_old = true;
  }
  bool needs_redraw() const override { return graph_.playing(); }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["graph"] = {{"nodes", graph_.drawn() ? graph_.drawn()->nodes.size() : 0},
                       {"marked", graph_.marked()},
                       {"reached", graph_.reached()},
                       {"total", graph_.total()},
                       {"removed", graph_.removed()},
                       {"removals", graph_.removals()},
                       {"closings", graph_.closings().size()},
                       {"loops", graph_.drawn() ? graph_.drawn()->loops.size() : 0},
                       {"of_piece", graph_.shows_piece()},
                       {"any_open", graph_.any_open()},
                       {"face_lit", workspace_.view.look.lit_face.has_value()}};
  }

 private:
  void select_file() {
    browse(workspace_.services.browser,
           {.title = "Export Graph",
            .verb = "Export",
            .hint = "File name (.svg)",
            .endings = {".svg"},
            .take = [this](const std::filesystem::path& file) { return export_to(file); },
            .inputs = [this] { return inputs_of(workspace_.session); }},
           workspace_.settings.folder, "graph.svg");
  }
  // The panel may have been hidden since the graph was read.
  std::string export_to(const std::filesystem::path& file) {
    graph_.follow(workspace_.session.document, workspace_.links.holds_back());
    if (graph_.is_left_out()) return "Draw the graph of the large mesh in the Graph panel first";
    if (!graph_.drawn()) return "There is no graph";
    const Status written = write_file_atomically(file, graph_svg(*graph_.drawn(), graph_.layout()));
    if (!written) return written.error().message;
    workspace_.message.info("Exported: " + file.string());
    return "";
  }

  Workspace& workspace_;
  GraphState graph_;
  GraphPanel panel_;
};

}  // namespace

void GraphPanel::draw_view_row(GraphState& graph, std::optional<PieceId> selected) {
  int view = pieces_shown_ ? 3 : graph.shows_piece() ? 2 : graph.scope() == GraphScope::kWhole ? 1 : 0;
  if (marked_choice_row("Nodes", "##nodes", view, kNodes, "graph nodes",
                        "Nodes of the graph: faces, or pieces. More than 2,000 faces are drawn as clusters."))
    show_nodes(graph, view, selected);
  if (graph.shows_piece()) graph.show_piece(selected);
}

void GraphPanel::show_nodes(GraphState& graph, int view, std::optional<PieceId> selected) {
  pieces_shown_ = view == 3;
  const GraphScope scope = view == 1 ? GraphScope::kWhole : GraphScope::kAroundCut;
  if (view < 2) graph.show_cut();
  if (view < 2 && scope != graph.scope()) graph.show(scope);
  if (view == 2) graph.show_piece(selected);
  canvas_.fit();
}

void GraphPanel::light(const GraphState& graph, const Document& document, ViewState& view,
                       const GraphCanvas::Pointer& on_canvas, std::optional<FaceOfBody> in_picture) {
  std::optional<FaceOfBody> lit = in_picture;
  if (on_canvas.over) {
    lit = graph.face_of(*on_canvas.over);
    explain(graph, document, view.look.pieces, *on_canvas.over);
  }
  if (lit == view.look.lit_face) return;
  view.look.lit_face = lit;
  view.picture_old = true;
}

void GraphPanel::draw_canvas(GraphState& graph, const Document& document, ViewState& view,
                             std::optional<Vec2> pointer, float height) {
  const DrawnGraph& drawn = *graph.drawn();
  const std::optional<FaceOfBody> face = pointer ? face_at(document.world(), view, *pointer) : std::nullopt;
  const std::optional<uint32_t> lit = face ? graph.node_of(*face) : std::nullopt;
  KERF_ASSERT(graph.start() < drawn.of.size());
  const uint32_t start = drawn.of[graph.start()];
  if (framed_ != graph.number()) canvas_.fit();
  framed_ = graph.number();
  const bool to_scale = graph.placing() != GraphState::Placing::kForce;
  const GraphCanvas::Pointer on_canvas = canvas_.draw(
      {drawn, graph.layout(), lit, start == DrawnGraph::kNone ? std::nullopt : std::optional(start),
       to_scale ? std::optional(view.frame.unit) : std::nullopt},
      height);
  light(graph, document, view, on_canvas, lit ? face : std::nullopt);
  if (!on_canvas.clicked) return;
  const DrawnGraph::Node& n = drawn.nodes[*on_canvas.clicked];
  if (n.faces > 1) {
    graph.open(*on_canvas.clicked);
  } else if (!n.removed) {
    graph.start_from(*on_canvas.clicked);
  }
  view.picture_old = true;
}

bool GraphPanel::fit_under_pointer() {
  if (!canvas_.hovered()) return false;
  canvas_.fit();
  return true;
}

void GraphPanel::forget() {
  rows_.clear();
  rows_of_.reset();
  typed_ = {};
  missing_in_.reset();
}

// Draws the reason for the missing graph.
static void draw_absence(GraphState& graph) {
  if (!graph.is_left_out())
    return secondary_text(graph.shows_piece() ? "Select a piece to draw its graph here."
                                              : "There are no faces.");
  secondary_text("The graph of " + grouped(graph.left_out()) + " faces takes a moment after each stroke.");
  if (ImGui::Button("Draw")) graph.request_left_out();
  mark_last_item("graph ask");
}

// Draws a field for the number of a face; Enter zooms to its node, and the traversal starts there.
void GraphPanel::find_row(GraphState& graph, const Document& document) {
  property("Find Face");
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##find", "Number", typed_.data(), typed_.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CharsDecimal |
                                   ImGuiInputTextFlags_AutoSelectAll);
  mark_last_item("graph find");
  tooltip("Zooms to the node of the face with this number, and starts the traversal there.");
  if (!entered) return;
  missing_in_ = graph.number();
  const std::optional<FaceId> face = face_of_text(typed_.data());
  if (!face) return;
  for (const BodyId body : document.world().ids()) {
    const std::optional<uint32_t> node = graph.node_of({body, *face});
    if (!node || graph.drawn()->nodes[*node].removed) continue;
    missing_in_.reset();
    graph.start_from(*node);
    canvas_.show_start();
    return;
  }
}

void GraphPanel::draw_rows_of_faces(GraphState& graph, const Document& document, const ViewState& view) {
  if (ImGui::Button("Fit")) canvas_.fit();
  mark_last_item("graph fit");
  tooltip("Fits the whole graph (F while the pointer is over it). Scroll to zoom, drag to pan.");
  ImGui::SameLine();
  if (ImGui::Button("Near the Cut")) canvas_.show_start();
  mark_last_item("graph near");
  tooltip("Zooms to the faces around the ringed one, next to the cut.");
  if (graph.any_open()) {
    ImGui::SameLine();
    if (ImGui::Button("Close Clusters")) graph.close_all();
  }
  if (!begin_properties("traversal")) return;
  find_row(graph, document);
  traversal_row(graph);
  if (graph.removed() > 0) removals_row(graph, view);
  end_properties();
  if (missing_in_ == graph.number()) {
    secondary_text("No node of this graph shows that face.");
    mark_last_item("graph face missing");
  }
  draw_verdict(graph);
}

void GraphPanel::draw_pieces(const Document& document, ViewState& view) {
  const PiecesKey now{document.journal().size(), document.revision(), document.world().live_pieces(),
                      document.history().position()};
  const bool is_old = std::exchange(rows_of_, now) != now;
  if (is_old) rows_ = piece_tree(piece_origins(document));
  std::erase_if(rows_,
                [&](const PieceTreeRow& row) { return !document.world().contains(row.origin.piece.body); });
  if (is_old) name_loaded_parts(rows_, document.world(), view.look.pieces);
  draw_piece_tree(rows_, document, view);
}

void GraphPanel::draw_rows(GraphState& graph, const Document& document, ViewState& view) {
  if (begin_properties("graph")) {
    draw_view_row(graph, first_selected(view.look.pieces));
    if (!pieces_shown_) placing_row(graph);
    end_properties();
  }
  if (pieces_shown_) draw_pieces(document, view);
}

void GraphPanel::draw(GraphState& graph, const Document& document, ViewState& view,
                      std::optional<Vec2> pointer) {
  const float em = ImGui::GetFontSize();
  const bool wide = ImGui::GetContentRegionAvail().x > kWide * em;
  if (wide) ImGui::BeginChild("##rows", {kRows * em, 0});
  draw_rows(graph, document, view);
  const bool drawn = !pieces_shown_ && !graph.is_left_out() && graph.drawn();
  if (drawn && !wide)
    draw_canvas(graph, document, view, pointer, kHeightOfWidth * ImGui::GetContentRegionAvail().x);
  if (!pieces_shown_ && !drawn) draw_absence(graph);
  if (drawn) draw_rows_of_faces(graph, document, view);
  if (!wide) return;
  ImGui::EndChild();
  ImGui::SameLine();
  if (drawn) draw_canvas(graph, document, view, pointer, ImGui::GetContentRegionAvail().y);
}

std::unique_ptr<Feature> graph_feature(Workspace& workspace) {
  return std::make_unique<GraphFeature>(workspace);
}

}  // namespace kerf
