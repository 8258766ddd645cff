
#include <gtest/gtest.h>

#include <set>

#include "core/document/cut_effects.h"
#include "core/document/scene.h"
#include "tests/support/checkout.h"
#include "tests/support/editor_features.h"
#include "tests/support/gui_context.h"
#include "tests/support/jointed.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"
#include "ui/editor/inspect/graph_views.h"
#include "ui/editor/shared/piece_set.h"

namespace kerf {
namespace {

Document sheet_to_cut() {
  World world;
  world.add(make_body("sheet", test::build(test::grid(10, 2))));
  return Document(std::move(world));
}

// From edge to edge of the sheet, along z.
void cut_at(Document& document, double x) {
  CutSettings settings;
  settings.laser.radius = 0.03;
  settings.resolution.target_edge = 0.15;  // few faces, so that none are joined to clusters
  const Vec3 down(0, -1, 0);
  document.apply(BeginStroke{settings, {{x, 3, -1.3}, down}});
  document.apply(MoveBeam{{{x, 3, 1.3}, down}});
  document.apply(EndStroke{});
}

void run_queue(Document& document) {
  while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
}

TEST(GraphState, updates_only_when_no_stroke_is_being_cut) {
  Document document = sheet_to_cut();
  GraphState graph;
  EXPECT_TRUE(graph.follow(document));
  EXPECT_FALSE(graph.follow(document));
  EXPECT_EQ(graph.reached(), graph.total());
  cut_at(document, 0.1);
  EXPECT_FALSE(graph.follow(document)) << "the stroke waits";
  run_queue(document);
  EXPECT_TRUE(graph.follow(document));
  EXPECT_TRUE(graph.separated());
  EXPECT_EQ(graph.total(), document.world().live_faces());
  EXPECT_EQ(graph.removed(), document.history().totals().removed_faces);
  EXPECT_FALSE(graph.closings().empty());
}

TEST(GraphFeature, exports_the_graph_of_the_present_document) {
  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
  const test::TemporaryFolder folder;
  workspace.session.document = sheet_to_cut();
  const std::unique_ptr<Feature> feature = graph_feature(workspace);
  workspace.services.panels.show("graph");
  feature->after_queue(0);
  const auto exported = [&](const std::string& name) {
    for (const UserAction& action : feature->actions()) {
      EXPECT_EQ(action.objection(), nullptr);
      action.run();
    }
    EXPECT_EQ(workspace.services.browser.request.take(folder / name), "");
    return test::read_text(folder / name);
  };
  const std::string before = exported("before.svg");
  EXPECT_EQ(exported("again.svg"), before);
  workspace.services.panels.fold("graph");
  cut_at(workspace.session.document, 0.1);
  run_queue(workspace.session.document);
  feature->after_queue(0);
  EXPECT_NE(exported("after.svg"), before);
}

TEST(GraphState, is_read_again_for_a_document_that_looks_like_the_last_one) {
  const Document document = sheet_to_cut();
  GraphState graph;
  graph.follow(document);
  graph.forget();
  EXPECT_EQ(graph.drawn(), nullptr);
  EXPECT_EQ(graph.reached(), 0u);
  EXPECT_TRUE(graph.follow(document));
  EXPECT_EQ(graph.total(), document.world().live_faces());
}

TEST(GraphState, knows_pieces_that_were_cut_off_after_they_left_the_body) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  EXPECT_EQ(graph.cut_off(), 1u);
  const PieceId piece{document.world().ids().front(), 1};
  ASSERT_TRUE(document.apply(MovePiece{piece, {{0, 1, 0}, {}}}).ok());
  EXPECT_TRUE(graph.follow(document));
  EXPECT_FALSE(graph.separated()) << "the search stays in one body";
  EXPECT_EQ(graph.cut_off(), 1u);
}

TEST(GraphState, updates_between_single_steps) {
  Document document = sheet_to_cut();
  GraphState graph;
  graph.follow(document);
  cut_at(document, 0.1);
  size_t changes = 0;
  while (document.waiting() > 0) {
    ASSERT_TRUE(document.step_stage().ok());
    EXPECT_EQ(graph.follow(document) && document.waiting() > 0, false);
    if (graph.follow(document, true)) ++changes;
    EXPECT_EQ(graph.removed(), document.history().totals().removed_faces);
  }
  EXPECT_GT(changes, 10u);
}

TEST(GraphState, is_rebuilt_during_play_only_when_pieces_become_bodies) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  ASSERT_TRUE(graph.follow(document));
  ASSERT_FALSE(graph.drawn()->loops.empty());
  document.apply(Play{});
  document.apply(AdvanceTime{1, true});
  run_queue(document);
  EXPECT_TRUE(graph.follow(document));
  const auto drawn = graph.drawn();
  for (int second = 0; second < 3; ++second) {
    document.apply(AdvanceTime{kTicksPerSecond, true});
    EXPECT_FALSE(graph.follow(document));
    run_queue(document);
    EXPECT_FALSE(graph.follow(document));
  }
  EXPECT_EQ(graph.drawn(), drawn);
  cut_at(document, -0.4);
  run_queue(document);
  EXPECT_TRUE(graph.follow(document));
}

