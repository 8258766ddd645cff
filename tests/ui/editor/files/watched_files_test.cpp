#include "ui/editor/files/watched_files.h"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;
using test::write_text;

class Watched : public testing::Test {
 protected:
  Watched() {
    write_text(a_, "one");
    write_text(b_, "two");
    files_.watch({a_, b_});
  }
  // Changes the time alone, because two writes may fall into one tick of the clock of files.
  void touch(const fs::path& file, int seconds) {
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(seconds));
  }
  // The changes after the other program has finished.
  Paths changed() {
    files_.changed();
    return files_.changed();
  }

  test::TemporaryFolder folder_;
  fs::path a_ = folder_ / "a.obj", b_ = folder_ / "b.obj";
  WatchedFiles files_;
};

TEST_F(Watched, a_new_time_or_size_is_a_change_until_it_is_recorded) {
  EXPECT_EQ(changed(), Paths());
  touch(b_, -5);
  EXPECT_EQ(changed(), Paths{b_});
  EXPECT_EQ(changed(), Paths{b_});
  const fs::file_time_type time = fs::last_write_time(a_);
  write_text(a_, "longer");
  fs::last_write_time(a_, time);
  EXPECT_EQ(changed(), (Paths{a_, b_}));
  files_.watch({a_, b_});
  EXPECT_EQ(changed(), Paths());
}

TEST_F(Watched, a_mesh_with_another_content_does_not_fit_a_journal) {
  DocumentSession session;
  session.scene.bodies = {body_of_file(a_), body_of_file(b_)};
  ASSERT_TRUE(record_hashes(session.scene).ok());
  EXPECT_EQ(mismatched_mesh(session, {a_, b_}), std::nullopt);
  write_text(b_, "other");
  EXPECT_EQ(mismatched_mesh(session, {a_}), std::nullopt);
  EXPECT_EQ(mismatched_mesh(session, {a_, b_}), b_);
}

TEST_F(Watched, a_changed_buffer_of_gltf_is_found) {
  const fs::path mesh = folder_ / "car.gltf", buffer = folder_ / "car.bin", image = folder_ / "car.png";
  write_text(mesh, R"({"buffers": [{"uri": "car.bin"}], "images": [{"uri": "car.png"}]})");
  DocumentSession session;
  session.scene.bodies.resize(2);
  session.scene.bodies[0].mesh = a_;
  session.scene.bodies[1].mesh = mesh;
  EXPECT_EQ(changed_buffer(session, {}), std::nullopt);
  EXPECT_EQ(changed_buffer(session, {a_, mesh, image, folder_ / "other.bin"}), std::nullopt);
  EXPECT_EQ(changed_buffer(session, {buffer}), buffer);
}

TEST_F(Watched, a_file_counts_once_it_stays_the_same) {
  for (int i = 1; i <= 3; ++i) {
    touch(a_, i);
    EXPECT_EQ(files_.changed(), Paths());
    EXPECT_TRUE(files_.awaits_check());
  }
  EXPECT_EQ(files_.changed(), Paths{a_});
  EXPECT_FALSE(files_.awaits_check());
}

TEST_F(Watched, a_removed_file_counts_when_it_is_back) {
  fs::remove(a_);
  EXPECT_EQ(changed(), Paths());
  write_text(a_, "another");
  EXPECT_EQ(changed(), Paths{a_});
}

TEST(SideFiles, of_obj_are_its_libraries_and_their_images) {
  test::TemporaryFolder folder;
  const fs::path mesh = folder / "car.obj";
  write_text(mesh, "# a car\nmtllib my car.mtl\nmtllib a.mtl b.mtl \r\nv 0 0 0\n");
  write_text(folder / "my car.mtl", "newmtl paint\nmap_Kd -s 2 2 2 paint.png\nmap_Ks gone/gloss.png\n");
  write_text(folder / "paint.png", "");
  EXPECT_EQ(side_files_of(mesh), (Paths{folder / "my car.mtl", folder / "a.mtl", folder / "b.mtl",
                                        folder / "paint.png", folder / "gloss.png"}));
}

TEST(SideFiles, of_obj_are_listed_after_tabs_and_on_the_next_line) {
  test::TemporaryFolder folder;
  const fs::path mesh = folder / "car.obj";
  write_text(mesh, "mtllib\ta.mtl\n  mtllib b.mtl \\\r\n  c.mtl\r\nmtllibs d.mtl\nv 0 0 0\n");
  EXPECT_EQ(side_files_of(mesh), (Paths{folder / "a.mtl", folder / "b.mtl", folder / "c.mtl"}));
}

TEST(SideFiles, of_obj_include_images_in_the_folder_of_a_library) {
  test::TemporaryFolder folder;
  const fs::path mesh = folder / "car.obj";
  fs::create_directories(folder / "materials");
  write_text(mesh, "mtllib materials/car.mtl\nv 0 0 0\n");
  write_text(folder / "materials/car.mtl", "newmtl paint\nmap_Kd paint.png\n");
  write_text(folder / "materials/paint.png", "");
  EXPECT_EQ(side_files_of(mesh), (Paths{folder / "materials/car.mtl", folder / "materials/paint.png"}));
}

TEST(SideFiles, of_gltf_are_its_buffers_and_images) {
  test::TemporaryFolder folder;
  const fs::path mesh = folder / "car.gltf";
  write_text(mesh,
             R"({"buffers": [{"uri": "my%20car.bin"}, {"uri":"data:application/octet-stream;base64,AA"}],
                       "images": [{"uri" : "maps/paint.png"}, {"bufferView": 1}]})");
  fs::create_directories(folder / "maps");
  write_text(folder / "maps/paint.png", "");
  EXPECT_EQ(side_files_of(mesh), (Paths{folder / "my car.bin", folder / "maps/paint.png"}));
  EXPECT_TRUE(side_files_of(folder / "none.gltf").empty());
  write_text(folder / "a.stl", "\"uri\": \"a.bin\"");
  EXPECT_TRUE(side_files_of(folder / "a.stl").empty());
}

TEST(FilesOfDocument, are_its_journal_or_origin_and_its_meshes) {
  DocumentSession session;
  session.files = {"scene.json"};
  session.scene.bodies.resize(3);
  session.scene.bodies[0].mesh = "a.obj";
  session.scene.bodies[1].mesh = "b.obj";
  session.scene.bodies[2].mesh = "a.obj";
  EXPECT_EQ(files_of(session), (Paths{"scene.json", "a.obj", "b.obj"}));
  session.file = "work.kerf";
  EXPECT_EQ(files_of(session), (Paths{"work.kerf", "a.obj", "b.obj"}));
  EXPECT_EQ(files_to_reload(session), Paths{"work.kerf"});
}

TEST(ChangedFiles, are_named_and_counted) {
  EXPECT_EQ(words_on_changed({"/x/car.obj"}), "car.obj was changed by another program.");
  EXPECT_EQ(words_on_changed({"/x/car.obj", "b", "c"}),
            "car.obj and 2 more files were changed by other programs.");
}

}  // namespace
}  // namespace kerf
