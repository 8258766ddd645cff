#include "ui/render/picture.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <utility>

#include "core/document/commands.h"
#include "core/document/journal.h"
#include "core/document/stroke_path.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"
#include "ui/gl/image.h"

namespace kerf {
namespace {

struct Pixel {
  int r = 0, g = 0, b = 0;
};
int difference(Pixel a, Pixel b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b); }

struct Image : Pixels {
  Pixel at(int x, int y) const {
    const auto i = static_cast<size_t>(3 * (y * width + x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
  // Of the picture's size: 0 left or above, 1 right or below.
  Pixel at_part(double x, double y) const {
    return at(static_cast<int>(x * (width - 1)), static_cast<int>(y * (height - 1)));
  }
};

constexpr int kPictureWidth = 480, kPictureHeight = 320;

Scene scene_of(const Soup& soup) {
  Scene scene;
  scene.world.add(make_body("made", test::build(soup)));
  return scene;
}

Image render(Scene scene, PictureOptions options = {}, Journal journal = {}) {
  options.width = kPictureWidth;
  options.height = kPictureHeight;
  const auto file =
      std::filesystem::temp_directory_path() / ("kerf_picture_" + std::to_string(getpid()) + ".png");
  const Status drawn = render_picture({std::move(scene), std::move(journal)}, options, file);
  EXPECT_TRUE(drawn.ok()) << (drawn.ok() ? "" : drawn.error().message);
  const Image image{read_png(file).value_or(Pixels{})};
  std::filesystem::remove(file);
  EXPECT_EQ(image.width, kPictureWidth);
  EXPECT_EQ(image.height, kPictureHeight);
  return image;
}

// From the front, with the sky behind the middle of the picture.
PictureOptions from_the_front() {
  PictureOptions options;
  options.eye = Vec3(0, -0.8, 6);
  options.target = Vec3(0, 0, 0);
  return options;
}

StrokePath stroke_at_the_middle(double radius) {
  StrokePath stroke;
  stroke.radius = radius;
  stroke.keys = {{{0, -0.8, 6}, glm::normalize(Vec3(0, 0.8, -6))}};
  stroke.times = {0};
  return stroke;
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
  return sum / static_cast<double>(a.rgb.size());
}

size_t changed_pixels(const Image& a, const Image& b) {
  size_t changed = 0;
  for (int y = 0; y < kPictureHeight; ++y) {
    for (int x = 0; x < kPictureWidth; ++x) changed += difference(a.at(x, y), b.at(x, y)) > 24;
  }
  return changed;
}

TEST(Picture, shows_the_object_in_the_centre_and_not_at_the_border) {
  const Image image = render(scene_of(test::sphere(24, 32, 1)), from_the_front());
  const Pixel sky = image.at_part(0.02, 0.5);
  EXPECT_GT(difference(image.at_part(0.5, 0.5), sky), 40);
  EXPECT_LT(difference(image.at_part(0.98, 0.5), sky), 12);
}

TEST(Picture, a_hole_shows_the_background) {
  Scene scene = scene_of(test::sphere(24, 32, 1));
  scene.strokes = {stroke_at_the_middle(0.3)};
  const Image image = render(std::move(scene), from_the_front());
  EXPECT_LT(difference(image.at_part(0.5, 0.5), image.at_part(0.02, 0.5)), 20);  // the rim glows into it
}

TEST(Picture, shows_no_beam_of_a_stroke_that_was_undone_after_a_while) {
  const Scene scene = scene_of(test::sphere(24, 32, 1));
  Journal journal;
  journal.commands = scene_stroke_commands(stroke_at_the_middle(0.1), 2);
  journal.commands.emplace_back(AdvanceTime{10});
  journal.commands.emplace_back(Undo{});
  PictureOptions options = from_the_front();
  options.beam = true;
  EXPECT_LT(mean_difference(render(scene, options), render(scene, options, std::move(journal))), 1);
}

TEST(Picture, the_rim_of_a_cut_is_brighter_and_warmer_than_paint) {
  const auto warmest = [](const Image& image) {
    int most = -255;
    for (int y = 0; y < kPictureHeight; ++y) {
      for (int x = 0; x < kPictureWidth; ++x) most = std::max(most, image.at(x, y).r - image.at(x, y).b);
    }
    return most;
  };
  Scene scene = scene_of(test::sphere(24, 32, 1));
  const Image whole = render(scene, from_the_front());
  scene.strokes = {stroke_at_the_middle(0.1)};
  const Image cut = render(std::move(scene), from_the_front());
  EXPECT_LT(warmest(whole), 30);
  EXPECT_GT(warmest(cut), 100);
}

TEST(Picture, needs_an_eye_that_is_not_the_target) {
  Scene scene = scene_of(test::sphere(8, 12, 1));
  scene.view = View{{0, 0, 6}, {1, 0, 0}};
  PictureOptions at_the_eye;
  at_the_eye.target = scene.view->eye;
  const auto drawn = draw_picture({std::move(scene), {}}, at_the_eye);
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().code, ErrorCode::kBadInput);
}

TEST(Picture, frames_the_meshes_that_a_journal_adds_unless_the_scene_has_a_view) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Placement far{{30, 0, 0}, {1, 0, 0, 0}};
  Journal journal;
  journal.commands = {AddMesh{folder / "far.obj", "far"}, MovePiece{{{1, 1}, 0}, far}};
  Scene scene = scene_of(test::sphere(8, 12, 1));
  const auto draw = [&](const Journal& added) {
    const RenderedImage drawn = *draw_picture({scene, added}, {});
    return std::pair(drawn.renderer->view(), drawn.document->world().bounds());
  };
  const auto [view, bounds] = draw(journal);
  EXPECT_EQ(bounds.max.x, 31);
  for (const Vec3& end : {bounds.min, bounds.max}) {
    const Vec3 seen = view.project(end);
    EXPECT_TRUE(seen.z > 0 && std::abs(seen.x) < 1 && std::abs(seen.y) < 1) << seen.x << ' ' << seen.y;
  }
  scene.view = View{{0, 0, 6}, {0, 0, 0}};
  EXPECT_EQ(draw(journal).first, draw({}).first);
}

TEST(Picture, every_overlay_is_visible) {
  Scene scene =
      scene_of(test::both(test::sphere(24, 32, 1), test::moved(test::sphere(8, 12, 0.3), {0, 1.6, 0}, 1)));
  scene.strokes = {stroke_at_the_middle(0.1)};
  const Image plain = render(scene, from_the_front());
  for (const char* name : {"aabb", "aabb-hit", "wire", "face-numbers", "pieces", "normals"}) {
    PictureOptions options = from_the_front();
    options.show = *parse_show_list(name);
    EXPECT_GT(changed_pixels(plain, render(scene, options)), 300u) << name;
  }
}

TEST(Picture, is_deterministic_and_similar_without_anti_aliasing) {
  const Scene scene = scene_of(test::torus(24, 32, 1, 0.3));
  const Image first = render(scene);
  EXPECT_EQ(first.rgb, render(scene).rgb);
  PictureOptions rough;
  rough.antialias = false;
  EXPECT_LT(mean_difference(first, render(scene, rough)), 2);
}

TEST(Picture, does_not_depend_on_the_world_size) {
  const Soup torus = test::torus(24, 32, 1, 0.3);
  const Image one = render(scene_of(torus));
  for (const double size : {1e-6, 1e6}) {
    EXPECT_LT(mean_difference(one, render(scene_of(test::moved(torus, {0, 0, 0}, size)))), 1.5) << size;
  }
  render(scene_of(test::moved(torus, {0, 0, 0}, 1e39)));
}

TEST(Picture, is_the_same_far_from_the_origin) {
  const Soup torus = test::torus(24, 32, 1, 0.3);
  const Image here = render(scene_of(torus));
  const Image far = render(scene_of(test::moved(torus, {1048576, 0, -1048576}, 1)));
  EXPECT_LT(mean_difference(here, far), 2);
}

TEST(Picture, a_flat_plate_visibly_rests_on_the_ground) {
  const Image image = render(scene_of(test::plate(1)));
  // The plate's colour all over its middle, no speckles of ground.
  const Pixel middle = image.at_part(0.5, 0.5);
  for (int dx = -20; dx <= 20; dx += 4)
    EXPECT_LT(difference(image.at(kPictureWidth / 2 + dx, kPictureHeight / 2), middle), 30);
}

TEST(Picture, a_size_out_of_range_is_an_error) {
  PictureOptions options;
  options.width = 0;
  const Status drawn = render_picture({scene_of(test::plate(1)), {}}, options, "/dev/null");
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().code, ErrorCode::kBadInput);
}

}  // namespace
}  // namespace kerf