// Along with the body: by as much as it fell and turned since.
TEST(GraphState, loops_and_nodes_move_with_their_bodies) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  document.apply(Play{});
  document.apply(AdvanceTime{1, true});
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  const DrawnGraph& drawn = *graph.drawn();
  const LoopPath& loop = drawn.loops.back();
  const Body& body = document.world().body(loop.body);
  const Vec3 read = loop.points.front(), in_body = body.placement.to_body(read);
  document.apply(AdvanceTime{60, true});
  run_queue(document);
  ASSERT_GT(glm::length(body.placement.to_world(in_body) - read), 0.5);
  const Vec3 now = drawn.moved_with(loop.body, read, document.world());
  EXPECT_NEAR(glm::length(now - body.placement.to_world(in_body)), 0, 1e-12);
  EXPECT_EQ(drawn.moved_with({99, 0}, read, document.world()), read);
}

TEST(GraphState, plays_the_traversal_to_its_end) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  EXPECT_EQ(graph.marked(), graph.reached());
  graph.play(true);
  EXPECT_EQ(graph.marked(), 0u);
  size_t before = 0;
  while (graph.playing()) {
    ASSERT_TRUE(graph.advance(0.05));
    ASSERT_GT(graph.marked(), before);
    ASSERT_EQ(graph.drawn()->marked, graph.marked());
    before = graph.marked();
  }
  EXPECT_EQ(graph.marked(), graph.reached());
}

TEST(GraphState, starts_at_a_node_on_the_other_side) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  const size_t one = graph.reached(), both = graph.total();
  const auto& nodes = graph.drawn()->nodes;
  uint32_t other = 0;
  while (nodes[other].removed || nodes[other].set != 1) ++other;
  graph.start_from(other);
  EXPECT_EQ(graph.total(), both);
  EXPECT_EQ(one + graph.reached(), both);
}

TEST(GraphState, maps_faces_to_nodes_and_back) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  size_t faces = 0;
  for (uint32_t node = 0; node < graph.drawn()->nodes.size(); ++node) {
    const auto face = graph.face_of(node);
    if (!face) continue;
    ++faces;
    EXPECT_EQ(graph.node_of(*face), node);
  }
  EXPECT_GT(faces, 0u);
  EXPECT_FALSE(graph.node_of({document.world().ids()[0], FaceId(1'000'000)}));
}

TEST(GraphState, switches_between_a_single_piece_and_the_cut) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  const BodyId body = document.world().ids()[0];
  const size_t whole = graph.total();
  graph.show_piece(PieceId{body, 1});
  EXPECT_TRUE(graph.follow(document));
  const size_t faces = document.world().body(body).pieces[1].faces;
  EXPECT_EQ(graph.total(), faces);
  EXPECT_EQ(graph.reached(), faces);
  EXPECT_EQ(graph.removed(), 0u);
  for (const DrawnGraph::Node& n : graph.drawn()->nodes) EXPECT_EQ(n.face.piece, 1u);
  graph.show_piece(std::nullopt);
  EXPECT_TRUE(graph.follow(document));
  EXPECT_FALSE(graph.drawn());
  graph.show_cut();
  EXPECT_TRUE(graph.follow(document));
  EXPECT_EQ(graph.total(), whole);
}

TEST(GraphState, provides_removals_and_the_loops_they_closed) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  GraphState graph;
  graph.follow(document);
  EXPECT_EQ(graph.removals(), graph.removed());
  EXPECT_FALSE(graph.drawn()->loops.empty());
  for (const LoopPath& loop : graph.drawn()->loops)
    EXPECT_TRUE(std::count(graph.closings().begin(), graph.closings().end(), loop.removal) == 1);
  graph.set_removals(2);
  EXPECT_EQ(graph.drawn()->removals, 2u);
  graph.set_removals(1'000'000);
  EXPECT_EQ(graph.drawn()->removals, graph.removed());
}

TEST(GraphState, counts_no_removals_of_deleted_bodies) {
  World world;
  for (const double y : {0.0, -0.5})
    world.add(make_body("sheet", test::build(test::moved(test::grid(10, 2), {0, y, 0}, 1))));
  Document document(std::move(world));
  cut_at(document, 0.1);
  run_queue(document);
  const BodyId upper = document.world().ids().front();
  for (int piece = 0; piece < 2; ++piece) {
    for (const BodyId id : document.world().ids()) {
      const Body& body = document.world().body(id);
      if (body.loaded_as != upper) continue;
      uint32_t label = 0;
      while (body.pieces[label].faces == 0) ++label;
      ASSERT_TRUE(document.apply(DeletePiece{{id, label}}).ok());
      break;
    }
  }
  ASSERT_EQ(document.world().ids().size(), 1u);
  GraphState graph;
  graph.follow(document);
  ASSERT_GT(graph.removed(), 0u);
  ASSERT_FALSE(graph.closings().empty());
  EXPECT_LE(graph.closings().back(), graph.removed());
  ASSERT_FALSE(graph.drawn()->loops.empty());
  for (const LoopPath& loop : graph.drawn()->loops) EXPECT_LE(loop.removal, graph.removed());
}

