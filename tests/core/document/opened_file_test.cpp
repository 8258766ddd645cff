#include "core/document/journal.h"

#include <gtest/gtest.h>

#include "core/document/commands.h"
#include "core/document/save.h"
#include "tests/support/random_edits.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

TEST(OpenedFile, mesh_becomes_a_scene_without_commands) {
  TemporaryFolder folder;
  write_text(folder / "plate.obj", kPlateObj);
  const Result<OpenedFile> opened = open_file(folder / "plate.obj");
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->scene.world.live_faces(), 2u);
  EXPECT_TRUE(opened->journal.commands.empty());
}

TEST(OpenedFile, unreadable_file_is_named_in_the_error) {
  TemporaryFolder folder;
  write_text(folder / "broken.obj", "f one two\n");
  write_text(folder / "broken.json", "{");
  for (const char* name : {"broken.obj", "broken.json", "missing.ply", "missing.kerf"}) {
    const Result<OpenedFile> opened = open_file(folder / name);
    ASSERT_FALSE(opened.ok()) << name;
    EXPECT_NE(opened.error().message.find(name), std::string::npos) << opened.error().message;
  }
}

TEST(OpenedFile, journal_has_scene_and_commands_unless_its_mesh_is_missing) {
  TemporaryFolder folder;
  write_text(folder / "plate.obj", kPlateObj);
  SceneDescription scene;
  scene.bodies.push_back(body_of_file(folder / "plate.obj"));
  ASSERT_TRUE(record_hashes(scene).ok());
  const std::vector<Command> commands{RenamePiece{{{0, 0}, 0}, "lid"}};
  ASSERT_TRUE(save_journal(folder / "work.kerf", scene, commands, {}).ok());
  const Result<OpenedFile> opened = open_file(folder / "work.kerf");
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  EXPECT_EQ(opened->scene.world.live_faces(), 2u);
  EXPECT_EQ(opened->journal.commands.size(), 1u);
  std::filesystem::remove(folder / "plate.obj");
  const Result<OpenedFile> without = open_file(folder / "work.kerf");
  ASSERT_FALSE(without.ok());
  EXPECT_NE(without.error().message.find("plate.obj"), std::string::npos) << without.error().message;
}

}  // namespace
}  // namespace kerf::test
