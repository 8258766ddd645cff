#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace kerf::test {
namespace {

TEST(Bodies, have_the_properties_of_their_description) {
  World world;
  BodyDesc desc;
  desc.name = "plate";
  desc.position = {1, 2, 3};
  desc.orientation = {0, 1, 0, 0};
  desc.material = "copper";
  desc.thickness = 0.002;
  desc.is_fixed = true;
  const BodyId body = world.add(sheet(4), desc);
  const kerf_body_info info = world.info(body);
  EXPECT_STREQ(info.name, "plate");
  EXPECT_STREQ(info.material, "copper");
  EXPECT_EQ(info.position[2], 3);
  EXPECT_EQ(info.orientation[1], 1);
  EXPECT_EQ(info.thickness, 0.002);
  EXPECT_NEAR(info.density, 8900, 100);
  EXPECT_EQ(info.face_count, 32u);
  EXPECT_EQ(info.piece_count, 1u);
  EXPECT_TRUE(info.is_fixed && !info.is_solid && !info.is_hidden);
  EXPECT_NEAR(world.piece(body, 0).info().mass, 0.002 * info.density, 1e-9);
  world.set_sheet(body, 0, "", 0.003, 1000);
  EXPECT_NEAR(world.piece(body, 0).info().mass, 3, 1e-9);
  world.rename(body, 0, "sheet");
  EXPECT_STREQ(world.info(body).name, "sheet");
  const std::string copy = world.name(body);
  world.rename(body, 0, "a name so long that it is stored apart from its body");
  EXPECT_EQ(copy, "sheet");
  EXPECT_EQ(world.name(body), "a name so long that it is stored apart from its body");
  EXPECT_TRUE(world.undo());
  world.set_hidden(body, 0, true);
  EXPECT_TRUE(world.info(body).is_hidden);
  EXPECT_EQ(world.cut(through_the_middle()).removed_faces, 0u);
  world.remove(body, 0);
  EXPECT_TRUE(world.bodies().empty());
  EXPECT_THROW((void)world.info(body), InvalidArgument);
  EXPECT_THROW((void)world.name(body), InvalidArgument);
  EXPECT_EQ(kerf_body_get_name(world.get(), body, nullptr), KERF_INVALID_ARGUMENT);
  EXPECT_THROW((void)world.corners(body, {}), InvalidArgument);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(world.undo());
  EXPECT_STREQ(world.info(body).name, "plate");
  EXPECT_EQ(world.info(body).thickness, 0.002);
}

TEST(Bodies, reject_bad_values) {
  World world;
  const auto rejects = [&](auto change) {
    BodyDesc desc;
    change(desc);
    EXPECT_THROW(world.add(sheet(1), desc), InvalidArgument);
  };
  rejects([](BodyDesc& d) { d.material = "cheese"; });
  rejects([](BodyDesc& d) { d.thickness = 0; });
  rejects([](BodyDesc& d) { d.density = -1; });
  rejects([](BodyDesc& d) { d.position[1] = NAN; });
  rejects([](BodyDesc& d) { d.orientation[0] = 2; });
  const std::vector<double> huge{0, 0, 0, 1e160, 0, 0, 0, 0, 1e160};
  EXPECT_THROW(world.add(Mesh(huge, std::vector<uint32_t>{0, 1, 2})), InvalidArgument);
  EXPECT_TRUE(world.bodies().empty());
  const BodyId body = world.add(sheet(1));
  EXPECT_THROW(world.move(body, 1, {0, 0, 0}), InvalidArgument);
  EXPECT_THROW(world.move(body + 1, 0, {0, 0, 0}), InvalidArgument);
  EXPECT_THROW((void)world.piece(body, 7), InvalidArgument);
  EXPECT_THROW(world.simulate(-1), InvalidArgument);
  EXPECT_THROW(world.cut(through_the_middle(), {.bodies = {body + 1}}), InvalidArgument);
}

TEST(Bodies, a_solid_is_closed_by_walls) {
  World world;
  BodyDesc desc;
  desc.is_solid = true;
  const BodyId body = world.add(box(2), desc);
  EXPECT_NEAR(world.piece(body, 0).info().volume, 1, 1e-9);
  EXPECT_EQ(world.piece(body, 0).euler_number(), 2);
  Stroke stroke = through_the_middle();
  stroke.keys[0].origin[1] = stroke.keys[1].origin[1] = 2;
  stroke.range = {0, 4};
  const std::string before = world.hash();
  // Cancelled at any moment, also while walls are added.
  for (int steps = 1;; steps += steps / 2 + 1) {
    world.begin_stroke(stroke, {.rim = KERF_RIM_SMOOTH});
    world.end_stroke();
    bool finished = false;
    for (int i = 0; i < steps && !finished; ++i) finished = world.step_stroke(0, 0).is_finished;
    if (finished) break;
    world.cancel_stroke();
    ASSERT_EQ(world.hash(), before) << "after " << steps << " steps";
  }
  const std::vector<Mesh> pieces = world.pieces();
  ASSERT_EQ(pieces.size(), 2u);
  for (const Mesh& piece : pieces) {
    EXPECT_TRUE(piece.info().is_closed);
    EXPECT_NEAR(piece.info().volume, 0.49, 1e-9);
    EXPECT_NEAR(piece.info().mass, 0.49 * 7850, 1e-6);
    EXPECT_EQ(piece.euler_number(), 2);
  }
  const Hits hit = world.nearest_hits(std::vector<double>{0.5, 0.5, 0.5}, std::vector<double>{1, 0, 0});
  EXPECT_TRUE(hit.is_cut[0]);
  EXPECT_NEAR(hit.distances[0], 0.01, 1e-12);
}

TEST(Bodies, a_solid_is_not_cut_open_by_settings_without_walls) {
  World world;
  BodyDesc desc;
  desc.name = "crate";
  desc.is_solid = true;
  const BodyId solid = world.add(box(2), desc);
  const BodyId other = world.add(sheet(10), "plate");
  Stroke stroke = through_the_middle();
  stroke.keys[0].origin[1] = stroke.keys[1].origin[1] = 2;
  stroke.range = {0, 4};
  const std::string before = world.hash();
  const auto refusal = [&](const CutSettings& settings, bool in_steps) -> std::string {
    try {
      if (in_steps) world.begin_stroke(stroke, settings);
      if (!in_steps) world.cut(stroke, settings);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  for (const bool in_steps : {false, true}) {
    EXPECT_EQ(
        refusal({}, in_steps),
        "rim: the body \"crate\" is solid, and its walls need a smooth rim; set that, or make the body a "
        "sheet");
    EXPECT_EQ(refusal({.model = KERF_MODEL_THERMAL, .bodies = {solid}}, in_steps),
              "model: the body \"crate\" is solid, and its walls need the geometric model; set that, or make "
              "the body a sheet");
    EXPECT_EQ(world.hash(), before);
  }
  world.set_hidden(solid, 0, true);
  EXPECT_EQ(refusal({}, false), "");
  world.undo();
  world.undo();
  EXPECT_EQ(refusal({.bodies = {other}}, false), "");
  world.undo();
  EXPECT_EQ(refusal({.rim = KERF_RIM_SMOOTH}, false), "");
}

TEST(Bodies, a_plane_cuts_a_solid_into_closed_halves_until_undo) {
  World world;
  BodyDesc desc;
  desc.is_solid = true;
  world.add(box(2), desc);
  const std::string before = world.hash();
  world.cut_plane({0, 0, 2}, 0.5);
  const std::vector<Mesh> pieces = world.pieces();
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].info().volume, 0.75, 1e-15);
  EXPECT_NEAR(pieces[1].info().volume, 0.25, 1e-15);
  EXPECT_THROW(world.cut_plane({0, 0, 0}, 0.5), InvalidArgument);
  EXPECT_THROW(world.cut_plane({0, NAN, 1}, 0.5), InvalidArgument);
  EXPECT_TRUE(world.undo());
  EXPECT_EQ(world.hash(), before);
}

TEST(Bodies, only_those_named_are_cut) {
  World world;
  const BodyId lower = world.add(sheet(10), "lower");
  BodyDesc above;
  above.position[1] = 0.5;
  const BodyId upper = world.add(sheet(10), above);
  world.cut(through_the_middle(), {.bodies = {lower}});
  EXPECT_EQ(world.info(lower).piece_count, 2u);
  EXPECT_EQ(world.info(upper).piece_count, 1u);
  EXPECT_EQ(world.info(upper).face_count, 200u);
  const std::string file = testing::TempDir() + "kerf-named.kerf";
  world.save_journal(file);
  EXPECT_EQ(World(file).hash(), world.hash());
}

TEST(Bodies, fall_and_return_by_undo) {
  World world;
  BodyDesc desc;
  desc.is_fixed = true;
  const BodyId body = world.add(sheet(10), desc);
  world.cut(through_the_middle());
  const std::string cut = world.hash();
  for (int i = 0; i < 50; ++i) world.simulate(0.01);
  EXPECT_EQ(world.bodies().size(), 2u);
  const BodyId fallen = world.bodies()[0] == body ? world.bodies()[1] : world.bodies()[0];
  EXPECT_NEAR(world.info(fallen).velocity[1], -9.81 * 0.5, 0.2);
  EXPECT_NEAR(world.info(fallen).position[1], -9.81 / 8, 0.1);
  EXPECT_EQ(world.info(body).position[1], 0);
  const std::string file = testing::TempDir() + "kerf-fallen.kerf";
  world.save_journal(file);
  EXPECT_EQ(World(file).hash(), world.hash());
  EXPECT_TRUE(world.undo());
  EXPECT_EQ(world.hash(), cut);
  EXPECT_TRUE(world.redo());
  EXPECT_TRUE(world.undo() && world.undo() && world.undo());
  EXPECT_FALSE(world.undo());
  EXPECT_TRUE(world.bodies().empty());
  EXPECT_TRUE(world.redo() && world.redo());
  EXPECT_EQ(world.hash(), cut);
  world.set_undo_memory(0);
  EXPECT_THROW(world.undo(), Error);
}

TEST(Bodies, a_journal_contains_what_was_not_undone) {
  World world;
  BodyDesc desc;
  desc.position[0] = 3;
  desc.is_solid = true;
  world.add(sheet(2), "undone");
  world.undo();
  world.add(sheet(10), "first");
  world.add(box(2), desc);
  world.cut(through_the_middle(), {.rim = KERF_RIM_SMOOTH, .material = "copper"});
  world.cut(through_the_middle(), {.rim = KERF_RIM_SMOOTH});
  world.undo();
  desc.position = {0, 0.2, 0};
  desc.material = "pmma";
  desc.is_hidden = true;
  const BodyId later = world.add(sheet(4), desc);
  world.set_hidden(later, 0, false);
  world.cut(through_the_middle(), {.rim = KERF_RIM_SMOOTH, .bodies = {later}});
  const std::string file = testing::TempDir() + "kerf-later.kerf";
  world.save_journal(file);
  World again(file);
  EXPECT_EQ(again.hash(), world.hash());
  EXPECT_EQ(again.pieces().size(), world.pieces().size());
  for (size_t i = 0; i < again.pieces().size(); ++i)
    EXPECT_EQ(again.pieces()[i].info().mass, world.pieces()[i].info().mass);
}

TEST(Bodies, a_thermal_cut_reports_its_energy_and_depth) {
  Stroke stroke = through_the_middle();
  stroke.keys[1].time = 2;
  const CutSettings thermal{.model = KERF_MODEL_THERMAL};
  World whole, steps;
  whole.add(sheet(5));
  steps.add(sheet(5));
  EXPECT_EQ(whole.cut(through_the_middle()).emitted, 0);
  whole.undo();
  const CutResult cut = whole.cut(stroke, thermal);
  EXPECT_NEAR(cut.emitted, 2 * stroke.power, 1e-6 * cut.emitted);
  EXPECT_GT(cut.absorbed, 0);
  EXPECT_LT(cut.absorbed, cut.emitted);
  EXPECT_GT(cut.depth, 0);
  EXPECT_LE(cut.depth, 1);
  steps.begin_stroke(stroke, thermal);
  steps.end_stroke();
  StrokeProgress progress = KERF_STROKE_PROGRESS_INIT;
  while (progress.is_finished == 0) progress = steps.step_stroke(1, 1);
  EXPECT_EQ(progress.emitted, cut.emitted);
  EXPECT_EQ(progress.absorbed, cut.absorbed);
  EXPECT_EQ(progress.depth, cut.depth);
  EXPECT_NE(whole.report().find("\"depth_fraction\": "), std::string::npos);
  EXPECT_EQ(whole.report().find("\"uncut\": "), std::string::npos);
}

// Two sheets that are apart, 0 to 1 and 1.1 to 2.1 m along x, in y = 0.
Mesh two_sheets() {
  const Mesh one = sheet(4);
  std::vector<double> vertices(one.vertices().begin(), one.vertices().end());
  std::vector<uint32_t> faces(one.faces().begin(), one.faces().end());
  const auto shift = static_cast<uint32_t>(vertices.size() / 3);
  for (size_t i = 0; i < 3 * shift; ++i) vertices.push_back(vertices[i] + (i % 3 == 0 ? 1.1 : 0));
  for (const uint32_t corner : one.faces()) faces.push_back(corner + shift);
  return {vertices, faces};
}

kerf_joint hinge_between_sheets() {
  kerf_joint joint = KERF_JOINT_INIT;
  joint.kind = KERF_JOINT_HINGE;
  joint.part_a[0] = 1.1;
  joint.part_b[0] = 1;
  joint.anchor[0] = 1.05;
  joint.axis[1] = 0;
  joint.axis[2] = 1;
  joint.part_a[2] = joint.part_b[2] = joint.anchor[2] = 0.5;
  return joint;
}

// A point of a body in the world.
std::array<double, 3> moved(const kerf_body_info& info, const double p[3]) {
  const double *q = info.orientation, w = q[0], x = q[1], y = q[2], z = q[3];
  return {info.position[0] + (1 - 2 * (y * y + z * z)) * p[0] + 2 * (x * y - w * z) * p[1] +
              2 * (x * z + w * y) * p[2],
          info.position[1] + 2 * (x * y + w * z) * p[0] + (1 - 2 * (x * x + z * z)) * p[1] +
              2 * (y * z - w * x) * p[2],
          info.position[2] + 2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] +
              (1 - 2 * (x * x + y * y)) * p[2]};
}

