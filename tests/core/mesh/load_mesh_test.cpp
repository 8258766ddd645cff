#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include "tests/support/random_edits.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(LoadMesh, reads_a_file_and_builds_its_mesh) {
  test::TemporaryFolder folder;
  test::write_text(folder / "plate.obj", test::kPlateObj);
  const auto built = load_mesh(folder / "plate.obj", nullptr);
  ASSERT_TRUE(built) << built.error().message;
  EXPECT_EQ(built->mesh.live_faces(), 2u);
  EXPECT_NEAR(built->report.area, 1, 1e-12);
}

TEST(LoadMesh, names_a_file_that_is_unreadable_or_has_no_faces) {
  test::TemporaryFolder folder;
  test::write_text(folder / "flat.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
  for (const char* name : {"flat.obj", "gone.obj"}) {
    const auto built = load_mesh(folder / name, nullptr);
    ASSERT_FALSE(built);
    EXPECT_NE(built.error().message.find(name), std::string::npos) << built.error().message;
  }
}

TEST(LoadMesh, reports_progress_and_can_be_cancelled) {
  test::TemporaryFolder folder;
  test::write_text(folder / "plate.obj", test::kPlateObj);
  double last = 0;
  const Progress watched{[&](double done) {
    EXPECT_GE(done, last);
    last = done;
    return true;
  }};
  EXPECT_TRUE(load_mesh(folder / "plate.obj", &watched));
  EXPECT_LE(last, 1);
  const Progress stopped{[](double) { return false; }};
  const auto built = load_mesh(folder / "plate.obj", &stopped);
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().message, cancelled().message);
}

}  // namespace
}  // namespace kerf
