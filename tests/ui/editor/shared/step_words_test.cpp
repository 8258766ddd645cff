#include "ui/editor/shared/file_frames.h"

#include <gtest/gtest.h>

#include <functional>
#include <string_view>

#include "core/document/document.h"
#include "tests/support/editor_features.h"
#include "tests/support/gui_context.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

// A grid of a unit square (m) whose right half is a part with a name, beside one that the file gives all of
// it.
Document named_grid() {
  Soup soup = test::grid(8, 2);
  const auto all = static_cast<uint32_t>(soup.triangles.size());
  soup.parts = {{"plate", 0, all}, {"half", all / 2, all}};
  return Document(test::world_of(soup));
}

void stroke_across(Document& document, double radius) {
  const World::Bounds bounds = document.world().bounds();
  const Vec3 middle = 0.5 * (bounds.min + bounds.max), size = bounds.max - bounds.min;
  const int thin = size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2);
  const int along = (thin + 1) % 3;
  Vec3 down(0), way(0);
  down[thin] = -1;
  way[along] = 0.45 * size[along];
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 10};
  document.apply(BeginStroke{settings, {middle - way - down, down}});
  document.apply(MoveBeam{{middle + way - down, down}});
  document.apply(EndStroke{});
}

TEST(StepWords, count_strokes_and_report_areas_in_document_units) {
  Document document = named_grid();
  stroke_across(document, 0.03);
  EXPECT_EQ(step_words(document.history(), 0, FileUnit::kMetre), "Cut 1: radius 30 mm") << "it waits";
  ASSERT_TRUE(test::run_all(document).ok());
  const std::string first = step_words(document.history(), 0, FileUnit::kMillimetre);
  EXPECT_TRUE(first.find("half") != std::string::npos) << first;
  EXPECT_TRUE(first.find("plate") == std::string::npos) << first;
  EXPECT_TRUE(first.ends_with("radius 30 \xc2\xb5m")) << first;
  document.apply(RenamePiece{{document.world().ids()[0], 0}, "sheet"});
  stroke_across(document, 0.04);
  ASSERT_TRUE(test::run_all(document).ok());
  const size_t last = document.history().position() - 1;
  EXPECT_TRUE(step_words(document.history(), last, FileUnit::kInch).starts_with("Cut 2: "));
  EXPECT_TRUE(step_words(document.history(), last - 1, FileUnit::kInch).starts_with("Rename "));
}

TEST(StepWords, use_the_piece_name_at_the_time_of_the_edit) {
  Document document = named_grid();
  const BodyId body = document.world().ids()[0];
  const std::string name = document.world().body(body).name_of(0);
  ASSERT_TRUE(document.apply(PinPiece{{body, 0}, true}).ok());
  ASSERT_TRUE(document.apply(RenamePiece{{body, 0}, "sheet"}).ok());
  ASSERT_TRUE(document.apply(PinPiece{{body, 0}, false}).ok());
  EXPECT_EQ(step_words(document.history(), 0, FileUnit::kMetre), "Pin " + name);
  EXPECT_EQ(step_words(document.history(), 1, FileUnit::kMetre), "Rename " + name + " to sheet");
  EXPECT_EQ(step_words(document.history(), 2, FileUnit::kMetre), "Unpin sheet");
}

TEST(StepWords, of_a_recut_mention_the_recomputed_stroke) {
  Document document = named_grid();
  stroke_across(document, 0.03);
  ASSERT_TRUE(test::run_all(document).ok());
  CutSettings finer = document.history().last_settings();
  finer.resolution.rule = Resolution::Rule::kTargetEdge;
  finer.resolution.target_edge = 0.05;
  document.apply(Recut{finer});
  ASSERT_TRUE(test::run_all(document).ok());
  const std::string words = step_words(document.history(), 1, FileUnit::kMetre);
  EXPECT_TRUE(words.starts_with("Recut 1: ")) << words;
  EXPECT_TRUE(words.ends_with("edges of 50 mm")) << words;
}

TEST(StepWords, of_a_missed_stroke_report_nothing_cut) {
  Document document = named_grid();
  CutSettings settings;
  settings.laser.radius = 0.001;
  document.apply(BeginStroke{settings, {{50, 50, 50}, {1, 0, 0}}});
  document.apply(EndStroke{});
  ASSERT_TRUE(test::run_all(document).ok());
  EXPECT_EQ(step_words(document.history(), 0, FileUnit::kMetre), "Cut 1: nothing, radius 1 mm");
}

// The number of vertices with which the History panel lists a change of a piece of this name.
int vertices_of_history(const std::string& piece) {
  test::EditorFeatures editor;
  World world;
  const BodyId body = world.add(make_body(piece, test::build(test::plate(1))));
  editor.workspace.session.document = Document(std::move(world));
  EXPECT_TRUE(editor.workspace.session.document.apply(PinPiece{{body, 0}, true}).ok());
  std::function<void()> draw;
  for (const auto& feature : editor.features) {
    for (const PanelPart& part : feature->panel_parts()) {
      if (std::string_view(part.id) == "history") draw = part.draw;
    }
  }
  test::GuiContext gui;
  for (int i = 0; i < 4; ++i) gui.frame(draw);
  return ImGui::GetDrawData()->TotalVtxCount;
}

TEST(StepWords, are_listed_with_two_number_signs_in_full) {
  EXPECT_EQ(vertices_of_history("bolt##2"), vertices_of_history("bolt--2"));
}

}  // namespace
}  // namespace kerf
