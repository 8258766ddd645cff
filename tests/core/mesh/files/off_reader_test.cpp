#include "core/mesh/files/readers.h"

#include <gtest/gtest.h>

#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

std::string off_refusal(const std::string& text) {
  const Result<Soup> soup = read_off(text, "t.off");
  return soup ? "" : soup.error().message;
}

TEST(OffReader, accepts_every_header_variant) {
  const std::string data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* header :
       {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF\n# by hand\n\n3 1 3\n", "# first\nOFF\n3 1\n", "OFF3 1 0\n",
        "OFF\r\n3\n1\n0\n", "CNOFF\n3 1 0\n", "STOFF\n3 1 0\n"}) {
    const Result<Soup> soup = read_off(header + data, "t.off");
    ASSERT_TRUE(soup) << header << soup.error().message;
    EXPECT_EQ(soup->triangles, (std::vector<Soup::Triangle>{{0, 1, 2}})) << header;
    EXPECT_TRUE(soup->warnings.empty());
  }
}

TEST(OffReader, ignores_values_after_positions_and_corners) {
  const Result<Soup> soup =
      read_off("COFF\n4 1 0\n0 0 0 9 9 9\n1 0 0#red\n1 1 0 1 # c\n0 1 0\n4 0 1 2 3 .5 .5 .5\n", "");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->positions[2], Vec3(1, 1, 0));
  EXPECT_EQ(test::area(*soup), 1.0);
  ASSERT_FALSE(soup->warnings.empty());
  EXPECT_EQ(soup->warnings.back(), "Colours of faces were ignored.");
}

TEST(OffReader, reports_values_of_vertices_that_are_not_read) {
  const auto warnings = [](const std::string& keyword, const std::string& values) {
    const Result<Soup> soup =
        read_off(keyword + "\n3 1 0\n0 0 0 " + values + "\n1 0 0\n0 1 0\n3 0 1 2\n", "t.off");
    EXPECT_TRUE(soup);
    return soup ? soup->warnings : std::vector<std::string>();
  };
  EXPECT_EQ(warnings("NOFF", "0 0 1"), std::vector<std::string>{"Normals were ignored."});
  EXPECT_EQ(warnings("STOFF", "0.5 1 # c"), std::vector<std::string>{"UVs were ignored."});
  EXPECT_EQ(warnings("STCNOFF", "0 0 1 0.5 0.5 0 0.5 1"),
            std::vector<std::string>{"Normals and UVs were ignored."});
  EXPECT_EQ(
      warnings("OFF", "255 0 0"),
      std::vector<std::string>{
          "Numbers after the positions of vertices were ignored, because the keyword is OFF, not COFF."});
  EXPECT_EQ(warnings("COFF", "0.5 0.5 0 1"), std::vector<std::string>());
  EXPECT_EQ(warnings("OFF", "# red"), std::vector<std::string>());
}

TEST(OffReader, counts_faces_with_missing_vertices) {
  const Result<Soup> soup =
      read_off("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n4 0 1 2 -1\n3 0 1 2\n", "t.off");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 4u);
  EXPECT_EQ(soup->invalid_faces_dropped, 3u);
}

TEST(OffReader, counts_faces_of_fewer_than_three_corners) {
  const Result<Soup> soup = read_off("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n0\n3 0 1 2\n", "t.off");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 1u);
  EXPECT_EQ(soup->incomplete_faces_dropped, 2u);
}

TEST(OffReader, rejects_counts_that_exceed_the_file) {
  EXPECT_EQ(off_refusal("OFF\n3 2000000000 0\n0 0 0\n"),
            "t.off, line 2: declares 2000000000 faces, but the 9 bytes that follow cannot hold them.");
  EXPECT_EQ(off_refusal("OFF\n-1 1 0\n0 0 0\n"),
            "t.off, line 2: declares -1 vertices, but the 11 bytes that follow cannot hold them.");
  EXPECT_NE(off_refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"), "");
}

TEST(OffReader, rejects_truncated_data) {
  EXPECT_EQ(off_refusal("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "t.off, line 7: the file ends where the number of corners of face 1 of 2 is expected; it is "
            "truncated.");
}

TEST(OffReader, rejects_binary_data_and_other_dimensions) {
  EXPECT_EQ(off_refusal("OFF BINARY\n"),
            "t.off, line 1: binary OFF is not supported; save it as text, or as PLY.");
  EXPECT_EQ(off_refusal("4OFF\n"), "t.off, line 1: OFF with other than three coordinates is not supported.");
  EXPECT_EQ(off_refusal("OFFICE\n"), "t.off, line 1: expected the keyword OFF, found 'OFFICE'.");
}

}  // namespace
}  // namespace kerf
