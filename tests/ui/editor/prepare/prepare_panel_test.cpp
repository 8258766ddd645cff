#include "ui/editor/prepare/prepare_panel.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/file_frames.h"

namespace kerf::test {
namespace {

using Tool = Preparation::Tool;

TEST(PreparePanel, shows_numbers_in_the_unit_of_the_file) {
  const std::vector<PieceRow> pieces{{.id = {}, .name = "bunny", .faces = 69'666}};
  EXPECT_EQ(forecast_text(pieces, {.faces = 7000}, FileUnit::kMetre), "69 666 faces become about 7 000.");
  EXPECT_EQ(
      forecast_text(pieces, {.tool = Tool::kSimplifyToError, .error = 0.25}, FileUnit::kMillimetre),
      "69 666 faces are simplified to a tolerance of " + length_label(0.25, FileUnit::kMillimetre) + ".");
  EXPECT_EQ(forecast_text(pieces, {.tool = Tool::kSubdivide}, FileUnit::kMetre),
            "69 666 faces become about 278 664.");
  EXPECT_EQ(forecast_text(pieces, {.tool = Tool::kSmooth}, FileUnit::kMetre), "69 666 faces move.");
}

TEST(PreparePanel, a_mesh_with_as_many_faces_is_not_simplified) {
  const std::vector<PieceRow> pieces{{.id = {}, .name = "bunny", .faces = 7000}};
  for (const size_t faces : {size_t{7000}, size_t{9000}}) {
    EXPECT_EQ(forecast_text(pieces, {.faces = faces}, FileUnit::kMetre), "The mesh has 7 000 faces already.");
    EXPECT_STREQ(prepare_disabled_reason(pieces, {.faces = faces}),
                 "The mesh already has no more faces than that.");
  }
}

TEST(PreparePanel, names_the_pieces_it_applies_to) {
  World world;
  const BodyId id = world.add(make_body("ball", build(sphere(6, 8, 1))));
  PieceMap looks;
  EXPECT_EQ(prepared_text(pieces_to_prepare(world, looks), looks), "All pieces");
  looks[{id, 0}].selected = true;
  EXPECT_EQ(prepared_text(pieces_to_prepare(world, looks), looks), "ball");
}

TEST(PreparePanel, defaults_to_half_the_faces_and_a_thousandth_of_the_size) {
  World world;
  world.add(make_body("plate", build(grid(10, 1))));
  const Preparation p = with_numbers({}, pieces_to_prepare(world, {}), world);
  EXPECT_EQ(p.faces, 100u);
  EXPECT_NEAR(p.error, std::sqrt(2.0) / 1000, 1e-6);
}

}  // namespace
}  // namespace kerf::test
