#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <algorithm>

#include "core/base/random.h"
#include "core/document/extract.h"
#include "core/mesh/measures.h"
#include "core/world/body_mass.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/laser/knife_line.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

double height(const KnifePlane& plane, const Vec3& p) { return glm::dot(plane.normal, p) - plane.distance; }

TEST(KnifeLine, plane_contains_all_points_seen_on_the_line_and_no_others) {
  Random random(4);
  for (const double pull : {1.0, CameraView::kFarAway}) {
    const CameraView view = look_at({1, 2, 5}, {0, 0.5, 0}, 1.5).pulled(pull);
    for (int i = 0; i < 50; ++i) {
      const auto place = [&] { return Vec2(random.uniform(-1, 1), random.uniform(-1, 1)); };
      const Vec2 from = place(), to = place();
      const KnifePlane plane = plane_through(view, from, to);
      EXPECT_NEAR(glm::length(plane.normal), 1, 1e-12);
      const Vec2 on = glm::mix(from, to, random.uniform(-1, 2));
      const Pose ray = view.ray(on.x, on.y);
      const double far = view.focus, slack = 1e-9 * far;
      EXPECT_NEAR(height(plane, ray.origin + far * ray.direction), 0, slack);
      const Vec2 aside = on + Vec2(from.y - to.y, to.x - from.x);
      const Pose other = view.ray(aside.x, aside.y);
      EXPECT_GT(std::abs(height(plane, other.origin + far * other.direction)), slack) << "seed 4, case " << i;
    }
  }
}

TEST(KnifeLine, crosses_only_visible_bodies_on_both_sides) {
  World world;
  const BodyId ball = world.add(make_body("ball", test::build(test::sphere(12, 16, 1))));
  EXPECT_TRUE(crosses(world, {{0, 1, 0}, 0.9}));
  EXPECT_FALSE(crosses(world, {{0, 1, 0}, 1.1}));
  world.body(ball).placement.position = {0, 0.5, 0};
  EXPECT_TRUE(crosses(world, {{0, 1, 0}, 1.1}));
  world.body(ball).hidden = true;
  EXPECT_FALSE(crosses(world, {{0, 1, 0}, 0.9}));
}

double distance_to(Vec2 p, const std::vector<Vec2>& curve, bool closed) {
  double least = INFINITY;
  for (size_t i = 0; i + (closed ? 0 : 1) < curve.size(); ++i) {
    const Vec2 from = curve[i], along = curve[(i + 1) % curve.size()] - from;
    const double share = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
    least = std::min(least, glm::length(p - from - share * along));
  }
  return least;
}

double signed_area(const std::vector<Vec2>& loop) {
  double twice = 0;
  for (size_t i = 0; i < loop.size(); ++i) twice += cross2(loop[i], loop[(i + 1) % loop.size()]);
  return 0.5 * twice;
}

bool crosses_itself(const std::vector<Vec2>& loop) {
  const size_t count = loop.size();
  for (size_t i = 0; i < count; ++i) {
    for (size_t k = i + 2; k < count; ++k) {
      if (i == 0 && k + 1 == count) continue;
      const Vec2 a = loop[i], b = loop[i + 1], c = loop[k], d = loop[(k + 1) % count];
      if (cross2(b - a, c - a) * cross2(b - a, d - a) < 0 && cross2(d - c, a - c) * cross2(d - c, b - c) < 0)
        return true;
    }
  }
  return false;
}

