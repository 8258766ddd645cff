#include "core/mesh/files/readers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

const std::string kVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kData = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string file(const std::string& elements, const std::string& data, const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + data;
}

std::string ply_refusal(const std::string& bytes) {
  const Result<Soup> soup = read_ply(bytes, "t.ply");
  return soup ? "" : soup.error().message;
}

TEST(PlyReader, accepts_every_integer_type_for_list_counts) {
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int16",
                           "uint16", "int32", "uint32", "int64", "uint64"}) {
    const std::string faces =
        std::string("element face 1\nproperty list ") + type + " " + type + " vertex_index\n";
    EXPECT_EQ(ply_refusal(file(kVertices + faces, kData)), "") << type;
  }
}

TEST(PlyReader, reads_strips_with_restarts_and_flips_every_second_triangle) {
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const Result<Soup> soup =
      read_ply(file("element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + strips,
                    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 -1 3 1 0 -1\n"),
               "t.ply");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles, (std::vector<Soup::Triangle>{{0, 1, 2}, {2, 1, 3}, {3, 1, 0}}));
  EXPECT_EQ(soup->faces_in_file, 3u);
}

TEST(PlyReader, counts_faces_with_missing_vertices) {
  const std::string faces = "element face 3\nproperty list uchar int vertex_indices\n";
  const Result<Soup> soup =
      read_ply(file(kVertices + faces, "0 0 0\n1 0 0\n0 1 0\n3 0 1 70000\n4 0 1 2 -5\n3 0 1 2\n"), "t.ply");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 4u);
  EXPECT_EQ(soup->invalid_faces_dropped, 3u);
}

TEST(PlyReader, counts_faces_of_fewer_than_three_corners) {
  const std::string faces = "element face 3\nproperty list uchar int vertex_indices\n";
  const Result<Soup> soup =
      read_ply(file(kVertices + faces, "0 0 0\n1 0 0\n0 1 0\n2 0 1\n0\n3 0 1 2\n"), "t.ply");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles_in_file, 1u);
  EXPECT_EQ(soup->incomplete_faces_dropped, 2u);
}

TEST(PlyReader, does_not_take_a_newline_in_the_data_for_the_end_of_the_header) {
  std::string elements = "element vertex 3\nproperty char x\nproperty char y\nproperty char z\n" + kFaces;
  std::string data("\n\0\0\0\n\0\0\0\n\3\0\0\0\0\1\0\0\0\2\0\0\0", 22);
  const Result<Soup> soup = read_ply(file(elements, data, "binary_little_endian"), "t.ply");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->positions[0], Vec3(10, 0, 0));
}

TEST(PlyReader, takes_a_newline_after_a_header_with_carriage_returns_for_data) {
  const std::string elements =
      "element vertex 3\nproperty char x\nproperty char y\nproperty char z\n" + kFaces;
  const std::string data("\n\0\0\0\n\0\0\0\n\3\0\0\0\0\1\0\0\0\2\0\0\0", 22);
  std::string bytes = file(elements, "", "binary_little_endian");
  std::replace(bytes.begin(), bytes.end(), '\n', '\r');
  const Result<Soup> soup = read_ply(bytes + data, "t.ply");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->positions[0], Vec3(10, 0, 0));
  EXPECT_TRUE(soup->warnings.empty());
}

TEST(PlyReader, reports_lines_with_a_missing_or_extra_value) {
  EXPECT_EQ(ply_refusal(file(kVertices + kFaces, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n")),
            "t.ply, line 12: the line continues after the properties of 'vertex' 1; a property before may be "
            "missing.");
  EXPECT_NE(ply_refusal(file(kVertices + kFaces, "0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")), "");
}

TEST(PlyReader, rejects_counts_that_exceed_the_file) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string huge =
        "element vertex 4294967295\nproperty float x\nproperty float y\nproperty float z\n";
    EXPECT_NE(ply_refusal(file(huge + kFaces, kData, format)).find("declares 4294967295 times 'vertex'"),
              std::string::npos);
  }
  EXPECT_NE(ply_refusal(file(kVertices + kFaces, "0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n")), "");
  EXPECT_NE(ply_refusal(file(kVertices + kFaces, "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")), "");
  EXPECT_EQ(ply_refusal(file("element vertex -3\n", "")), "t.ply, line 3: declares -3 elements.");
}

