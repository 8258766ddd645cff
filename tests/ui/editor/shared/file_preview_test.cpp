#include "ui/editor/shared/file_preview.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/random.h"
#include "core/mesh/mesh_file.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using Facts = std::vector<std::pair<std::string, std::string>>;
using test::write_text;

const Progress kGoesOn{[](double) { return true; }};

// A file of this content followed by zeros, which takes no space on the disk.
void write_sparse(const fs::path& file, const std::string& head, uintmax_t bytes) {
  write_text(file, head);
  fs::resize_file(file, bytes);
}

std::string obj_of(const Soup& soup) {
  std::string text;
  for (const Vec3& p : soup.positions)
    text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  for (const Soup::Triangle& t : soup.triangles)
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
            std::to_string(t[2] + 1) + "\n";
  return text;
}

// Returns the share of pixels that differ from the upper left one.
double covered_share(const Pixels& pixels) {
  size_t covered = 0;
  for (size_t i = 0; i < pixels.rgb.size(); i += 3) {
    int difference = 0;
    for (size_t c = 0; c < 3; ++c)
      difference = std::max(difference, std::abs(pixels.rgb[i + c] - pixels.rgb[c]));
    covered += difference > 8;
  }
  return static_cast<double>(covered) / (static_cast<double>(pixels.rgb.size()) / 3);
}

TEST(FilePreview, states_counts_and_size_of_a_mesh) {
  test::TemporaryFolder folder;
  write_text(folder / "brick.obj", obj_of(test::brick({2, 1, 3})));
  const FilePreview preview = preview_of({folder / "brick.obj"}, kGoesOn);
  EXPECT_EQ(preview.facts, (Facts{{"Faces", "12"}, {"Vertices", "8"}, {"Size", "2 x 1 x 3 m"}}));
  EXPECT_EQ(preview.note, "");
  const FilePreview in_inches =
      preview_of({folder / "brick.obj", Theme::kDark, {{"obj", FileFrame{FileUnit::kMillimetre}}}}, kGoesOn);
  EXPECT_EQ(in_inches.facts.back().second, "2 x 1 x 3 mm");
}

TEST(FilePreview, shows_a_scene_in_its_own_unit_and_up_axis) {
  test::TemporaryFolder folder;
  write_text(folder / "brick.obj", obj_of(test::brick({2, 1, 3})));
  const auto preview_with = [&](const std::string& shown) {
    write_text(folder / "scene.json", R"({"bodies": [{"mesh": "brick.obj"}])" + shown + "}");
    return preview_of({folder / "scene.json"}, kGoesOn);
  };
  const FilePreview usual = preview_with(""), own = preview_with(R"(, "shown": {"unit": "mm", "up": "z"})");
  EXPECT_EQ(usual.facts, (Facts{{"Bodies", "1"}, {"Faces", "12"}, {"Size", "2 x 1 x 3 m"}}));
  EXPECT_EQ(own.facts, (Facts{{"Bodies", "1"}, {"Faces", "12"}, {"Size", "2 x 1 x 3 mm"}}));
  EXPECT_NE(own.picture.rgb, usual.picture.rgb);
}

TEST(FilePreview, counts_the_shared_corners_of_a_mesh_once) {
  test::TemporaryFolder folder;
  write_text(folder / "one.stl",
             "solid a\n"
             "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
             "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
             "endsolid a\n");
  const Facts facts = preview_of({folder / "one.stl"}, kGoesOn).facts;
  ASSERT_GE(facts.size(), 2u);
  EXPECT_EQ(facts[0], (std::pair<std::string, std::string>("Faces", "2")));
  EXPECT_EQ(facts[1], (std::pair<std::string, std::string>("Vertices", "4")));
}

// The area that a brick covers is the sum of the areas of its sides, projected along the direction of view.
TEST(FilePreview, draws_the_silhouette_of_a_mesh) {
  test::TemporaryFolder folder;
  const Vec3 eye = glm::normalize(Vec3(0.55, 0.45, 0.85));
  const Vec3 right = glm::normalize(glm::cross(Vec3(0, 1, 0), eye)), up = glm::cross(eye, right);
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const Vec3 size(random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2));
    write_text(folder / "brick.obj", obj_of(test::moved(test::brick(size), {0.5, 0.5, 0.5}, 1)));
    const PreviewRequest request{
        folder / "brick.obj", Theme::kDark, {{"obj", FileFrame{FileUnit::kMetre, UpAxis::kY}}}};
    const FilePreview preview = preview_of(request, kGoesOn);
    const double area = size.y * size.z * eye.x + size.x * size.z * eye.y + size.x * size.y * eye.z;
    const double width = glm::dot(size, glm::abs(right)), height = glm::dot(size, glm::abs(up));
    const double scale = 0.88 * std::min(240 / width, 150 / height);
    EXPECT_NEAR(covered_share(preview.picture), area * scale * scale / (240 * 150), 0.02) << "seed " << seed;
  }
}