TEST(KnifeCurve, simplified_keeps_the_points_that_matter) {
  Random random(11);
  for (const bool closed : {false, true}) {
    std::vector<Vec2> drawn{Vec2(0)};
    for (int i = 1; i < 400; ++i)
      drawn.push_back(drawn.back() + Vec2(random.uniform(-3, 4), random.uniform(-3, 3)));
    const std::vector<Vec2> kept = simplified(drawn, 5, closed);
    EXPECT_LT(kept.size(), drawn.size() / 2);
    EXPECT_EQ(kept.front(), drawn.front());
    if (!closed) {
      EXPECT_EQ(kept.back(), drawn.back());
    }
    size_t at = 0;
    for (const Vec2& p : kept) {
      while (at < drawn.size() && drawn[at] != p) ++at;
      ASSERT_LT(at, drawn.size()) << "seed 11: not a point of the curve, or not in its order";
    }
    for (const Vec2& p : drawn) EXPECT_LE(distance_to(p, kept, closed), 5) << "seed 11";
  }
  const std::vector<Vec2> square{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}, {0, 5}};
  EXPECT_EQ(simplified(square, 0.1, true), (std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
}

TEST(KnifeCurve, the_largest_loop_does_not_cross_itself) {
  // A square whose ends cross near its start, as a hand draws it.
  const std::vector<Vec2> ends{{1, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 1}, {3, -2}};
  const std::vector<Vec2> trimmed = largest_loop(ends);
  EXPECT_FALSE(crosses_itself(trimmed));
  EXPECT_NEAR(std::abs(signed_area(trimmed)), 99.5, 1e-12);
  // An eight with loops of 2 x 2 and 4 x 4, halved.
  EXPECT_NEAR(std::abs(signed_area(largest_loop({{0, 0}, {2, 2}, {6, 6}, {6, -2}, {2, 2}, {0, 4}}))), 16,
              1e-12);
  EXPECT_TRUE(largest_loop({{0, 0}, {5, 0}, {9, 0}}).empty());
  EXPECT_TRUE(largest_loop({{0, 0}, {5, 5}}).empty());
  Random random(12);
  for (int run = 0; run < 200; ++run) {
    std::vector<Vec2> drawn;
    const bool whole = run % 2 == 0;  // places of the pointer, which may coincide or lie on one line
    for (int i = 0; i < 12; ++i) {
      const Vec2 p(random.uniform(0, 9), random.uniform(0, 9));
      drawn.push_back(whole ? glm::floor(p) : p);
    }
    const std::vector<Vec2> loop = largest_loop(drawn);
    EXPECT_FALSE(crosses_itself(loop)) << "seed 12, case " << run;
    EXPECT_TRUE(loop.empty() || std::abs(signed_area(loop)) > 0);
  }
}

TEST(KnifeCurve, a_point_is_refused_whose_segment_crosses_the_line) {
  const std::vector<Vec2> line{{0, 0}, {10, 0}, {10, 10}, {5, 10}};
  EXPECT_TRUE(would_cross(line, {5, -5}));
  EXPECT_TRUE(would_cross(line, {9, 10}));  // back along its last segment
  EXPECT_FALSE(would_cross(line, {5, 5}));
  EXPECT_FALSE(would_cross(line, {0, 10}));
}

// A star around the middle of the frame, which its rays see once.
std::vector<Vec2> random_star(Random& random, int corners, double size) {
  std::vector<Vec2> star;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * (i + random.uniform(0, 0.8)) / corners;
    star.push_back(size * random.uniform(0.4, 1) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return star;
}

std::vector<double> areas_of_pieces(const Body& body) {
  std::vector<double> areas;
  for (const auto& faces : faces_by_piece(body, false)) areas.push_back(extract_faces(body, faces).area);
  std::sort(areas.begin(), areas.end());
  return areas;
}

TEST(KnifeCurve, a_lasso_in_an_orthographic_view_cuts_its_own_area_out_of_a_plate) {
  Random random(13);
  for (int run = 0; run < 20; ++run) {
    World world;
    const BodyId id = world.add(make_body("plate", test::build(test::grid(9, 2))));
    const Vec3 eye(random.uniform(-3, 3), random.uniform(2, 4), random.uniform(-3, 3));
    const CameraView view = look_at(eye, {0, 0, 0}, 1.4).pulled(CameraView::kFarAway);
    const std::vector<Vec2> star = random_star(random, 3 + run, 0.4);
    const KnifePath path = path_along_view(view, star, true, world.bounds());
    const std::vector<BodyId> ids = world.ids();
    ASSERT_TRUE(cut_with_path(world, path, ids).ok());
    const double on_screen =
        std::abs(signed_area(star)) * view.half_height() * view.half_height() * view.aspect;
    const double expected = on_screen / std::abs(view.forward.y);
    const std::vector<double> areas = areas_of_pieces(world.body(id));
    ASSERT_EQ(areas.size(), 2u) << "seed 13, case " << run;
    EXPECT_NEAR(areas[0], expected, 1e-12) << "seed 13, case " << run;
    EXPECT_NEAR(areas[0] + areas[1], 4, 1e-12);
  }
}

TEST(KnifeCurve, a_lasso_in_a_perspective_view_cuts_a_frustum_out_of_a_solid) {
  World world;
  const BodyId id = world.add(make_body("brick", test::build(test::brick({2, 1, 2}))));
  make_solid(world.body(id), true);
  const Bounds bounds = world.bounds();
  const Vec3 middle = bounds.centre(), eye = middle + Vec3(0, 0, bounds.max.z - middle.z + 3);
  const CameraView view = look_at(eye, middle, 1);
  const double half = 0.2;
  const std::vector<Vec2> square{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  const std::vector<BodyId> ids = world.ids();
  const auto cut = cut_with_path(world, path_along_view(view, square, true, bounds), ids);
  ASSERT_TRUE(cut.ok());
  EXPECT_TRUE(cut->delta.left_open.empty());
  const double side = 2 * half * view.tan_half_fov, near = 3, far = 3 + (bounds.max.z - bounds.min.z);
  const double frustum = side * side * (far * far * far - near * near * near) / 3;
  std::vector<double> volumes;
  const Body& body = world.body(id);
  for (const auto& faces : faces_by_piece(body, false))
    volumes.push_back(enclosed_volume(body.mesh, faces, body.middle()).volume);
  std::sort(volumes.begin(), volumes.end());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], frustum, 1e-12);
}

TEST(KnifeFeature, cuts_at_the_section_plane_only_while_it_is_shown) {
  Workspace workspace;
  World world;
  world.add(make_body("ball", test::build(test::sphere(12, 16, 1))));
  workspace.session.document = Document(std::move(world));
  const auto knife = knife_feature(workspace);
  const std::vector<UserAction> actions = knife->actions();
  const UserAction* cut = find_action(actions, "section.cut");
  ASSERT_NE(cut, nullptr);
  EXPECT_NE(cut->objection(), nullptr);
  workspace.view.look.show.section = true;
  workspace.view.look.section = SectionPlane::facing({0, 5, 0}, {0, 1, 0});
  EXPECT_EQ(cut->objection(), nullptr);
  cut->run();
  EXPECT_FALSE(workspace.changes.has_requests());  // it crosses nothing
  workspace.view.look.section = SectionPlane::facing({0, 0.1, 0}, {0, 1, 0});
  cut->run();
  EXPECT_TRUE(workspace.changes.has_requests());
}

TEST(KnifeFeature, a_press_shows_the_pieces_where_they_are_cut) {
  for (const char* shape : {"knife.line", "knife.lasso", "knife.polyline"}) {
    Workspace workspace;
    World world;
    world.add(make_body("ball", test::build(test::sphere(12, 16, 1))));
    workspace.session.document = Document(std::move(world));
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    const auto knife = knife_feature(workspace);
    const std::vector<UserAction> actions = knife->actions();
    find_action(actions, shape)->run();
    workspace.view.spread = 1;
    workspace.view.picture_old = false;
    workspace.input.pointer = {500, 350};
    (void)knife->begin_interaction({{InputEvent::Kind::kPress, workspace.input.pointer}});
    EXPECT_EQ(workspace.view.spread, 0) << shape;
    EXPECT_TRUE(workspace.view.picture_old) << shape;
  }
}

TEST(KnifeFeature, a_double_click_ends_a_polyline_also_some_time_after_its_last_point) {
  Workspace workspace;
  World world;
  world.add(make_body("ball", test::build(test::sphere(12, 16, 1))));
  workspace.session.document = Document(std::move(world));
  workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
  const auto knife = knife_feature(workspace);
  const std::vector<UserAction> actions = knife->actions();
  find_action(actions, "knife.polyline")->run();
  const auto click = [&](double x, double seconds) {
    workspace.input.pointer = {x, 350};
    InputEvent press{InputEvent::Kind::kPress, workspace.input.pointer};
    press.seconds = seconds;
    (void)knife->begin_interaction({press});
    return workspace.changes.has_requests();
  };
  EXPECT_FALSE(click(400, 10));
  EXPECT_FALSE(click(600, 11));
  EXPECT_FALSE(click(600, 13));
  EXPECT_TRUE(click(600, 13.2));
}

TEST(KnifeFeature, keys_of_a_popup_and_with_ctrl_leave_the_polyline) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().DisplaySize = {1000, 700};
  ImGui::GetIO().Fonts->Build();
  Workspace workspace;
  workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
  const auto knife = knife_feature(workspace);
  const std::vector<UserAction> actions = knife->actions();
  find_action(actions, "knife.polyline")->run();
  for (const double x : {400, 500, 600}) {
    workspace.input.pointer = {x, 350};
    (void)knife->begin_interaction({{InputEvent::Kind::kPress, workspace.input.pointer}});
  }
  const auto takes = [&](int key, int mods) {
    return knife->handle_event({InputEvent::Kind::kKey, workspace.input.pointer, key, mods}, false);
  };
  EXPECT_FALSE(takes(GLFW_KEY_ENTER, GLFW_MOD_CONTROL));  // runs the path
  InputEvent held{InputEvent::Kind::kKey, workspace.input.pointer, GLFW_KEY_ENTER};
  held.again = true;
  EXPECT_FALSE(knife->handle_event(held, false)) << "held from a dialog";
  EXPECT_TRUE(takes(GLFW_KEY_BACKSPACE, 0));
  ImGui::NewFrame();
  ImGui::OpenPopup("menu");
  ImGui::EndFrame();
  EXPECT_FALSE(takes(GLFW_KEY_ENTER, 0));
  EXPECT_FALSE(takes(GLFW_KEY_BACKSPACE, 0));
  EXPECT_TRUE(knife->discard_draft());
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace kerf
