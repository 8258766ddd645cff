#include "ui/render/view/view_options.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(ShowList, accepts_names_in_any_order_with_spaces) {
  const auto show = parse_show_list("wire, aabb-hit,,pieces");
  ASSERT_TRUE(show.ok());
  EXPECT_TRUE(show->wire && show->aabb_hit && show->pieces);
  EXPECT_FALSE(show->aabb || show->normals);
}

TEST(ShowList, shadows_cover_all_surfaces_if_named_and_only_the_ground_otherwise) {
  EXPECT_EQ(parse_show_list("shadows")->shadows, Shadows::kAll);
  EXPECT_EQ(parse_show_list("wire")->shadows, Shadows::kGround);
}

TEST(ShowList, may_be_empty) { EXPECT_EQ(*parse_show_list(""), ShowOptions{}); }

TEST(ShowList, an_unknown_name_is_reported_with_the_valid_ones) {
  const auto show = parse_show_list("wire,wires");
  ASSERT_FALSE(show.ok());
  EXPECT_EQ(show.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(show.error().message.starts_with("'wires' is not an overlay")) << show.error().message;
  EXPECT_NE(show.error().message.find(offered_show_names()), std::string::npos);
}

}  // namespace
}  // namespace kerf