TEST(PlyReader, is_fast_for_many_elements) {
  std::string others;
  for (int i = 0; i < 200'000; ++i) others += "element other" + std::to_string(i) + " 0\n";
  EXPECT_EQ(ply_refusal(file(others + kVertices + kFaces, kData)), "");
}

TEST(PlyReader, is_fast_for_a_huge_element_without_properties) {
  EXPECT_EQ(ply_refusal(file("element nothing 9000000000000000000\n" + kVertices + kFaces, kData)), "");
}

TEST(PlyReader, rejects_an_invalid_header) {
  EXPECT_EQ(ply_refusal("ply\nformat ascii 1.0\n"),
            "t.ply: the header has no 'end_header'; the file is truncated.");
  EXPECT_EQ(ply_refusal(file("property float x\n", "")),
            "t.ply, line 3: a property comes before the first element.");
  EXPECT_EQ(ply_refusal(file("element vertex 1\nproperty list float int x\n", "")),
            "t.ply, line 4: expected an integer type, found 'float'.");
  EXPECT_EQ(ply_refusal(file("element vertex 1\nproperty quad x\n", "")),
            "t.ply, line 4: expected a type, found 'quad'.");
  EXPECT_EQ(ply_refusal(file(kVertices + kVertices, "")),
            "t.ply, line 7: declares the element 'vertex' twice.");
  EXPECT_EQ(
      ply_refusal(file("element vertex 1\nproperty float x\nproperty float y\n" + kFaces, "0 0\n3 0 1 2\n")),
      "t.ply: the element 'vertex' must have one property 'z'.");
  EXPECT_EQ(ply_refusal("ply\nend_header\n"), "t.ply, line 2: the header has no 'format'.");
}

TEST(PlyReader, skips_stray_lines_before_the_first_element_with_a_note) {
  const std::string blender = "Created by Blender3D 2.46 - www.blender.org, source file: cube.blend\n";
  for (const char* line_end : {"\n", "\r\n"}) {
    std::string bytes = file(blender + kVertices + kFaces, kData);
    for (size_t at = 0; (at = bytes.find('\n', at)) != std::string::npos; at += strlen(line_end))
      bytes.replace(at, 1, line_end);
    const Result<Soup> soup = read_ply(bytes, "t.ply");
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->triangles, (std::vector<Soup::Triangle>{{0, 1, 2}}));
    EXPECT_EQ(soup->warnings,
              std::vector<std::string>{"1 stray line before the first element, line 3, was skipped."});
  }
  const Result<Soup> soup = read_ply("ply\n" + blender + "\nformat ascii 1.0\ncomment c\n" + blender +
                                         kVertices + kFaces + "end_header\n" + kData,
                                     "t.ply");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(
      soup->warnings,
      std::vector<std::string>{"2 stray lines before the first element, the first in line 2, were skipped."});
}

TEST(PlyReader, rejects_stray_lines_elsewhere_in_the_header) {
  const std::string stray = "Created by hand\n";
  const std::string why = "expected 'element', 'property' or 'end_header', found 'Created'.";
  EXPECT_EQ(ply_refusal(file(stray, "")), "t.ply, line 3: " + why);
  EXPECT_EQ(ply_refusal("ply\n" + stray), "t.ply, line 2: " + why);
  EXPECT_EQ(ply_refusal(file(stray + "property float x\n" + kVertices + kFaces, kData)),
            "t.ply, line 3: " + why);
  EXPECT_EQ(ply_refusal(file(kVertices + stray + kFaces, kData)), "t.ply, line 7: " + why);
  EXPECT_EQ(ply_refusal(file(kVertices + kFaces + stray, kData)), "t.ply, line 9: " + why);
  const std::string bytes = "Created\x01\n";
  EXPECT_EQ(ply_refusal(file(bytes + kVertices + kFaces, kData)), "t.ply, line 3: " + why);
}

TEST(PlyReader, reports_colours_of_faces) {
  const std::string colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const Result<Soup> soup =
      read_ply(file(kVertices + kFaces + colours, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"), "t.ply");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_TRUE(soup->colours.empty());
  EXPECT_EQ(soup->warnings, std::vector<std::string>{"Colours of faces were ignored."});
}

TEST(PlyReader, preserves_double_precision) {
  const std::string vertices = "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
  const Result<Soup> soup =
      read_ply(file(vertices + kFaces, "1000000.123456 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->positions[0].x, 1000000.123456);
}

}  // namespace
}  // namespace kerf
