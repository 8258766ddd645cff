#include "core/mesh/files/stl_reader.h"

#include <gtest/gtest.h>

#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

std::string binary_sample() { return test::sample_files()[6].bytes; }

std::string stl_refusal(const std::string& bytes) {
  const Result<Soup> soup = read_stl(bytes, "t.stl");
  return soup ? "" : soup.error().message;
}

TEST(StlReader, warns_of_bytes_after_the_last_triangle) {
  const Result<Soup> soup = read_stl(binary_sample() + "\n", "t.stl");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles.size(), 2u);
  EXPECT_EQ(soup->warnings, (std::vector<std::string>{"1 byte after the last triangle was passed over."}));
}

TEST(StlReader, refuses_a_binary_file_that_is_cut_short) {
  std::string bytes = binary_sample();
  bytes.pop_back();
  EXPECT_EQ(stl_refusal(bytes),
            "t.stl, byte 80: announces 2 triangles, but the file holds only 1; it is cut short or no STL.");
}

TEST(StlReader, takes_a_binary_file_that_says_solid) {
  std::string bytes = binary_sample();
  bytes.replace(0, 5, "solid");
  EXPECT_TRUE(read_stl(bytes, "t.stl"));
  EXPECT_TRUE(read_stl(bytes + "x", "t.stl"));
}

TEST(StlReader, reads_several_solids_of_text) {
  std::string text = test::sample_files()[5].bytes;
  const Result<Soup> soup = read_stl(text + text, "t.stl");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 4u);
  EXPECT_EQ(test::area(*soup), 2.0);
}

TEST(StlReader, names_the_line_where_text_is_wrong) {
  const std::string start = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  EXPECT_EQ(stl_refusal(start + "endloop\n"), "t.stl, line 5: expected 'vertex', found 'endloop'.");
  EXPECT_EQ(stl_refusal(start + "vertex 0 one 0\n"), "t.stl, line 5: expected a number, found 'one'.");
  EXPECT_EQ(stl_refusal(start + "vertex 0 1"),
            "t.stl, line 5: the file ends where a number must be; it is cut short.");
  EXPECT_EQ(stl_refusal("solid x\nendsolid"), "t.stl: there is no face in it, so there is nothing to cut.");
}

}  // namespace
}  // namespace kerf
