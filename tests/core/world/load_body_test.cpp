#include "core/world/body_creation.h"

#include <gtest/gtest.h>

#include "tests/support/random_edits.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(LoadBody, creates_a_body_with_tree_and_piece_from_a_file) {
  test::TemporaryFolder folder;
  test::write_text(folder / "plate.obj", test::kPlateObj);
  const auto body = load_body("plate", folder / "plate.obj", nullptr);
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ(body->own_name(), "plate");
  EXPECT_EQ(body->tree.leaf_count(), 2u);
  ASSERT_EQ(body->pieces.size(), 1u);
  EXPECT_EQ(body->pieces[0].faces, 2u);
  EXPECT_NEAR(body->pieces[0].area, 1, 1e-12);
}

TEST(LoadBody, names_a_missing_file) {
  const auto body = load_body("plate", "/nowhere/plate.obj", nullptr);
  ASSERT_FALSE(body);
  EXPECT_NE(body.error().message.find("/nowhere/plate.obj"), std::string::npos);
}

}  // namespace
}  // namespace kerf