// Lets the first sheet fall upon the edge of a fixed one.
void fall_onto_an_edge(World& world) {
  BodyDesc edge;
  edge.is_fixed = true;
  edge.position = {0.2, -1.2, 0};
  edge.orientation = {0.5, 0.5, 0.5, 0.5};
  world.add(sheet(2), edge);
  world.simulate(1);
}

TEST(Bodies, parts_that_a_hinge_holds_turn_on_it) {
  World world;
  const BodyId body = world.add(two_sheets());
  const kerf_joint joint = hinge_between_sheets();
  world.join(body, joint);
  fall_onto_an_edge(world);
  ASSERT_EQ(world.bodies().size(), 3u);
  std::vector<kerf_body_info> parts;
  for (const BodyId id : world.bodies())
    if (world.info(id).is_fixed == 0) parts.push_back(world.info(id));
  ASSERT_EQ(parts.size(), 2u);
  double apart = 0, turned = 0;
  const auto first = moved(parts[0], joint.anchor), second = moved(parts[1], joint.anchor);
  for (size_t k = 0; k < 3; ++k) apart = std::max(apart, std::abs(first[k] - second[k]));
  for (size_t k = 0; k < 4; ++k) turned += parts[0].orientation[k] * parts[1].orientation[k];
  EXPECT_LT(first[1], -0.3);
  EXPECT_LT(apart, 0.01);
  EXPECT_LT(std::abs(turned), 0.999);  // cosine of half of the angle between them
}