TEST(FilePreview, nearer_faces_hide_farther_ones) {
  test::TemporaryFolder folder;
  const auto picture_of = [&](const Soup& soup) {
    write_text(folder / "mesh.obj", obj_of(soup));
    return preview_of({folder / "mesh.obj"}, kGoesOn).picture.rgb;
  };
  const Soup ball = test::sphere(24, 32, 0.4), box = test::moved(test::brick({1, 1, 1}), Vec3(-0.5), 1);
  EXPECT_EQ(picture_of(box), picture_of(test::both(ball, box)));
  EXPECT_EQ(picture_of(box), picture_of(test::both(box, ball)));
}

TEST(FilePreview, states_only_the_header_of_large_files) {
  test::TemporaryFolder folder;
  const uintmax_t large = kMaxPreviewBytes + 84;
  write_sparse(folder / "a.ply",
               "ply\nformat binary_little_endian 1.0\nelement vertex 1234567\nproperty float x\n"
               "element face 7654321\nend_header\n",
               large);
  EXPECT_EQ(preview_of({folder / "a.ply"}, kGoesOn).facts,
            (Facts{{"Vertices", "1 234 567"}, {"Faces", "7 654 321"}}));
  write_sparse(folder / "a.off", "OFF\n100 200 300\n", large);
  EXPECT_EQ(preview_of({folder / "a.off"}, kGoesOn).facts, (Facts{{"Faces", "200"}, {"Vertices", "100"}}));
  std::string stl(84, '\0');
  stl[80 + 2] = 0x30;  // 0x300000 faces
  write_sparse(folder / "a.stl", stl, 84 + 50 * uintmax_t(0x300000));
  EXPECT_EQ(preview_of({folder / "a.stl"}, kGoesOn).facts, (Facts{{"Faces", "3 145 728"}}));
  write_sparse(folder / "a.obj", "v 0 0 0\n", large);
  const FilePreview preview = preview_of({folder / "a.obj"}, kGoesOn);
  EXPECT_TRUE(preview.facts.empty() && preview.picture.rgb.empty());
  EXPECT_NE(preview.note.find("too large"), std::string::npos);
}

TEST(FilePreview, counts_the_lines_of_drawings_and_the_strokes_of_paths_and_programs) {
  test::TemporaryFolder folder;
  write_text(folder / "a.svg",
             "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm' viewBox='0 0 9 9'>"
             "<line x1='1' y1='1' x2='5' y2='1'/><line x1='1' y1='3' x2='5' y2='3'/></svg>");
  write_text(folder / "a.json",
             R"({"strokes": [{"laser": {"radius": 0.001},
                 "keys": [{"t": 0, "origin": [0, 1, 0], "direction": [0, -1, 0]},
                          {"t": 1, "origin": [1, 1, 0], "direction": [0, -1, 0]}]}]})");
  write_text(folder / "a.nc", "G21 G90\nM4 S500\nG1 X10 F600\nM5\n");
  for (const auto& [name, fact] :
       {std::pair("a.svg", std::pair("Lines", "2")), std::pair("a.json", std::pair("Strokes", "1")),
        std::pair("a.nc", std::pair("Strokes", "1"))}) {
    const FilePreview preview = preview_of({folder / name}, kGoesOn);
    EXPECT_EQ(preview.note, "");
    EXPECT_EQ(preview.facts, (Facts{{fact.first, fact.second}})) << name;
  }
}

TEST(FilePreview, notes_why_a_file_cannot_be_read) {
  test::TemporaryFolder folder;
  EXPECT_NE(preview_of({folder / "none.obj"}, kGoesOn).note, "");
  write_text(folder / "bad.json", "{");
  EXPECT_NE(preview_of({folder / "bad.json"}, kGoesOn).note, "");
  write_text(folder / "bad.kerf", "{}");
  EXPECT_NE(preview_of({folder / "bad.kerf"}, kGoesOn).note, "");
  write_text(folder / "bad.stl", "solid");
  EXPECT_NE(preview_of({folder / "bad.stl"}, kGoesOn).note, "");
}

TEST(FilePreviewer, shows_only_the_last_selected_file) {
  test::TemporaryFolder folder;
  write_text(folder / "ball.obj", obj_of(test::sphere(60, 80, 1)));
  write_text(folder / "plate.obj", obj_of(test::plate(1)));
  FilePreviewer previewer;
  for (int i = 0; i < 20; ++i) {
    previewer.select(PreviewRequest{folder / "ball.obj"});
    EXPECT_EQ(previewer.shown(), nullptr);
    previewer.update(0);
    previewer.select(PreviewRequest{folder / "plate.obj"});
    EXPECT_EQ(previewer.shown(), nullptr);
  }
  previewer.update(1000);
  ASSERT_NE(previewer.shown(), nullptr);
  EXPECT_FALSE(previewer.busy());
  EXPECT_EQ(previewer.shown()->facts.front().second, "2");
  previewer.select(std::nullopt);
  EXPECT_EQ(previewer.shown(), nullptr);
  previewer.update(1000);
  EXPECT_EQ(previewer.shown(), nullptr);
}

}  // namespace
}  // namespace kerf
