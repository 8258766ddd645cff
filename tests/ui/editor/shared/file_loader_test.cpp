#include "ui/editor/shared/document_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "core/document/stroke_path.h"
#include "core/mesh/mesh_file.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

const std::filesystem::path kMeshes = checkout() / "assets/meshes";

LoadRequest files(const std::vector<std::string>& names) {
  LoadRequest order;
  for (const std::string& name : names) order.files.push_back(kMeshes / name);
  return order;
}

Result<LoadedFiles> wait_for(FileLoader& loader) {
  for (;;) {
    if (auto loaded = loader.take()) return std::move(*loaded);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(FileLoader, returns_each_result_once) {
  FileLoader loader;
  EXPECT_FALSE(loader.take());
  loader.start(files({"knot.obj", "bracket.obj"}));
  EXPECT_TRUE(loader.busy());
  EXPECT_EQ(loader.order().name(), "knot.obj and 1 more");
  const Result<LoadedFiles> loaded = wait_for(loader);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->document.world().ids().size(), 2u);
  EXPECT_EQ(loaded->prepared.size(), 2u);
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.take());
}

// So that they are seen soon: their shadows follow.
TEST(FileLoader, defers_the_shadows_of_large_meshes) {
  const TemporaryFolder folder;
  for (const auto& [rings, later] : {std::pair{20, false}, {330, true}}) {
    const Soup soup = sphere(rings, rings, 1);
    const std::filesystem::path file = folder / "sphere.ply";
    ASSERT_TRUE(write_mesh({soup.positions, soup.triangles, {}, {}}, file, MeshFormat::kPly).ok());
    LoadRequest order;
    order.files = {file};
    const Result<LoadedFiles> loaded = load_files(order, nullptr);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(loaded->shadows_later, later) << loaded->document.world().live_faces();
    ASSERT_EQ(loaded->prepared.size(), 1u);
    EXPECT_EQ(loaded->prepared.begin()->second.caster == nullptr, later);
    EXPECT_NE(loaded->prepared.begin()->second.bases, nullptr);
  }
}

// No pointer continues it, and its rim is closed only at its end.
TEST(FileLoader, recovery_ends_the_stroke_in_progress) {
  StrokePath path;
  path.radius = 0.1;
  path.keys = {{{-0.5, 3, 0.1}, {0, -1, 0}}, {{0.5, 3, 0.1}, {0, -1, 0}}};
  path.times = {0, 1};
  Journal journal;
  journal.scene.bodies = {body_of_file(kMeshes / "knot.obj")};
  journal.commands = scene_stroke_commands(path, 5);
  LoadRequest whole, open;
  whole.left = journal;
  journal.commands.pop_back();
  open.left = journal;
  const Result<LoadedFiles> drawn = load_files(whole, nullptr), ended = load_files(open, nullptr);
  ASSERT_TRUE(drawn.ok() && ended.ok());
  EXPECT_FALSE(ended->document.queue().in_stroke());
  EXPECT_EQ(ended->document.waiting(), 0u);
  EXPECT_GT(ended->document.history().totals().removed_faces, 0u);
  EXPECT_EQ(state_hash(ended->document.world()), state_hash(drawn->document.world()));
  EXPECT_EQ(ended->document.journal().size(), drawn->document.journal().size());
}

// Its shading is that of the mesh before the cut.
TEST(FileLoader, prepares_the_shading_of_meshes_that_commands_created_and_cut) {
  StrokePath path;
  path.radius = 0.1;
  path.keys = {{{-0.5, 3, 0.1}, {0, -1, 0}}, {{0.5, 3, 0.1}, {0, -1, 0}}};
  path.times = {0, 1};
  Journal journal;
  journal.scene.bodies = {body_of_file(kMeshes / "knot.obj")};
  const Result<LoadedFiles> uncut = load_files(files({"knot.obj"}), nullptr);
  ASSERT_TRUE(uncut.ok());
  const BodyId knot = uncut->document.world().ids().front();
  journal.commands = scene_stroke_commands(path, 5);
  journal.commands.insert(journal.commands.begin(), SubdividePiece{{knot, 0}});
  LoadRequest order;
  order.left = journal;
  const Result<LoadedFiles> loaded = load_files(order, nullptr);
  ASSERT_TRUE(loaded.ok());
  const BodyId made = loaded->document.world().ids().back();
  const Mesh& mesh = loaded->document.world().body(made).mesh;
  ASSERT_FALSE(made == knot);
  ASSERT_TRUE(loaded->prepared.contains(made));
  EXPECT_NE(loaded->prepared.at(made).caster, nullptr);
  EXPECT_GT(mesh.face_slots(), loaded->prepared.at(made).bases->count());
}

TEST(FileLoader, reports_why_a_file_cannot_be_read) {
  FileLoader loader;
  loader.start(files({"no_such_file.obj"}));
  const Result<LoadedFiles> loaded = wait_for(loader);
  ASSERT_FALSE(loaded.ok());
  EXPECT_NE(loaded.error().message.find("no_such_file.obj"), std::string::npos);
}