TEST(Bodies, parts_that_a_weld_or_no_joint_holds_move_as_one) {
  for (const bool welded : {false, true}) {
    World world;
    const BodyId body = world.add(two_sheets());
    kerf_joint joint = hinge_between_sheets();
    joint.kind = KERF_JOINT_WELD;
    if (welded) world.join(body, joint);
    fall_onto_an_edge(world);
    EXPECT_EQ(world.bodies().size(), 2u);
  }
}

TEST(Bodies, a_joint_can_be_undone_and_is_kept_in_a_journal) {
  World world;
  const BodyId body = world.add(two_sheets());
  world.join(body, hinge_between_sheets());
  EXPECT_TRUE(world.undo());
  fall_onto_an_edge(world);
  EXPECT_EQ(world.bodies().size(), 2u);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(world.undo());
  world.join(body, hinge_between_sheets());
  fall_onto_an_edge(world);
  EXPECT_EQ(world.bodies().size(), 3u);
  const std::string file = testing::TempDir() + "kerf-joint.kerf";
  world.save_journal(file);
  EXPECT_EQ(World(file).hash(), world.hash());
}

TEST(Bodies, reject_joints_that_cannot_be_made) {
  World world;
  const BodyId body = world.add(two_sheets());
  const std::string before = world.hash();
  const auto rejects = [&](auto change) {
    kerf_joint joint = hinge_between_sheets();
    change(joint);
    EXPECT_THROW(world.join(body, joint), InvalidArgument);
  };
  rejects([](kerf_joint& j) { j.anchor[0] = NAN; });
  rejects([](kerf_joint& j) { j.anchor[0] = 1000; });
  rejects([](kerf_joint& j) { j.axis[2] = 0; });
  rejects([](kerf_joint& j) { j.radius = 0; });
  rejects([](kerf_joint& j) { j.radius = 1e-3, j.part_a[1] = 1; });
  rejects([](kerf_joint& j) { j.part_a[0] = 0; });  // both points are of one part
  rejects([](kerf_joint& j) { j.has_limits = 1, j.limits[0] = 1; });
  rejects([](kerf_joint& j) { j.kind = KERF_JOINT_HUB, j.has_limits = 1; });
  rejects([](kerf_joint& j) { j.size = 4; });
  EXPECT_THROW(world.join(body + 1, hinge_between_sheets()), InvalidArgument);
  EXPECT_EQ(world.hash(), before);
  world.cut(through_the_middle());
  rejects([](kerf_joint&) {});
}

