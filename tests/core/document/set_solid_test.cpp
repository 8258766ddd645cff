#include <gtest/gtest.h>

#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/save.h"
#include "core/mesh/mesh_file.h"
#include "core/world/body_mass.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

class SolidBox : public testing::Test {
 protected:
  const Body& body() const { return document_.world().body(document_.world().ids().front()); }
  PieceId piece() const { return {document_.world().ids().front(), 0}; }
  uint64_t hash() const { return state_hash(document_.world()); }

  Document document_{world_of(brick({1, 2, 3}))};
};

TEST_F(SolidBox, is_solid_until_undo_and_again_after_redo) {
  const World before = document_.world();
  const uint64_t as_sheet = hash();
  const auto done = document_.apply(SetSolid{piece(), true});
  ASSERT_TRUE(done.ok());
  EXPECT_EQ(done.delta.mass_changed, document_.world().ids());
  EXPECT_TRUE(body().solid);
  ASSERT_NE(enclosed_piece(body(), 0), nullptr) << "it is weighed at once";
  EXPECT_NEAR(enclosed_piece(body(), 0)->solid.mass, 6, 1e-12);
  const uint64_t as_solid = hash();
  EXPECT_NE(as_solid, as_sheet);
  ASSERT_TRUE(document_.apply(Undo{}).ok());
  EXPECT_FALSE(body().solid);
  EXPECT_EQ(hash(), as_sheet);
  expect_same_world(document_.world(), before);
  ASSERT_TRUE(document_.apply(Redo{}).ok());
  EXPECT_TRUE(body().solid);
  EXPECT_EQ(hash(), as_solid);
}

TEST_F(SolidBox, does_nothing_if_already_set_and_fails_without_a_piece) {
  EXPECT_TRUE(document_.apply(SetSolid{piece(), false}).delta.empty());
  EXPECT_FALSE(document_.apply(SetSolid{{piece().body, 7}, true}).ok());
  EXPECT_FALSE(body().solid);
}

TEST_F(SolidBox, sets_the_cut_material_until_undo) {
  ASSERT_TRUE(document_.apply(SetSolid{piece(), true}).ok());
  const World before = document_.world();
  ASSERT_TRUE(document_.apply(SetSolid{piece(), true, "foam"}).ok());
  const std::optional<uint16_t> material = cut_material(body());
  ASSERT_TRUE(material);
  EXPECT_EQ(body().material_names[*material], "foam");
  EXPECT_TRUE(document_.apply(SetSolid{piece(), true, "foam"}).delta.empty());
  EXPECT_TRUE(document_.apply(SetSolid{piece(), true}).delta.empty()) << "no name keeps the material";
  ASSERT_TRUE(document_.apply(Undo{}).ok());
  expect_same_world(document_.world(), before);
  EXPECT_EQ(body().cut_material, "cut");
}

TEST_F(SolidBox, copies_are_solid) {
  ASSERT_TRUE(document_.apply(SetSolid{piece(), true}).ok());
  ASSERT_TRUE(document_.apply(DuplicatePiece{piece(), {}}).ok());
  ASSERT_TRUE(document_.apply(SubdividePiece{piece(), Subdivision::kMidpoint}).ok());
  for (const BodyId id : document_.world().ids()) EXPECT_TRUE(document_.world().body(id).solid);
}

TEST_F(SolidBox, replays_from_a_journal) {
  const TemporaryFolder folder;
  const Soup soup = brick({1, 2, 3});
  const MeshView view{soup.positions, soup.triangles, {}, {}, {}, {}, {}};
  ASSERT_TRUE(write_mesh(view, folder / "box.obj", MeshFormat::kObj).ok());
  SceneDescription scene;
  scene.bodies.push_back(body_of_file(folder / "box.obj"));
  ASSERT_TRUE(record_hashes(scene).ok());
  ASSERT_TRUE(document_.apply(SetSolid{piece(), true, "foam"}).ok());
  std::vector<StateMark> marks;
  mark_state(document_, marks, true);
  ASSERT_TRUE(save_journal(folder / "box.kerf", scene, document_.journal(), marks).ok());

  auto opened = open_journal(folder / "box.kerf", nullptr);
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  Document again(std::move(opened->scene.world));
  Replay replay(opened->journal, again);
  QueueRun how;
  how.told = [](const Result<StepResult>&) -> Status { return Done{}; };
  ASSERT_TRUE(replay.run(how).ok());
  EXPECT_FALSE(replay.difference());
  EXPECT_EQ(state_hash(again.world()), hash());
  EXPECT_TRUE(again.world().body(again.world().ids().front()).solid);
  EXPECT_EQ(again.world().body(again.world().ids().front()).cut_material, "foam");
}

}  // namespace
}  // namespace kerf::test
