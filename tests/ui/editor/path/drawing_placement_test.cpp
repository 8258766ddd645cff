#include "ui/editor/path/drawing_placement.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <algorithm>

#include "core/base/random.h"
#include "core/document/extract.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/path/drawing_preview.h"
#include "ui/editor/path/uncut_lines.h"
#include "ui/window/layout.h"

namespace kerf {
namespace {

World world_with(const Soup& soup) {
  World world;
  world.add(make_body("body", test::build(soup)));
  return world;
}

const std::vector<DrawnLine> kSquare{{{{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, true, ""}};
const Vec2 kMiddle(0.1, 0.05);
constexpr double kExtent = 0.22360679774997896;

DrawingPlacement placed(DrawingMode mode, const CameraView& view, const Vec3& at) {
  DrawingPlacement placement;
  placement.mode = mode;
  placement.view = view;
  placement.anchor = {at, {0, 1, 0}};
  return placement;
}

// Cuts along the lines with a knife and returns the areas of the pieces, ascending.
std::vector<double> areas_after_cut(World& world, const DrawingPlacement& placement) {
  const JobPlane start = placement.start(world.bounds(), placement.scale * kExtent);
  const std::vector<BodyId> ids = world.ids();
  for (const StrokePath& stroke : drawing_strokes(kSquare, kMiddle, start))
    EXPECT_TRUE(cut_with_path(world, {stroke.keys, {0, 100}}, ids).ok());
  std::vector<double> areas;
  const Body& body = world.body(ids.front());
  for (const auto& faces : faces_by_piece(body, false)) areas.push_back(extract_faces(body, faces).area);
  std::sort(areas.begin(), areas.end());
  return areas;
}

TEST(DrawingPlacement, along_an_orthographic_view_a_square_has_its_area_over_the_cosine_of_the_slope) {
  Random random(21);
  for (int run = 0; run < 20; ++run) {
    const Vec3 eye(random.uniform(-3, 3), random.uniform(2, 4), random.uniform(-3, 3));
    const CameraView view = look_at(eye, {0, 0, 0}, 1.4).pulled(CameraView::kFarAway);
    World world = world_with(test::grid(7, 2));
    DrawingPlacement placement = placed(DrawingMode::kView, view, {0.1, 0, 0.05});
    placement.turn = random.uniform(-3, 3);
    placement.scale = random.uniform(0.5, 2);
    const double expected = 0.02 * placement.scale * placement.scale / std::abs(view.forward.y);
    const std::vector<double> areas = areas_after_cut(world, placement);
    ASSERT_EQ(areas.size(), 2u) << "seed 21, case " << run;
    EXPECT_NEAR(areas[0], expected, 1e-12) << "seed 21, case " << run;
  }
}

TEST(DrawingPlacement, along_a_perspective_view_lines_on_the_surface_look_as_on_the_screen) {
  const CameraView view = look_at({1, 2, 3}, {0, 0, 0}, 1.4);
  World world = world_with(test::sphere(40, 60, 1));
  const Vec3 at = glm::normalize(Vec3(1, 2, 3));
  const DrawingPlacement placement = placed(DrawingMode::kView, view, at);
  const std::vector<ProjectedLine> lines = project_lines(kSquare, kMiddle, kExtent, placement, world);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].on_surface);
  EXPECT_GT(lines[0].points.size(), 256u);
  const double radius = 0.99;  // of the sphere inside the faces
  Vec2 low(1e9), high(-1e9);
  for (const Vec3& p : lines[0].points) {
    EXPECT_GT(glm::length(p), radius);
    EXPECT_LE(glm::length(p), 1 + 1e-12);
    const Vec2 seen(view.project(p));
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  }
  const double half_height = glm::dot(at - view.eye, view.forward) * view.tan_half_fov;
  EXPECT_NEAR((high.x - low.x) * view.aspect, 0.2 / half_height, 1e-12);
  EXPECT_NEAR(high.y - low.y, 0.1 / half_height, 1e-12);
}

TEST(DrawingPlacement, rays_through_a_point_of_the_plane_or_cylinder_find_it) {
  Random random(22);
  const Bounds bounds{{-1, -1, -1}, {1, 1, 1}};
  for (const DrawingMode mode :
       {DrawingMode::kPlane, DrawingMode::kAxis, DrawingMode::kView, DrawingMode::kWrap}) {
    for (int run = 0; run < 50; ++run) {
      const Vec3 eye(random.uniform(-2, 2), random.uniform(1, 2), random.uniform(3, 4));
      DrawingPlacement placement = placed(mode, look_at(eye, {0, 0, 0}, 1.4), {0, 0.1, 0.9});
      placement.anchor.normal = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 2));
      placement.turn = random.uniform(-3, 3);
      placement.scale = random.uniform(0.5, 2);
      const JobPlane plane = placement.plane(bounds);
      EXPECT_LT(glm::length(glm::cross(plane.right, plane.up) + plane.beam), 1e-12);
      const Vec2 p(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
      const Vec3 on = point_on(plane, p);
      const auto found = drawing_point(plane, {eye, glm::normalize(on - eye)});
      ASSERT_TRUE(found) << "seed 22, case " << run;
      EXPECT_LT(glm::length(*found - p), 1e-12) << "seed 22, case " << run;
    }
  }
}

TEST(DrawingPlacement, the_anchor_lies_on_the_cylinder_unless_its_radius_is_set) {
  const Bounds bounds{{-1, -2, -1}, {1, 2, 1}};
  DrawingPlacement placement = placed(DrawingMode::kWrap, look_at({0, 0, 5}, {0, 0, 0}, 1), {0.3, 0.5, 0.4});
  EXPECT_NEAR(placement.plane(bounds).wrap, 0.5, 1e-15);
  EXPECT_LT(glm::length(point_on(placement.plane(bounds), Vec2(0)) - Vec3(0.3, 0.5, 0.4)), 1e-15);
  placement.radius = 0.25;
  EXPECT_LT(glm::length(point_on(placement.plane(bounds), Vec2(0)) - Vec3(0.15, 0.5, 0.2)), 1e-15);
  // A quarter of the circumference round the axis.
  const Vec3 aside = point_on(placement.plane(bounds), Vec2(0.25 * 1.5707963267948966, 0));
  EXPECT_NEAR(glm::dot(aside, Vec3(0.15, 0, 0.2)), 0, 1e-15);
}

TEST(DrawingPlacement, lines_break_where_the_surface_does) {
  World world;
  world.add(make_body("low", test::build(test::grid(3, 2))));
  Body high = make_body("high", test::build(test::grid(3, 2)));
  high.placement.position = {1, 0.3, 0};  // covers x > 0
  world.add(std::move(high));
  const std::vector<DrawnLine> line{{{{-1.5, 0}, {0.5, 0}}, false, ""}};
  DrawingPlacement placement = placed(DrawingMode::kAxis, look_at({0, 5, 1}, {0, 0, 0}, 1), {0, 0, 0});
  const std::vector<ProjectedLine> parts = project_lines(line, {0, 0}, 2, placement, world);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_FALSE(parts[0].on_surface);  // x < -1
  EXPECT_TRUE(parts[1].on_surface && parts[2].on_surface);
  for (const Vec3& p : parts[1].points) EXPECT_NEAR(p.y, 0, 1e-15);
  for (const Vec3& p : parts[2].points) EXPECT_NEAR(p.y, 0.3, 1e-15);
  EXPECT_NEAR(parts[1].points.front().x, -1, 0.01);
  EXPECT_NEAR(parts[2].points.front().x, 0, 0.01);
}

TEST(DrawingPreview, a_line_that_begins_behind_the_eye_is_as_wide_as_the_beam) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().DisplaySize = {1000, 700};
  ImGui::GetIO().Fonts->Build();
  ImGui::NewFrame();
  const World world = world_with(test::grid(7, 2));
  ViewState view;
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  view.camera.look({0, 0.3, 0}, {1, 0, 0});
  view.camera.finish();
  const PrimaryViewport picture(view);
  std::vector<Vec2> corners{{-0.4, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}};
  for (int first = 0; first < 4; ++first) {
    ImportedDrawing drawing;
    drawing.job.drawing.lines = {{corners, true, ""}};
    drawing.box = {{-0.4, -0.4}, {0.4, 0.4}};
    DrawingPreview preview;
    preview.update(drawing, placed(DrawingMode::kPlane, picture.camera(), Vec3(0)), world, picture);
    const auto vertices = [&](double radius) {
      ImDrawList& list = *ImGui::GetBackgroundDrawList();
      const int before = list.VtxBuffer.Size;
      preview.draw(drawing, {}, radius, picture, list);
      return list.VtxBuffer.Size - before;
    };
    EXPECT_GT(vertices(0.02), vertices(0)) << "from corner " << first;
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  ImGui::EndFrame();
  ImGui::DestroyContext();
}

TEST(DrawingPlacement, the_beam_of_a_plane_starts_near_its_surface_and_that_of_an_axis_outside_everything) {
  World world;
  world.add(make_body("floor", test::build(test::grid(3, 2))));
  Body roof = make_body("roof", test::build(test::grid(3, 2)));
  roof.placement.position = {0, 1, 0};
  world.add(std::move(roof));
  for (const DrawingMode mode : {DrawingMode::kPlane, DrawingMode::kAxis}) {
    const DrawingPlacement placement = placed(mode, look_at({0, 5, 1}, {0, 0, 0}, 1), {0, 0, 0});
    const double expected = mode == DrawingMode::kPlane ? 0 : 1;
    for (const ProjectedLine& line : project_lines(kSquare, kMiddle, kExtent, placement, world)) {
      for (const Vec3& p : line.points) EXPECT_NEAR(p.y, expected, 1e-15);
    }
  }
}

// Two parallel sheets, of which the beam meets the roof first.
World roof_over_floor() {
  World world;
  world.add(make_body("floor", test::build(test::grid(3, 2))));
  Body roof = make_body("roof", test::build(test::grid(3, 2)));
  roof.placement.position = {0, 0.05, 0};
  world.add(std::move(roof));
  return world;
}

TEST(DrawingPlacement, the_beam_of_a_closed_line_ends_behind_the_first_surface) {
  const World world = roof_over_floor();
  const CameraView view = look_at({0, 5, 1}, {0, 0, 0}, 1);
  for (const DrawingPlacement& placement :
       {placed(DrawingMode::kPlane, view, {0, 0.05, 0}), placed(DrawingMode::kAxis, view, {0, 0.05, 0}),
        placed(DrawingMode::kView, view, {0, 0.05, 0}),
        placed(DrawingMode::kView, view.pulled(CameraView::kFarAway), {0, 0.05, 0})}) {
    std::vector<StrokePath> strokes =
        drawing_strokes(kSquare, kMiddle, placement.start(world.bounds(), kExtent));
    end_behind_surface(kSquare, kMiddle, kExtent, placement, world, strokes);
    ASSERT_TRUE(strokes[0].range.has_value());
    for (const Pose& key : strokes[0].keys) {
      const Vec3 end = key.origin + strokes[0].range->high * key.direction;
      EXPECT_LT(end.y, 0.05) << "mode " << static_cast<int>(placement.mode);
      EXPECT_GT(end.y, 0) << "mode " << static_cast<int>(placement.mode);
    }
  }
}

TEST(DrawingPlacement, a_beam_round_a_cylinder_ends_behind_the_first_surface) {
  World world = world_with(test::sphere(40, 60, 1));
  world.add(make_body("inner", test::build(test::sphere(40, 60, 0.9))));
  const DrawingPlacement placement = placed(DrawingMode::kWrap, look_at({0, 0, 5}, {0, 0, 0}, 1), {0, 0, 1});
  std::vector<StrokePath> strokes =
      drawing_strokes(kSquare, kMiddle, placement.start(world.bounds(), kExtent));
  end_behind_surface(kSquare, kMiddle, kExtent, placement, world, strokes);
  ASSERT_TRUE(strokes[0].range.has_value());
  for (const Pose& key : strokes[0].keys) {
    const double start = glm::length(Vec2(key.origin.x, key.origin.z)), end = start - strokes[0].range->high;
    EXPECT_LT(end, 1);
    EXPECT_GT(end, 0.9);
  }
}

TEST(DrawingPlacement, the_downward_beam_is_opposite_to_the_up_axis) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    DrawingPlacement placement;
    placement.mode = DrawingMode::kAxis;
    placement.beam = downward_beam(up);
    EXPECT_EQ(placement.plane({Vec3(-1), Vec3(1)}).beam, from_y_up({0, -1, 0}, up));
  }
}