TEST(Bodies, keep_pose_and_faces_in_a_saved_scene) {
  const std::vector<double> tiny{0, 0, 0, 1e-20, 0, 0, 0, 0, 1e-20};
  World world;
  BodyDesc desc;
  desc.position = {3, 1, 2};
  desc.orientation = {0.6, 0, 0.8, 0};
  world.add(Mesh(tiny, std::vector<uint32_t>{0, 1, 2}), desc);
  const std::string folder = testing::TempDir() + "kerf-pose";
  world.save_scene(folder);
  const World again(folder + "/scene.json");
  EXPECT_EQ(again.hash(), world.hash());
  EXPECT_EQ(again.info(again.bodies()[0]).position[0], 3);
}

TEST(Bodies, have_the_name_of_their_only_piece_also_in_a_saved_scene) {
  World world;
  const BodyId body = world.add(sheet(10), "plate");
  world.cut(through_the_middle());
  const std::vector<uint32_t> labels = world.piece_labels(body, world.faces(body));
  world.rename(body, *std::max_element(labels.begin(), labels.end()), "lid");
  EXPECT_EQ(world.name(body), "plate");
  world.remove(body, 0);
  ASSERT_EQ(world.pieces().size(), 1u);
  EXPECT_EQ(world.pieces()[0].name(), "lid");
  EXPECT_EQ(world.name(body), "lid");
  EXPECT_STREQ(world.info(body).name, "lid");
  const std::string folder = testing::TempDir() + "kerf-names";
  world.save_scene(folder);
  EXPECT_EQ(World(folder + "/scene.json").pieces()[0].name(), "lid");
}

TEST(Bodies, many_are_added_and_undone) {
  World world;
  const std::string empty = world.hash();
  const Mesh mesh = sheet(2);
  const char* given = std::getenv("KERF_TEST_BODIES");  // of counted_bodies_test.py
  const size_t count = given == nullptr ? 200 : std::stoul(given);
  for (size_t i = 0; i < count; ++i) world.add(mesh);
  EXPECT_EQ(world.bodies().size(), count);
  while (world.undo()) {
  }
  EXPECT_EQ(world.hash(), empty);
  while (world.redo()) {
  }
  EXPECT_EQ(world.bodies().size(), count);
}

}  // namespace
}  // namespace kerf::test
