#include "core/mesh/files/readers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/files/mtl_file.h"
#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Soup read(const std::string& text) {
  Result<Soup> soup = read_obj(text, "t.obj");
  EXPECT_TRUE(soup) << (soup ? "" : soup.error().message);
  return soup ? *soup : Soup{};
}

std::string obj_refusal(const std::string& text) {
  const Result<Soup> soup = read_obj(text, "t.obj");
  return soup ? "" : soup.error().message;
}

TEST(ObjReader, counts_a_face_with_an_index_out_of_range_and_continues) {
  for (const char* corners :
       {"1 2 4", "0 1 2", "-4 1 2", "1 2 99999999999999999999", "/ / /", "/1/1 /1/1 /1/1"}) {
    const Soup soup = read(kTriangle + "f " + corners + "\nf 1 2 3\n");
    EXPECT_EQ(soup.triangles_in_file, 2u) << corners;
    EXPECT_EQ(soup.invalid_faces_dropped, 1u) << corners;
    EXPECT_EQ(soup.triangles.size(), 1u) << corners;
  }
}

TEST(ObjReader, counts_an_invalid_polygon_as_all_its_triangles) {
  const Soup soup = read(kTriangle + "f 1 2 3 9 9\nf 1 2 3\n");
  EXPECT_EQ(soup.faces_in_file, 2u);
  EXPECT_EQ(soup.triangles_in_file, 4u);
  EXPECT_EQ(soup.invalid_faces_dropped, 3u);
}

TEST(ObjReader, counts_faces_of_fewer_than_three_corners) {
  const Soup soup = read(kTriangle + "f 1 2\nf 3\nf 1 9\nf 1 2 3\nf 1 2 9\n");
  EXPECT_EQ(soup.faces_in_file, 5u);
  EXPECT_EQ(soup.incomplete_faces_dropped, 3u);
  EXPECT_EQ(soup.triangles_in_file, 2u);
  EXPECT_EQ(soup.invalid_faces_dropped, 1u);
  EXPECT_EQ(obj_refusal(kTriangle + "f 1 2\nf 1 2 9\n"),
            "t.obj: no face is usable: all 2 refer to missing vertices or have fewer than three corners.");
}

TEST(ObjReader, accepts_any_line_ending_a_bom_and_trailing_comments) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xef\xbb\xbfv 0 0 0#a|v 1 0 0 # b||v 0 1 0|# c \\|f 1 2 3 # d|f 3 \\|2 1";
    for (size_t at; (at = text.find('|')) != std::string::npos;) text.replace(at, 1, end);
    const Soup soup = read(text);
    EXPECT_EQ(soup.triangles, (std::vector<Soup::Triangle>{{0, 1, 2}, {2, 1, 0}}));
  }
}

