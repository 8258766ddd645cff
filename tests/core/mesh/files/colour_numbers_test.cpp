#include "core/mesh/files/vertex_colour.h"

#include <gtest/gtest.h>

#include "core/mesh/files/readers.h"

namespace kerf {
namespace {

using Colours = std::vector<VertexColour>;

constexpr uint16_t kFull = VertexColour::kFull;
constexpr uint16_t byte(int value) { return static_cast<uint16_t>(257 * value); }
const std::string kBytes = "Vertex colours were read as numbers from 0 to 255, because some exceed 1.";
const std::string kFractions = "Vertex colours were read as numbers from 0 to 1; greater ones count as 1.";

// The soup of a triangle whose vertices have these words after their coordinates.
using Words = std::array<std::string, 3>;
Soup obj(const Words& words) {
  const Result<Soup> soup = read_obj(
      "v 0 0 0 " + words[0] + "\nv 1 0 0 " + words[1] + "\nv 0 1 0 " + words[2] + "\nf 1 2 3\n", "t.obj");
  EXPECT_TRUE(soup) << (soup ? "" : soup.error().message);
  return soup ? *soup : Soup();
}
Soup off(const std::string& keyword, const Words& words) {
  const Result<Soup> soup = read_off(
      keyword + "\n3 1 0\n0 0 0 " + words[0] + "\n1 0 0 " + words[1] + "\n0 1 0 " + words[2] + "\n3 0 1 2\n",
      "t.off");
  EXPECT_TRUE(soup) << (soup ? "" : soup.error().message);
  return soup ? *soup : Soup();
}
Soup ply(const Words& words) {
  const Result<Soup> soup = read_ply(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float red\nproperty float green\nproperty float blue\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 " +
          words[0] + "\n1 0 0 " + words[1] + "\n0 1 0 " + words[2] + "\n3 0 1 2\n",
      "t.ply");
  EXPECT_TRUE(soup) << (soup ? "" : soup.error().message);
  return soup ? *soup : Soup();
}

TEST(ColourNumbers, up_to_255_are_bytes_in_formats_without_a_declared_unit) {
  const Words words{"255 128 0", "0 0 1", "7 7 7"};
  const Colours expected{
      {{kFull, byte(128), 0, kFull}}, {{0, 0, byte(1), kFull}}, {{byte(7), byte(7), byte(7), kFull}}};
  for (const Soup& soup : {obj(words), off("COFF", words), ply(words)}) {
    EXPECT_EQ(soup.colours, expected) << soup.format;
    EXPECT_EQ(soup.warnings, (std::vector<std::string>{kBytes})) << soup.format;
  }
}

TEST(ColourNumbers, up_to_one_are_fractions_without_a_note) {
  const Words words{"1 0.5 0", "0 0 1", "0.25 0 0"};
  const Colours expected{{{kFull, 32768, 0, kFull}}, {{0, 0, kFull, kFull}}, {{16384, 0, 0, kFull}}};
  for (const Soup& soup : {obj(words), off("COFF", words), ply(words)}) {
    EXPECT_EQ(soup.colours, expected) << soup.format;
    EXPECT_TRUE(soup.warnings.empty()) << soup.format;
  }
}

TEST(ColourNumbers, slightly_above_one_are_clamped_and_far_above_are_bytes) {
  const Soup bright = obj({"1.5 0.5 0", "0 0 1", "0 0 0"});
  EXPECT_EQ(bright.colours[0].part[0], kFull);
  EXPECT_EQ(bright.colours[0].part[1], 32768);
  EXPECT_EQ(bright.warnings, (std::vector<std::string>{kFractions}));
  const Soup averaged = obj({"127.5 63.75 0", "0 0 255", "0 0 0"});
  EXPECT_EQ(averaged.colours[0].part[0], 32768);
  EXPECT_EQ(averaged.warnings, (std::vector<std::string>{kBytes}));
}

TEST(ColourNumbers, of_opacity_have_a_separate_unit) {
  EXPECT_EQ(obj({"255 0 0 1", "0 255 0 1", "0 0 9 1"}).colours[0], (VertexColour{{kFull, 0, 0, kFull}}));
  EXPECT_EQ(obj({"255 0 0 51", "0 255 0 1", "0 0 9 1"}).colours[0], (VertexColour{{kFull, 0, 0, byte(51)}}));
  EXPECT_EQ(obj({"0.5 0 0 255", "0 0 0 255", "0 0 0 51"}).colours[0], (VertexColour{{32768, 0, 0, kFull}}));
  EXPECT_EQ(obj({"1 0 0 255", "0 0 0 255", "0 0 0 51"}).colours[0], (VertexColour{{byte(1), 0, 0, kFull}}));
}

TEST(ColourNumbers, default_to_opaque_white) {
  const Soup soup = obj({"", "200 0 0", ""});
  EXPECT_EQ(soup.colours, (Colours{{}, {{byte(200), 0, 0, kFull}}, {}}));
  EXPECT_TRUE(obj({"", "", ""}).colours.empty());
}

TEST(ColourNumbers, in_off_follow_normals_and_precede_texture_coordinates) {
  const VertexColour colour{{byte(200), byte(100), 0, byte(50)}};
  const auto first = [](const std::string& keyword, const std::string& words) {
    return off(keyword, {words, words, words}).colours;
  };
  EXPECT_EQ(first("COFF", "200 100 0 50"), (Colours{colour, colour, colour}));
  EXPECT_EQ(first("CNOFF", "0 0 1 200 100 0 50"), (Colours{colour, colour, colour}));
  EXPECT_EQ(first("STCNOFF", "0 0 1 200 100 0 50 0.5 0.5"), (Colours{colour, colour, colour}));
  EXPECT_EQ(first("STCOFF", "200 100 0 0.5 0.5")[0], (VertexColour{{byte(200), byte(100), 0, kFull}}));
  EXPECT_TRUE(first("OFF", "200 100 0").empty());
  EXPECT_TRUE(first("NOFF", "0 0 1").empty());
  EXPECT_TRUE(first("COFF", "").empty());
  EXPECT_TRUE(first("COFF", "red").empty());
}

}  // namespace
}  // namespace kerf
