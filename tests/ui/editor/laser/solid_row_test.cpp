#include "ui/editor/laser/material_rows.h"

#include <gtest/gtest.h>

#include "core/edit/body_edit.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(SolidRow, reports_why_a_piece_is_not_a_solid) {
  LaserControls laser;
  EXPECT_EQ(solid_disabled_reason(true, laser), nullptr);
  EXPECT_NE(std::string(solid_disabled_reason(false, laser)).find("boundary edges"), std::string::npos);
  LaserControls thermal = laser, rays = laser, faces = laser;
  thermal.model = Model::kThermal;
  rays.pattern = Pattern::kRays4;
  faces.resolution.rim = Rim::kFaces;
  EXPECT_NE(std::string(solid_disabled_reason(true, thermal)).find("Geometric"), std::string::npos);
  EXPECT_NE(std::string(solid_disabled_reason(true, rays)).find("Volume"), std::string::npos);
  EXPECT_NE(std::string(solid_disabled_reason(true, faces)).find("smooth rim"), std::string::npos);
}

TEST(SheetEdit, changes_only_the_edited_members_of_other_sheets) {
  Sheet first, steel, own;
  steel.substance.conductivity = 16;
  own.thickness = 0.005;
  own.density = own.substance.density = 2700;
  own.substance.latent = 390e3;
  SheetEdit typed{first, first};
  typed.after.thickness = 0.002;
  Sheet expected = own;
  expected.thickness = 0.002;
  EXPECT_EQ(typed.applied_to(own), expected);
  EXPECT_EQ(typed.applied_to(first), typed.after);
  typed.after = first;
  typed.after.density = typed.after.substance.density = 8000;
  expected = own;
  expected.density = expected.substance.density = 8000;
  EXPECT_EQ(typed.applied_to(own), expected);
  const Sheet selected = SheetEdit{first, steel, true}.applied_to(own);
  EXPECT_EQ(selected.substance, steel.substance);
  EXPECT_EQ(selected.density, steel.density);
  EXPECT_EQ(selected.thickness, own.thickness);
}

TEST(KnownClosed, updates_with_the_faces_of_the_requested_piece) {
  World world = world_of(brick({1, 2, 3}));
  const BodyId open = world.add(make_body("plate", build(plate(1))));
  const BodyId box = world.ids().front();
  KnownClosed known;
  EXPECT_TRUE(known.of(world, {box, 0}));
  EXPECT_FALSE(known.of(world, {open, 0}));
  EXPECT_TRUE(known.of(world, {box, 0}));
  { BodyEdit(world.body(box)).remove(std::vector{FaceId(4)}); }
  EXPECT_FALSE(known.of(world, {box, 0}));
}

}  // namespace
}  // namespace kerf::test
