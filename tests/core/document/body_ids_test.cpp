#include <gtest/gtest.h>

#include <set>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/save.h"
#include "tests/support/made_meshes.h"
#include "tests/support/random_edits.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

// A document whose ids are followed: those at every position of its history, and all that there ever were.
class BodyIds : public testing::Test {
 protected:
  void SetUp() override {
    write_text(mesh(), kPlateObj);
    scene_.bodies.push_back(body_of_file(mesh()));
    ASSERT_TRUE(record_hashes(scene_).ok());
    begin();
  }
  std::filesystem::path mesh() const { return folder_ / "plate.obj"; }

  World scene_world() const { return std::move(load_scene(scene_)->world); }
  void begin() {
    document_ = Document(scene_world(), [this](const Progress*) { return Result<World>(scene_world()); });
    at_position_ = {document_.world().ids()};
    ever_ = {at_position_[0].begin(), at_position_[0].end()};
  }

  // Applies a command of any kind; ids that the history knows must come again, all others must be new.
  void apply(const Command& command) {
    const size_t position = document_.history().position();
    const size_t written = document_.journal().size();
    ASSERT_TRUE(document_.apply(command).ok());
    ASSERT_TRUE(run_all(document_).ok());
    const bool travelled = std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command);
    if (!travelled && document_.journal().size() > written) at_position_.resize(position + 1);
    expect_known_or_new();
  }
  void expect_known_or_new() {
    const std::vector<BodyId> ids = document_.world().ids();
    const size_t position = document_.history().position();
    if (position < at_position_.size()) {
      EXPECT_EQ(ids, at_position_[position]);
      return;
    }
    const std::vector<BodyId> before = at_position_.back();
    for (const BodyId id : ids) {
      if (std::find(before.begin(), before.end(), id) == before.end())
        EXPECT_TRUE(ever_.insert(id).second) << "slot " << id.slot << ", generation " << id.generation;
    }
    at_position_.resize(position + 1, before);
    at_position_[position] = ids;
  }

  // What a journal that is written and read again leads to.
  World recovered() const {
    const auto file = folder_ / "work.kerf";
    EXPECT_TRUE(save_journal(file, scene_, document_.journal(), {}).ok());
    const auto journal = read_journal(file);
    EXPECT_TRUE(journal.ok());
    Document again(scene_world());
    for (const Command& c : journal->commands) EXPECT_TRUE(again.apply(c).ok());
    EXPECT_TRUE(run_all(again).ok());
    return again.world();
  }

  TemporaryFolder folder_;
  SceneDescription scene_;
  Document document_;
  std::vector<std::vector<BodyId>> at_position_;
  std::set<BodyId> ever_;
};

TEST_F(BodyIds, an_undone_mesh_does_not_pass_its_id_to_the_next) {
  apply(AddMesh{mesh(), "first"});
  const BodyId first = document_.world().ids().back();
  EXPECT_EQ(first, BodyId(1, 1));
  apply(Undo{});
  apply(AddMesh{mesh(), "second"});
  EXPECT_EQ(document_.world().ids().back(), BodyId(1, 3));
  EXPECT_FALSE(document_.world().contains(first));
}

TEST_F(BodyIds, are_stable_across_undo_redo_replay_and_recovery_and_never_reused) {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    begin();
    if (seed % 3 == 0) document_.set_window(0);  // every undo starts again from the scene
    for (int i = 0; i < 25; ++i) {
      SCOPED_TRACE("act " + std::to_string(i));
      for (const Command& command : random_edit(document_.world(), mesh(), random)) {
        apply(command);
        if (HasFatalFailure()) return;
      }
      if (random.below(8) == 0) {
        ASSERT_TRUE(document_.travel(random.below(document_.history().size() + 1)).ok());
        ASSERT_TRUE(run_all(document_).ok());
        expect_known_or_new();
      }
      if (HasFailure()) return;
    }
    expect_same_world(recovered(), document_.world());
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace kerf::test