TEST(PieceTree, lists_pieces_under_their_origin_by_step) {
  const BodyId body{0, 0};
  const auto piece = [&](uint32_t label) { return PieceId{body, label}; };
  const std::vector<PieceNode> origins{{piece(0), std::nullopt, 0},
                                       {piece(1), piece(0), 2},
                                       {piece(2), piece(1), 3},
                                       {piece(3), piece(0), 1},
                                       {piece(5), piece(4), 4}};
  std::vector<std::pair<uint32_t, int>> seen;
  for (const PieceTreeRow& row : piece_tree(origins)) seen.emplace_back(row.origin.piece.label, row.depth);
  const std::vector<std::pair<uint32_t, int>> expected{{0, 0}, {3, 1}, {1, 1}, {2, 2}, {5, 1}};
  EXPECT_EQ(seen, expected) << "nothing is left of piece 4, so that piece 5 stands alone";
}

TEST(PieceTree, describes_origin_and_support_of_each_piece) {
  Document document = sheet_to_cut();
  cut_at(document, 0.1);
  run_queue(document);
  const std::vector<PieceNode> nodes = piece_origins(document);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(
      words_on({nodes[0]}, document, {}, FileUnit::kMetre),
      "sheet is the rest of its body. The mesh is connected. One piece that came off still stands with it.");
  EXPECT_EQ(
      words_on({nodes[1]}, document, {}, FileUnit::kMetre),
      "sheet 1 came off sheet in step 1 (Cut 1: sheet, radius 30 mm). Nothing holds it: it stays until it is "
      "moved or time passes.");
  PieceMap numbered;
  numbered[nodes[1].piece].number = 4;
  EXPECT_TRUE(words_on({nodes[1]}, document, numbered, FileUnit::kMetre).starts_with("sheet 4 came off"));
  PieceNode other = nodes[0];
  other.parts = 5;
  other.beside = 0;
  other.held_by = Holder::kBody;
  EXPECT_EQ(words_on({other}, document, {}, FileUnit::kMetre),
            "sheet is the rest of its body. Its 5 parts were never connected; they move together because "
            "they are one body.");
  other.held_by = Holder::kPin;
  EXPECT_EQ(words_on({other}, document, {}, FileUnit::kMetre),
            "sheet is the rest of its body. Its 5 parts are one body, which is pinned.");
}

// The number of vertices with which the tree of a single piece of this name is drawn.
int vertices_with(const std::string& name) {
  World world;
  world.add(make_body(name, test::build(test::plate(1))));
  const Document document(std::move(world));
  const std::vector<PieceTreeRow> rows = piece_tree(piece_origins(document));
  ViewState view;
  test::GuiContext gui;
  for (int i = 0; i < 4; ++i) gui.frame([&] { draw_piece_tree(rows, document, view); });
  return ImGui::GetDrawData()->TotalVtxCount;
}

TEST(PieceTree, shows_names_with_two_number_signs_in_full) {
  EXPECT_EQ(vertices_with("bolt##2"), vertices_with("bolt--2"));
}

TEST(PieceTree, keeps_the_names_of_loaded_parts_in_its_rows) {
  auto scene = read_scene(test::checkout() / "assets/scenes/car.json");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  Document document(std::move(scene->world));
  ASSERT_NO_FATAL_FAILURE(test::cut_car(document));
  std::vector<PieceTreeRow> rows = piece_tree(piece_origins(document));
  name_loaded_parts(rows, document.world(), {});
  std::set<std::string> names;
  for (PieceTreeRow& row : rows) {
    if (row.name.empty()) continue;
    names.insert(row.name);
    EXPECT_EQ(row.name, name_of_piece(document.world(), {}, row.origin.piece));
    row.name = "kept";
    EXPECT_TRUE(words_on(row, document, {}, FileUnit::kMetre).starts_with("kept is a part"))
        << "not searched again";
  }
  EXPECT_EQ(names, std::set<std::string>({"wheel_front_left", "wheel_front_right", "wheel_rear_left",
                                          "wheel_rear_right", "steering_wheel"}));
}

TEST(GraphState, finds_a_face_by_a_whole_number_only) {
  EXPECT_EQ(face_of_text("12"), FaceId(12));
  for (const char* text : {"", "-1", "1.5", "2*3", "4294967297"})
    EXPECT_EQ(face_of_text(text), std::nullopt) << text;
}

}  // namespace
}  // namespace kerf
