#include "ui/editor/laser/material_rows.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "core/edit/body_edit.h"
#include "tests/support/gui_context.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/window/layout.h"
#include "ui/window/widgets.h"

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
  SheetEdit typed{.after = first, .thickness = true};
  typed.after.thickness = 0.002;
  Sheet expected = own;
  expected.thickness = 0.002;
  EXPECT_EQ(typed.applied_to(own), expected);
  EXPECT_EQ(typed.applied_to(first), typed.after);
  typed = {.after = first, .constants = {&Substance::density}};
  typed.after.density = typed.after.substance.density = 8000;
  expected = own;
  expected.density = expected.substance.density = 8000;
  EXPECT_EQ(typed.applied_to(own), expected);
  const Sheet selected = SheetEdit{.after = steel, .preset = true}.applied_to(own);
  EXPECT_EQ(selected.substance, steel.substance);
  EXPECT_EQ(selected.density, steel.density);
  EXPECT_EQ(selected.thickness, own.thickness);
}

// The Material panel, of which no pixel is drawn, and two sheets of 1 mm and 2 mm.
class MaterialEntries : public testing::Test {
 protected:
  MaterialEntries() {
    keep_landmarks(&landmarks);
    World world;
    for (const double thickness : {0.001, 0.002}) {
      const BodyId id = world.add(make_body("plate", build(plate(1))));
      world.body(id).sheet.thickness = thickness;
      pieces.push_back({id, 0});
    }
    workspace.session.document = Document(std::move(world));
    for (int i = 0; i < 3; ++i) frame();
  }
  ~MaterialEntries() override { keep_landmarks(nullptr); }

  MaterialChange frame() {
    landmarks.begin_frame();
    MaterialChange change;
    gui.frame([&] { change = panel.draw(workspace); });
    return change;
  }
  MaterialChange press(Vec2 at) {
    ImGui::GetIO().MousePos = to_im(at);
    ImGui::GetIO().MouseDown[0] = true;
    return frame();
  }
  void type_thickness(const char* text) {
    const auto field = landmarks.find("Thickness");
    ASSERT_TRUE(field);
    const Vec2 middle = field->at + 0.5 * field->size;
    ImGui::GetIO().MousePos = to_im(middle);
    frame();
    press(middle);
    ImGui::GetIO().MouseDown[0] = false;
    frame();
    ImGui::GetIO().AddInputCharactersUTF8(text);
    EXPECT_FALSE(frame().sheet);
  }

  test::GuiContext gui;
  Landmarks landmarks{std::nullopt};
  Workspace workspace;
  std::vector<PieceId> pieces;
  MaterialPanel panel;
};

TEST_F(MaterialEntries, belong_to_the_pieces_that_were_selected_when_a_click_selects_another) {
  select_piece(workspace.view.look.pieces, pieces[0], false);
  frame();
  type_thickness("3");
  select_piece(workspace.view.look.pieces, pieces[1], false);
  const MaterialChange change = press({390, 290});
  ASSERT_TRUE(change.sheet);
  EXPECT_EQ(change.pieces, std::vector{pieces[0]});
  EXPECT_DOUBLE_EQ(change.sheet->after.thickness, 0.003);
}

TEST_F(MaterialEntries, of_the_number_of_the_first_piece_change_the_other_pieces) {
  for (const PieceId& piece : pieces) select_piece(workspace.view.look.pieces, piece, true);
  frame();
  type_thickness("1");
  const MaterialChange change = press({390, 290});
  ASSERT_TRUE(change.sheet);
  EXPECT_EQ(change.pieces, pieces);
  EXPECT_EQ(change.sheet->applied_to(workspace.world().body(pieces[1].body).sheet).thickness, 0.001);
}

TEST_F(MaterialEntries, of_no_thickness_are_refused) {
  type_thickness("0");
  EXPECT_FALSE(press({390, 290}).sheet);
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
