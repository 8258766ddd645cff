#include "ui/editor/inspect/face_inspector.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"

#include <algorithm>
#include <set>

#include "core/base/random.h"
#include "core/joints/joined_parts.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/pieces/piece_placement.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/layout.h"
#include "ui/window/widgets.h"

namespace kerf {
namespace {

TEST(FaceFacts, agree_with_the_mesh_on_every_face) {
  const Body body = make_body("ball", test::build(test::sphere(9, 12, 1)));
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const FaceFacts facts = face_facts(body, FaceId(f));
    EXPECT_EQ(facts.face, FaceId(f));
    EXPECT_EQ(facts.loaded, FaceId(f));
    EXPECT_EQ(facts.area, triangle_area(body.mesh.triangle(FaceId(f))));
    EXPECT_NEAR(facts.angles[0] + facts.angles[1] + facts.angles[2], 180, 1e-9);
    // The law of sines: edge i is opposite to corner i + 2.
    const double ratio = facts.edges[0] / std::sin(facts.angles[2] * 3.14159265358979 / 180);
    EXPECT_NEAR(facts.edges[1] / std::sin(facts.angles[0] * 3.14159265358979 / 180), ratio, 1e-9 * ratio);
    std::vector<FaceId> around, across;
    body.mesh.append_neighbours(FaceId(f), around);
    for (const auto& side : facts.neighbours) across.insert(across.end(), side.begin(), side.end());
    std::sort(around.begin(), around.end());
    std::sort(across.begin(), across.end());
    EXPECT_EQ(across, around);
  }
}

TEST(FaceFacts, name_a_unique_slot_of_the_tree) {
  const Body body = make_body("ball", test::build(test::sphere(9, 12, 1)));
  std::set<std::pair<uint32_t, uint32_t>> slots;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const auto slot = tree_slot(body.tree, body.mesh, FaceId(f));
    ASSERT_TRUE(slot);
    EXPECT_LT(slot->place, 4u);
    EXPECT_FALSE(slot->hit);
    EXPECT_TRUE(slots.emplace(slot->block, slot->place).second);
    EXPECT_EQ(face_facts(body, FaceId(f)).slot, *slot);
  }
  EXPECT_FALSE(tree_slot(body.tree, body.mesh, FaceId(body.mesh.face_slots())));
}

TEST(FaceFacts, are_listed_with_border_edges_and_non_manifold_edges_named) {
  Soup three;  // three triangles on one edge
  three.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0.2, 0}, {0, 1, 0}};
  three.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const Body body = make_body("fan", test::build(three));
  const std::vector<std::string> lines = lines_of(face_facts(body, FaceId(0)), "fan 7", FileUnit::kMetre);
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  EXPECT_NE(all.find("Face 0, as loaded"), std::string::npos) << all;
  EXPECT_NE(all.find("(ring of 3)"), std::string::npos) << all;
  EXPECT_NE(all.find("boundary"), std::string::npos) << all;
  EXPECT_NE(all.find("fan 7"), std::string::npos) << all;
  EXPECT_NE(all.find("90.0"), std::string::npos) << all;
}

TEST(FaceReadout, outlines_a_loose_part_where_an_exploded_view_shows_it) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().DisplaySize = {1000, 700};
  ImGui::GetIO().Fonts->Build();
  ImGui::NewFrame();
  keep_landmarks(nullptr);
  Workspace workspace;
  World world;
  const BodyId id = world.add(make_body("plate", test::build(test::plate(1))));
  const size_t faces = world.body(id).mesh.face_slots();
  workspace.session.document = Document(std::move(world));
  ViewState& view = workspace.view;
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  view.camera.look({0.5, 3, 1}, {0.5, 0, 0});
  view.camera.finish();
  const Vec3 offset(0.75, 0, 0);  // of the piece with which the plate, a loose part of another one, moves
  view.look.pieces[{id, 1}].offset = offset;
  view.look.groups[id] =
      std::make_shared<const PieceGroups>(PieceGroups{{{0, 1}}, std::vector<uint32_t>(faces, 1), {Vec3(0)}});
  const PrimaryViewport viewport(view);
  workspace.input.tool = kInspectTool;
  workspace.input.pointer = *viewport.place_of(offset + Vec3(0.1, 0, 0.05));
  workspace.input.viewport_hovered = true;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  inspect_feature(workspace)->draw_overlay(list);
  const auto is_drawn = [&](const Vec3& corner) {
    const Vec2 place = *viewport.place_of(corner + offset);
    return std::any_of(list.VtxBuffer.begin(), list.VtxBuffer.end(),
                       [&](const ImDrawVert& v) { return glm::length(Vec2(v.pos.x, v.pos.y) - place) < 8; });
  };
  const Triangle t = workspace.world().body(id).mesh.triangle(FaceId(0));
  EXPECT_GE(std::ranges::count_if(t, is_drawn), 2) << "the other face shares two corners";
  ImGui::EndFrame();
  ImGui::DestroyContext();
}

