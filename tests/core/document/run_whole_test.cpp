#include <gtest/gtest.h>

#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/stroke_path.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

StrokePath across(double z) {
  StrokePath stroke;
  stroke.radius = 0.02;
  stroke.keys = {{{-0.8, 1, z}, {0, -1, 0}}, {{0.8, 1, z}, glm::normalize(Vec3(0.1, -1, 0))}};
  stroke.times = {0, 1};
  return stroke;
}

Document torus_document() {
  const auto world = [] { return world_of(torus(24, 16, 0.5, 0.2)); };
  return Document(world(), [world](const Progress*) -> Result<World> { return world(); });
}

std::vector<Command> path_of(const Document& document) {
  return path_commands(std::vector{across(0.1), across(0), across(-0.1)},
                       document.world().bounds().diagonal());
}

std::vector<std::string> lines_of(const Document& document) {
  std::vector<std::string> lines;
  for (const Command& command : document.journal()) lines.push_back(*command_text(command, {}));
  return lines;
}

TEST(RunWhole, gives_the_same_result_as_the_strokes_one_by_one) {
  Document whole = torus_document(), drawn = torus_document();
  ASSERT_TRUE(whole.run_whole(path_of(whole)).ok());
  for (const Command& command : path_of(drawn)) {
    drawn.apply(command);
    ASSERT_TRUE(run_all(drawn).ok());
  }
  EXPECT_EQ(whole.history().totals().strokes, 3u);
  EXPECT_GT(whole.history().totals().removed_faces, 100u);
  expect_same_world(whole.world(), drawn.world());
  EXPECT_EQ(state_hash(whole.world()), state_hash(drawn.world()));
  EXPECT_EQ(lines_of(whole), lines_of(drawn));
}

StrokePath knife(double z, double twist) {
  StrokePath stroke = across(z);
  stroke.radius = 0;
  stroke.keys[1].direction = glm::normalize(Vec3(0, -1, twist));
  return stroke;
}

TEST(RunWhole, lists_the_changes_of_the_knife_and_takes_all_back_if_it_fails) {
  Document document = torus_document();
  const double diagonal = document.world().bounds().diagonal();
  const uint64_t before = state_hash(document.world());
  const Outcome failed =
      document.run_whole(path_commands(std::vector{across(0.1), knife(0, 0), knife(0, 0.5)}, diagonal));
  EXPECT_FALSE(failed.ok()) << "the last strip is not planar";
  EXPECT_TRUE(failed.delta.replaced);
  EXPECT_EQ(state_hash(document.world()), before);
  EXPECT_EQ(document.history().position(), 0u);
  EXPECT_TRUE(lines_of(document).empty());
  const Outcome cut = document.run_whole(path_commands(std::vector{knife(0, 0)}, diagonal));
  ASSERT_TRUE(cut.ok());
  ASSERT_EQ(cut.delta.bodies.size(), 1u);
  EXPECT_FALSE(cut.delta.bodies[0].new_pieces.empty());
}

// A document with a stroke that is done and one that was undone, stopped after so many reports of a run.
// Returns whether it was, and not over before.
bool stops_without_trace(size_t window, int reports) {
  SCOPED_TRACE("window " + std::to_string(window) + ", stopped at report " + std::to_string(reports));
  Document document = torus_document();
  for (const double z : {0.05, -0.05}) {
    for (const Command& c : path_commands(std::vector{across(z)}, document.world().bounds().diagonal()))
      document.apply(c);
    EXPECT_TRUE(run_all(document).ok());
  }
  const uint64_t both = state_hash(document.world());
  EXPECT_TRUE(document.apply(Undo{}).ok());
  document.set_window(window);
  const uint64_t before = state_hash(document.world());
  const std::vector<std::string> lines = lines_of(document);
  int left = reports;
  const Progress progress{[&](double) { return left-- > 0; }};
  const Outcome outcome = document.run_whole(path_of(document), &progress);
  if (outcome.ok()) return false;
  EXPECT_EQ(outcome.error().message, cancelled().message);
  EXPECT_EQ(document.waiting(), 0u);
  EXPECT_EQ(state_hash(document.world()), before);
  EXPECT_EQ(lines_of(document), lines);
  EXPECT_EQ(document.history().position(), 1u);
  EXPECT_EQ(document.history().size(), 2u);
  EXPECT_TRUE(document.apply(Redo{}).ok());
  EXPECT_TRUE(run_all(document).ok());
  EXPECT_EQ(state_hash(document.world()), both);
  return true;
}

TEST(RunWhole, keeps_undone_steps_if_it_has_no_effect) {
  Document document = torus_document();
  ASSERT_TRUE(document.run_whole(path_of(document)).ok());
  const size_t steps = document.history().size();
  const uint64_t after = state_hash(document.world());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_TRUE(document.run_whole({}).ok());
  ASSERT_EQ(document.history().size(), steps);
  ASSERT_TRUE(document.apply(Redo{}).ok());
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_EQ(state_hash(document.world()), after);
}

TEST(RunWhole, leaves_no_trace_if_cancelled_at_any_progress_report) {
  for (const size_t window : {size_t{1} << 30, size_t{1}}) {  // with the last what was done is replayed
    int stopped = 0;
    for (const int reports : {0, 1, 2, 5, 9, 17, 30, 45, 60, 90, 140})
      stopped += stops_without_trace(window, reports) ? 1 : 0;
    EXPECT_GE(stopped, 6) << "too few reports";
  }
}

}  // namespace
}  // namespace kerf::test
