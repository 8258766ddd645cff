#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/command_labels.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

constexpr FileFrame kInchZ{FileUnit::kInch, UpAxis::kZ};
const World::Bounds kPart{{-30, -20, -5}, {40, 20, 15}};  // no plane that it stands on

SceneDescription scene_of(const char* mesh) {
  SceneDescription scene;
  scene.bodies.push_back(body_of_file(mesh));
  return scene;
}

TEST(FileFrames, are_guessed_for_a_mesh_file_and_confirmed_once_per_format) {
  Settings settings;
  const FrameChoice first = select_frame(scene_of("part.STL"), true, kPart, settings);
  EXPECT_EQ(first.frame, (FileFrame{FileUnit::kMillimetre, UpAxis::kZ}));
  EXPECT_TRUE(first.ask);

  settings.frames["stl"] = std::nullopt;
  const FrameChoice again = select_frame(scene_of("part.stl"), true, kPart, settings);
  EXPECT_EQ(again.frame, first.frame);
  EXPECT_FALSE(again.ask);

  settings.frames["stl"] = kInchZ;
  EXPECT_EQ(select_frame(scene_of("part.stl"), true, kPart, settings).frame, kInchZ);
  EXPECT_TRUE(select_frame(scene_of("part.obj"), true, kPart, settings).ask);

  const World::Bounds small{{-1, 0, -1}, {1, 1, 1}};
  EXPECT_TRUE(select_frame(scene_of("part.obj"), true, small, settings).ask);
  EXPECT_FALSE(select_frame(scene_of("part.glb"), true, small, settings).ask) << "glTF states metres";
  EXPECT_TRUE(select_frame(scene_of("part.glb"), true, kPart, settings).ask) << "it would be a lorry";
}

TEST(FileFrames, of_scenes_default_to_metres_and_y_up) {
  SceneDescription scene = scene_of("part.stl");
  const FrameChoice plain = select_frame(scene, false, kPart, {});
  EXPECT_TRUE(plain.frame.is_default());
  EXPECT_FALSE(plain.ask);
  record_frame(scene, kInchZ);
  EXPECT_EQ(select_frame(scene, false, kPart, {}).frame, kInchZ);
  record_frame(scene, {});
  EXPECT_TRUE(select_frame(scene, false, kPart, {}).frame.is_default());
}

TEST(FileFrames, rotating_lights_and_camera_back_is_exact) {
  ViewState view;
  view.camera.look({1, 2, 8}, {0, 0, 0});
  view.camera.finish();
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  const Vec3 light = view.look.lights[0].at, eye = view.seen().eye;
  show_in_frame(view, kInchZ);
  EXPECT_EQ(height_of(view.look.lights[0].at, UpAxis::kZ), light.y);
  EXPECT_NEAR(view.seen().eye.z, eye.y, 1e-12);
  show_in_frame(view, {});
  EXPECT_EQ(view.look.lights[0].at, light);
  EXPECT_EQ(view.seen().eye, eye);
}

TEST(FileFrames, lengths_use_the_unit_of_the_file) {
  EXPECT_EQ(length_label(12, FileUnit::kMillimetre), "12 mm");
  EXPECT_EQ(length_label(0.5, FileUnit::kMillimetre), "500 \xc2\xb5m");
  EXPECT_EQ(length_label(150, FileUnit::kCentimetre), "1.5 m");
  EXPECT_EQ(length_label(0.25, FileUnit::kInch), "0.25 in");
  EXPECT_EQ(length_label(0.25, FileUnit::kMetre), length_text(0.25));
  EXPECT_EQ(area_label(100, FileUnit::kCentimetre), area_label(0.01, FileUnit::kMetre));
}

}  // namespace
}  // namespace kerf