TEST(FileLoader, an_unreadable_file_does_not_block_others) {
  LoadRequest order = files({"no_such_file.obj", "knot.obj", "none.kerf", "bracket.obj"});
  const Result<LoadedFiles> loaded = load_files(order, nullptr);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->document.world().ids().size(), 2u);
  EXPECT_EQ(loaded->order.files, files({"knot.obj", "bracket.obj"}).files);
  ASSERT_EQ(loaded->refused.size(), 2u);
  EXPECT_NE(loaded->refused[0].find("no_such_file.obj"), std::string::npos);
  EXPECT_NE(loaded->refused[1].find("none.kerf"), std::string::npos);
  EXPECT_FALSE(load_files(files({"no_such_file.obj", "none.obj"}), nullptr).ok());
}

TEST(FileLoader, a_cancelled_file_is_never_returned) {
  FileLoader loader;
  loader.start(files({"knot.obj"}));
  loader.start(files({"bracket.obj"}));
  const Result<LoadedFiles> loaded = wait_for(loader);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->order.files.front().filename(), "bracket.obj");
  loader.start(files({"knot.obj"}));
  loader.cancel();
  EXPECT_FALSE(loader.busy());
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(loader.take());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(LoadProgress, shows_the_replay_from_the_uncut_world) {
  const std::filesystem::path scene = checkout() / "assets/scenes/car-cut.json";
  const Result<Scene> uncut = read_scene(scene, nullptr);
  ASSERT_TRUE(uncut.ok());
  LoadProgress news;
  news.watch();
  const Result<LoadedFiles> loaded = load_files({{scene}, {}, 0}, nullptr, &news);
  ASSERT_TRUE(loaded.ok());
  ASSERT_NE(state_hash(loaded->document.world()), state_hash(uncut->world));
  const std::optional<PartialReplay> replay = news.take();  // the first, since nobody took it until now
  ASSERT_TRUE(replay);
  EXPECT_EQ(state_hash(replay->world), state_hash(uncut->world));
  EXPECT_EQ(replay->scene.paints.size(), uncut->paints.size());
  for (const BodyId id : replay->world.ids()) {
    ASSERT_TRUE(replay->prepared.contains(id));
    EXPECT_NE(replay->prepared.at(id).caster, nullptr);
  }
  EXPECT_FALSE(news.take());
}

TEST(LoadProgress, shows_no_world_without_a_replay_or_an_observer) {
  LoadProgress watched, alone;
  watched.watch();
  ASSERT_TRUE(load_files(files({"knot.obj"}), nullptr, &watched).ok());
  EXPECT_FALSE(watched.take());
  ASSERT_TRUE(load_files({{checkout() / "assets/scenes/car-cut.json"}, {}, 0}, nullptr, &alone).ok());
  EXPECT_FALSE(alone.take());
}

// A ragged mesh of several components.
class LoadingRaggedMesh : public testing::Test {
 protected:
  void SetUp() override {
    Random random(1);
    Soup soup = both(both(sphere(48, 50, 1), moved(random_soup(300, random), {3, 0, 0}, 1)), book(5));
    for (Vec3& p : soup.positions) p.y += random.uniform(-1e-3, 1e-3);
    ASSERT_TRUE(write_mesh({soup.positions, soup.triangles, {}, {}}, file_, MeshFormat::kPly).ok());
  }
  // Until it was told so many times how far it is.
  Result<LoadedFiles> load_until(size_t stop) {
    reports_.clear();
    const Progress progress{[&](double fraction) {
      reports_.push_back(fraction);
      return reports_.size() != stop;
    }};
    return load_files({{file_}, {}, 0}, &progress);
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "ragged.ply";
  std::vector<double> reports_;
};

TEST_F(LoadingRaggedMesh, reports_progress_in_small_steps) {
  ASSERT_TRUE(load_until(0).ok());
  EXPECT_LT(reports_.size(), 1000u);
  EXPECT_GE(reports_.front(), 0);
  EXPECT_TRUE(std::is_sorted(reports_.begin(), reports_.end()));
  EXPECT_LE(reports_.back(), 1);
  reports_.insert(reports_.begin(), 0);
  reports_.push_back(1);
  for (size_t i = 1; i < reports_.size(); ++i) EXPECT_LT(reports_[i] - reports_[i - 1], 0.15) << reports_[i];
}

TEST_F(LoadingRaggedMesh, can_be_cancelled_at_any_report) {
  ASSERT_TRUE(load_until(0).ok());
  const size_t reports = reports_.size();
  for (size_t stop = 1; stop <= reports; ++stop) {
    const Result<LoadedFiles> loaded = load_until(stop);
    ASSERT_FALSE(loaded.ok()) << stop;
    EXPECT_EQ(loaded.error().message, "cancelled");
    EXPECT_EQ(reports_.size(), stop);
  }
}

}  // namespace
}  // namespace kerf::test