TEST(DrawingLayers, have_the_radius_and_the_speed_of_the_panel_unless_they_have_their_own) {
  ImportedDrawing drawing;
  drawing.layers = {{"a", 1}, {"b", 2}, {"c", 1}};
  LayerTable layers;
  layers.layers["a"].radius = 0.002;
  layers.layers["b"].radius = 0.0001;
  layers.layers["b"].skip = true;
  layers.layers["c"].speed = 3;
  EXPECT_EQ(smallest_radius(drawing, layers, 0.01), 0.002);
  EXPECT_EQ(smallest_radius(drawing, layers, 0.001), 0.001);
  EXPECT_EQ(smallest_radius(drawing, LayerTable(), 0.01), 0.01);
  layers.layers["b"].skip = false;
  EXPECT_EQ(smallest_radius(drawing, layers, 0.01), 0.0001);
  const LayerTable timed = with_speed(drawing, layers, 20);
  EXPECT_EQ(timed.layers.at("a").speed, 20.0);
  EXPECT_EQ(timed.layers.at("b").speed, 20.0);
  EXPECT_EQ(timed.layers.at("c").speed, 3.0);
  EXPECT_EQ(timed.layers.at("a").radius, 0.002);
}

TEST(UncutLines, are_the_parts_where_the_axis_of_the_beam_meets_a_face) {
  const World world = world_with(test::grid(3, 2));  // -1 <= x <= 1
  const auto stroke = [](double from, double middle, double to) {
    StrokePath path;
    for (const double x : {from, middle, to}) path.keys.push_back({{x, 2, 0.1}, {0, -1, 0}});
    path.times = {0, 1, 4};
    return path;
  };
  const std::vector<StrokePath> strokes{stroke(-3, -2, -1.1), stroke(-2, 0, 3), stroke(-0.5, 0, 0.5)};
  const std::vector<UncutLine> uncut = uncut_lines(strokes, {0, 5}, world);
  ASSERT_EQ(uncut.size(), 2u);
  EXPECT_EQ(uncut[0].stroke, 1u);
  EXPECT_NEAR(uncut[0].share, (0.5 * 1 + 3.0 / 9 * 3) / 4, 0.03);
  EXPECT_NEAR(uncut[1].share, 1, 1e-12);
  for (const UncutLine& line : uncut) {
    for (const auto& part : line.parts) {
      for (const Vec3& p : part) EXPECT_TRUE(std::abs(p.y) < 1e-12 && std::abs(p.x) <= 1);
    }
  }
  EXPECT_TRUE(uncut_lines(strokes, {0, 1.5}, world).empty()) << "the beam ends before the sheet";
}