TEST(HeatProbe, records_with_other_tools_in_the_temperature_view_only) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(24, 32, 1))));
  ViewState view;
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  view.camera.look({0, 0, 5}, {0, 0, 0});
  view.camera.finish();
  view.look.show.heat = true;
  const Vec2 place = view.layout.first.at + 0.5 * view.layout.first.size + Vec2(37, 21);
  const auto surface = surface_point(world, view.look, PrimaryViewport(view).ray(place));
  ASSERT_TRUE(surface);
  HeatProbe probe;
  probe.follow(world, view, surface->at, true);
  ASSERT_EQ(probe.samples().size(), 1u);
  world.pass(kTicksPerSecond);
  probe.follow(world, view, std::nullopt, false);
  EXPECT_EQ(probe.samples().size(), 2u);
  view.look.show.heat = false;
  probe.follow(world, view, std::nullopt, false);
  EXPECT_FALSE(probe.at());
  EXPECT_TRUE(probe.samples().empty());
  view.look.show.heat = true;
  probe.follow(world, view, surface->at, true);
  probe.follow(world, view, std::nullopt, true);
  EXPECT_FALSE(probe.at()) << "the measurement was cleared";
}

TEST(PlacementAngles, round_trip_through_the_orientation) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const Vec3 angles(random.uniform(-179, 179), random.uniform(-89, 89), random.uniform(-179, 179));
    EXPECT_LT(glm::length(angles_of(orientation_of(angles)) - angles), 1e-6);
  }
  EXPECT_EQ(angles_of({1, 0, 0, 0}), Vec3(0));
  const Vec3 turned = orientation_of({0, 0, 90}) * Vec3(1, 0, 0);
  EXPECT_LT(glm::length(turned - Vec3(0, 1, 0)), 1e-12);
}

TEST(PlacementAngles, describe_the_orientation_at_right_angles_about_y) {
  for (const double y : {-90.0, 90.0}) {
    for (double x = -180; x <= 180; x += 15) {
      for (double z = -180; z <= 180; z += 45) {
        const glm::dquat orientation = orientation_of({x, y, z});
        const Vec3 angles = angles_of(orientation);
        EXPECT_EQ(angles.y, y);
        EXPECT_EQ(angles.z, 0.0);
        const glm::dquat again = orientation_of(angles);
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
          EXPECT_LT(glm::length(again * axis - orientation * axis), 1e-7) << x << " " << y << " " << z;
      }
    }
  }
}

// Against points on a circle: the inscribed angle is half of the arc that it sees.
TEST(Corner, has_the_inscribed_angle_and_the_radius_of_its_circle) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const double radius = random.uniform(0.1, 10), first = random.uniform(0, 2), last = random.uniform(3, 6);
    const Vec3 middle(random.uniform(-5, 5), random.uniform(-5, 5), 2);
    const auto point = [&](double angle) {
      return middle + radius * Vec3(std::cos(angle), std::sin(angle), 0);
    };
    const double at = random.uniform(last + 0.1, first + 6.1);
    const Corner corner = measure_corner(point(first), point(at), point(last));
    EXPECT_NEAR(corner.degrees, 0.5 * (last - first) * 180 / kPi, 1e-6) << "seed 5, case " << i;
    ASSERT_TRUE(corner.radius);
    EXPECT_NEAR(*corner.radius, radius, 1e-6 * radius);
  }
  EXPECT_FALSE(measure_corner({0, 0, 0}, {1, 0, 0}, {2, 0, 0}).radius);
}

}  // namespace
}  // namespace kerf
