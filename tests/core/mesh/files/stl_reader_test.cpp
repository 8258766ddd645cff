#include "core/mesh/files/readers.h"

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
  EXPECT_EQ(soup->warnings, (std::vector<std::string>{"1 byte after the last triangle was ignored."}));
}

TEST(StlReader, reports_attributes_of_triangles) {
  std::string bytes = binary_sample();
  bytes.back() = '\x80';  // the colour black in VisCAM
  const Result<Soup> soup = read_stl(bytes, "t.stl");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->warnings,
            std::vector<std::string>{"Attributes of triangles, such as colours, were ignored."});
  EXPECT_TRUE(read_stl(binary_sample(), "t.stl")->warnings.empty());
}

TEST(StlReader, rejects_a_truncated_binary_file) {
  std::string bytes = binary_sample();
  bytes.pop_back();
  EXPECT_EQ(
      stl_refusal(bytes),
      "t.stl, byte 80: declares 2 triangles, but the file holds only 1; it is truncated or not an STL file.");
}

TEST(StlReader, accepts_a_binary_file_that_begins_with_solid) {
  std::string bytes = binary_sample();
  bytes.replace(0, 5, "solid");
  EXPECT_TRUE(read_stl(bytes, "t.stl"));
  EXPECT_TRUE(read_stl(bytes + "x", "t.stl"));
}

// A square with the given number in its header.
std::string announcing(uint32_t count) {
  std::string bytes = binary_sample();
  for (size_t i = 0; i < sizeof count; ++i) bytes[80 + i] = static_cast<char>(count >> 8 * i);
  return bytes;
}

TEST(StlReader, reads_all_complete_triangles_despite_a_wrong_count) {
  for (const uint32_t count : {0u, 1u, 3u, 0xffffffffu}) {
    const Result<Soup> soup = read_stl(announcing(count), "t.stl");
    ASSERT_TRUE(soup) << count;
    EXPECT_EQ(soup->triangles_in_file, 2u);
    EXPECT_EQ(test::area(*soup), 1.0);
    ASSERT_EQ(soup->warnings.size(), 1u);
    EXPECT_NE(soup->warnings[0].find("but the file is as long as 2; all of them were read."),
              std::string::npos)
        << soup->warnings[0];
  }
}

TEST(StlReader, does_not_read_other_data_of_that_length_as_triangles) {
  std::string bytes = announcing(3);
  bytes.replace(84 + 12, 4, "\xff\xff\xff\xff");  // a coordinate that is no number
  EXPECT_NE(stl_refusal(bytes), "");
  EXPECT_NE(stl_refusal(std::string(84 + 50, 'a')), "");
  EXPECT_NE(stl_refusal(announcing(3).substr(0, 84)), "");
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

constexpr const char* kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n";

TEST(StlReader, accepts_sloppy_text_files_and_warns_with_the_location) {
  const std::string facet = kFacet, split = replaced(facet, "end", "end ");
  const struct {
    std::string text, warning;
  } files[] = {
      {"solid x\n" + split + "endsolid x\n",
       "Invalid STL in 2 places, the first in line 7: 'end loop' was read as 'endloop'."},
      {"solid A\nsolid A\n" + facet + "endsolid A\nendsolid A\n",
       "Invalid STL in 2 places, the first in line 2: 'solid' before the 'endsolid' of the last "
       "one."},
      {"solid\n" + facet + "ENDSOLIDtwo\n",
       "Invalid STL in line 9: expected 'endsolid', a space and the name."},
      {"solid\n" + facet + "end solid two\n",
       "Invalid STL in line 9: expected 'endsolid', a space and the name."},
      {"solid x\ncolor 0.1 0.2 0.3\n" + facet + "endsolid\n", "Invalid STL in line 2: 'color' was skipped."},
      {"solid x\n" + facet, "Invalid STL in line 9: the file ends without 'endsolid'; it may be truncated."},
      {facet + "endsolid\n", "Invalid STL in 2 places, the first in line 1: 'facet' without 'solid'."},
      {"solid x\n" + facet + "endsolid\nwritten by hand\n", "Invalid STL in line 10: 'written' was skipped."},
  };
  for (const auto& file : files) {
    const Result<Soup> soup = read_stl(file.text, "t.stl");
    ASSERT_TRUE(soup) << file.text << soup.error().message;
    EXPECT_EQ(soup->triangles_in_file, 1u) << file.text;
    EXPECT_EQ(soup->warnings, (std::vector<std::string>{file.warning + " 1 facet was read."}));
  }
}

TEST(StlReader, continues_after_skipped_lines_between_solids) {
  const std::string facet = kFacet;
  const Result<Soup> soup =
      read_stl("solid\n" + facet + "endsolid\n; two\nsolid solid two\n" + facet, "t.stl");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 2u);
}

TEST(StlReader, reads_several_text_solids) {
  std::string text = test::sample_files()[5].bytes;
  const Result<Soup> soup = read_stl(text + text, "t.stl");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 4u);
  EXPECT_EQ(test::area(*soup), 2.0);
}

TEST(StlReader, names_the_line_of_a_text_error) {
  const std::string start = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  EXPECT_EQ(stl_refusal(start + "endloop\n"), "t.stl, line 5: expected 'vertex', found 'endloop'.");
  EXPECT_EQ(stl_refusal(start + "vertex 0 one 0\n"), "t.stl, line 5: expected a number, found 'one'.");
  EXPECT_EQ(stl_refusal(start + "vertex 0 1"),
            "t.stl, line 5: the file ends where a number is expected; it is truncated.");
  EXPECT_EQ(stl_refusal(std::string("solid x\n") + kFacet + "fac"),
            "t.stl, line 9: expected 'facet' or 'endsolid', found 'fac'.");
  EXPECT_EQ(stl_refusal("solid x\nouter loop\n"),
            "t.stl, line 2: expected 'facet' or 'endsolid', found 'outer'.");
  EXPECT_EQ(stl_refusal("solid x\nendsolid"), "t.stl: the file has no faces.");
}

}  // namespace
}  // namespace kerf