TEST(UncutLines, end_where_the_own_range_of_a_stroke_ends) {
  const World world = world_with(test::grid(8, 4));
  StrokePath stroke;
  stroke.keys = {{{0.5, 2, 0.5}, {0, -1, 0}}, {{1, 2, 0.5}, {0, -1, 0}}};
  stroke.times = {0, 1};
  EXPECT_EQ(uncut_lines(std::span(&stroke, 1), {0, 5}, world).size(), 1u);
  stroke.range = Interval{0, 1.5};  // as the drawing tool with Depth "First Surface"
  EXPECT_TRUE(uncut_lines(std::span(&stroke, 1), {0, 5}, world).empty());
  stroke.range = Interval{0, 5};
  EXPECT_EQ(uncut_lines(std::span(&stroke, 1), {0, 1.5}, world).size(), 1u);
  stroke.radius = 0;
  EXPECT_TRUE(uncut_lines(std::span(&stroke, 1), {0, 5}, world).empty()) << "a knife";
}

TEST(UncutMarks, last_until_the_next_stroke) {
  Workspace workspace;
  Document& document = workspace.session.document;
  document = Document(world_with(test::grid(8, 4)));
  workspace.laser.model = Model::kThermal;
  std::vector<StrokePath> strokes(1);
  strokes[0].keys = {{{0.5, 2, 0.5}, {0, -1, 0}}, {{1, 2, 0.5}, {0, -1, 0}}};
  strokes[0].times = {0, 1};
  const auto begin_stroke = [&] { document.apply(BeginStroke{CutSettings(), {{9, 2, 9}, {0, -1, 0}}}); };
  UncutMarks marks;
  marks.begin(workspace, strokes);
  begin_stroke();  // a beam that leaves the sheet as it is
  document.apply(EndStroke{});
  while (document.waiting() > 0) ASSERT_TRUE(document.step(8).ok());
  marks.update(workspace);
  marks.update(workspace);
  EXPECT_EQ(marks.size(), 1u);
  begin_stroke();
  marks.update(workspace);
  EXPECT_EQ(marks.size(), 0u);
}

TEST(DrawingPlacement, long_drawings_have_a_bounded_number_of_points) {
  std::vector<DrawnLine> lines;
  for (int i = 0; i < 500; ++i) lines.push_back({{{0, 0.0001 * i}, {0.2, 0.0001 * i}}, false, ""});
  const DrawingPlacement placement = placed(DrawingMode::kAxis, look_at({0, 5, 1}, {0, 0, 0}, 1), {0, 0, 0});
  size_t points = 0;
  for (const ProjectedLine& line :
       project_lines(lines, kMiddle, kExtent, placement, world_with(test::grid(3, 2))))
    points += line.points.size();
  EXPECT_LE(points, kMaxProjected);
}

}  // namespace
}  // namespace kerf