TEST(ObjReader, resolves_negative_indices_from_the_last_vertex) {
  const Soup soup = read(kTriangle + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n");
  EXPECT_EQ(soup.triangles, (std::vector<Soup::Triangle>{{0, 1, 2}, {3, 2, 1}}));
}

TEST(ObjReader, accepts_faces_before_their_vertices) {
  EXPECT_EQ(read("f 1 2 3\n" + kTriangle).triangles.size(), 1u);
}

TEST(ObjReader, keeps_non_finite_positions) {
  const Soup soup = read("v nan inf 1.#IND\nv 1e400 0 0\nv 0 1 3.1+e2\nf 1 2 3\n");
  EXPECT_TRUE(std::isnan(soup.positions[0].x));
  EXPECT_TRUE(std::isinf(soup.positions[0].y));
  EXPECT_TRUE(std::isnan(soup.positions[0].z));
  EXPECT_TRUE(std::isinf(soup.positions[1].x));
  EXPECT_TRUE(std::isnan(soup.positions[2].z));
  ASSERT_EQ(soup.warnings.size(), 1u);
  EXPECT_EQ(soup.warnings[0], "1 garbled number, in line 3, counts as not finite.");
}

TEST(ObjReader, numbers_materials_by_first_use) {
  const Soup soup =
      read(kTriangle + "f 1 2 3\nusemtl b\nusemtl a c \nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl a c\nf 1 2 3");
  EXPECT_EQ(soup.material_names, (std::vector<std::string>{"", "a c", "b"}));
  EXPECT_EQ(soup.materials, (std::vector<uint16_t>{0, 1, 2, 1}));
}

std::vector<std::string> part_names(const Soup& soup) {
  std::vector<std::string> names;
  for (const MeshPart& part : soup.parts) names.push_back(part.name);
  return names;
}

TEST(ObjReader, keeps_hash_signs_in_names_of_every_kind) {
  const Soup soup =
      read(kTriangle +
           "o rig #1 # a\ng left#1 #2 shared \\\n  last#3\nusemtl br.png^[colorize:#4ab:255 # b\n"
           "f 1 2 3 # a comment\n# a comment\nusemtl #4ab\nf 1 2 3\n");
  EXPECT_EQ(part_names(soup), (std::vector<std::string>{"rig #1 # a", "left#1", "#2", "shared", "last#3"}));
  EXPECT_EQ(soup.material_names, (std::vector<std::string>{"br.png^[colorize:#4ab:255 # b", "#4ab"}));
  EXPECT_EQ(soup.triangles.size(), 2u);
}

TEST(ObjReader, joins_the_lines_of_a_list_of_libraries) {
  const test::TemporaryFolder folder;
  const std::string text = "mtllib a.mtl \\\r\n  b.mtl\r\n" + kTriangle + "usemtl blue\nf 1 2 3\n";
  test::write_text(folder / "t.obj", text);
  test::write_text(folder / "a.mtl", "newmtl red\nKd 1 0 0\n");
  test::write_text(folder / "b.mtl", "newmtl blue\nKd 0 0 1\n");
  const Result<Soup> soup = read_obj(text, "t.obj", nullptr, folder.path());
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_TRUE(soup->warnings.empty());
  ASSERT_NE(soup->surfaces, nullptr);
  ASSERT_EQ(soup->surfaces->materials[0].mtl.size(), 1u);
  EXPECT_EQ(soup->surfaces->materials[0].mtl[0].text, "Kd 0 0 1");
  EXPECT_EQ(files_of_obj(folder / "t.obj"),
            (std::vector<std::filesystem::path>{folder / "a.mtl", folder / "b.mtl"}));
}

TEST(ObjReader, accepts_a_missing_name_at_the_end_of_the_file) {
  for (const char* keyword : {"o", "g", "usemtl", "mtllib"}) {
    const Soup soup = read(kTriangle + "f 1 2 3\n" + keyword);
    EXPECT_EQ(soup.triangles.size(), 1u) << keyword;
    EXPECT_TRUE(soup.parts.empty()) << keyword;
  }
}

TEST(ObjReader, has_no_material_list_for_a_single_material) {
  EXPECT_TRUE(read(kTriangle + "f 1 2 3\n").material_names.empty());
  const Soup soup = read(kTriangle + "usemtl a\nf 1 2 3\n");
  EXPECT_TRUE(soup.materials.empty());
  EXPECT_EQ(soup.material_names, (std::vector<std::string>{"a"}));
}

TEST(ObjReader, keeps_materials_aligned_when_polygons_are_dropped) {
  const Soup soup = read(kTriangle + "v 1 1 0\nf 1 2 4 3\nusemtl b\nf 1 2 9\nf 1 2\nf 1 2 3\n");
  EXPECT_EQ(soup.triangles.size(), 3u);
  EXPECT_EQ(soup.materials, (std::vector<uint16_t>{0, 0, 1}));
}

TEST(ObjReader, names_the_line_and_word_of_an_error) {
  EXPECT_EQ(obj_refusal("v 0 0 0\nv 1 zero 0\n"), "t.obj, line 2: expected the y coordinate, found 'zero'.");
  EXPECT_EQ(obj_refusal("v 0 0 0\r\nv 1 0\r\n"),
            "t.obj, line 2: the line ends where the z coordinate is expected.");
  EXPECT_EQ(obj_refusal("v 0,5 0 0\n"),
            "t.obj, line 1: expected the x coordinate, found '0,5'; write decimal points, not commas.");
  EXPECT_EQ(obj_refusal(kTriangle + "f 1 2 3f 1 2 3\n"),
            "t.obj, line 4: expected a corner of a face, like 7 or 7/7/7, found '3f'.");
  EXPECT_EQ(obj_refusal("v 0 0"),
            "t.obj, line 1: the file ends where the z coordinate is expected; it is truncated.");
}

TEST(ObjReader, rejects_a_file_without_valid_faces) {
  EXPECT_EQ(obj_refusal(kTriangle), "t.obj: the file has no faces.");
  EXPECT_EQ(obj_refusal(kTriangle + "f 7 8 9\n"),
            "t.obj: no face is usable: all 1 refer to missing vertices.");
}

TEST(ObjReader, rejects_binary_data_and_other_encodings) {
  EXPECT_EQ(obj_refusal(std::string("v 0 0 0\0", 8)), "t.obj, byte 7: a zero byte, so this is not OBJ text.");
  EXPECT_EQ(obj_refusal(std::string("\xff\xfev\0 \0", 6)), "t.obj: this is UTF-16 text; save it as UTF-8.");
}

TEST(ObjReader, reports_skipped_content) {
  const Soup soup = read(kTriangle + "l 1 2\nblah\nf 1 2 3\n");
  ASSERT_EQ(soup.warnings.size(), 1u);
  EXPECT_EQ(soup.warnings[0], "2 statements that define no face were skipped, the first 'l'.");
}

TEST(ObjReader, can_be_cancelled) {
  const Progress stop{[](double) { return false; }};
  const Result<Soup> soup = read_obj(kTriangle + "f 1 2 3\n", "t.obj", &stop);
  ASSERT_FALSE(soup);
  EXPECT_EQ(soup.error().code, ErrorCode::kFailed);
  EXPECT_EQ(soup.error().message, "cancelled");
}

}  // namespace
}  // namespace kerf
