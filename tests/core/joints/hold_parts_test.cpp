#include "core/joints/joined_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "core/world/world.h"
#include "tests/support/jointed.h"
#include "tests/support/piece_sums.h"
#include "tests/support/same_world.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

using test::NamedSheet;

JointDescription weld(std::string a, std::string b, const Vec3& anchor, std::optional<double> radius = {}) {
  JointDescription joint;
  joint.parts = {std::move(a), std::move(b)};
  joint.anchor = anchor;
  joint.radius = radius;
  return joint;
}

// A large sheet in y = 0 and above it a row of small ones, a mirror of two parts among them:
//
//   shell, glass    welded to each other, and the shell to the sheet at x = 0.3
//   handle          welded to the sheet at x = -0.3
//   badge           no joint names it
World car_of_sheets() {
  const Soup small = test::rectangle(0.06, 0.06, 2);
  const std::vector<NamedSheet> sheets{{"sheet", test::rectangle(1, 0.4, 20)},
                                       {"shell", small, {0.3, 0.02, 0}},
                                       {"glass", test::rectangle(0.04, 0.04, 1), {0.3, 0.04, 0}},
                                       {"handle", small, {-0.3, 0.02, 0}},
                                       {"badge", small, {0, 0.02, 0.1}}};
  const std::vector<JointDescription> welds{weld("shell", "sheet", {0.3, 0.02, 0}, 0.05),
                                            weld("glass", "shell", {0.3, 0.04, 0}),
                                            weld("handle", "sheet", {-0.3, 0.02, 0}, 0.05)};
  return test::jointed_world(sheets, welds);
}

// Cuts from one point of the sheet to another, downwards, and from above the sheet by `above`.
StepResult cut(World& world, const Vec3& from, const Vec3& to, double radius, double above = 0.01) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 0.5};
  settings.resolution.target_edge = 0.01;
  const Vec3 up(0, above, 0), down(0, -1, 0);
  std::vector<BeamMove> moves;
  constexpr int kMoves = 20;
  for (int i = 0; i < kMoves; ++i) {
    const auto at = [&](int k) { return from + up + (to - from) * (static_cast<double>(k) / kMoves); };
    moves.push_back({{at(i), down}, {at(i + 1), down}, 0.1});
  }
  return *test::cut_whole(world, settings, moves);
}

// The label of the part that has a base face near a point of the mesh as loaded.
uint32_t label_of(const World& world, const std::string& part) {
  const Body& body = world.body(world.ids()[0]);
  for (const MeshPart& p : body.named_parts) {
    if (p.name != part) continue;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      const uint32_t base = body.mesh.data(FaceId(f)).base.index;
      if (body.mesh.is_live(FaceId(f)) && p.first <= base && base < p.last) return body.label(FaceId(f));
    }
  }
  ADD_FAILURE() << "nothing is left of " << part;
  return 0;
}

void expect_no_separation(World& world) {
  for (const JointMode mode : {JointMode::kRigid, JointMode::kArticulated}) {
    Delta delta;
    separate_by_joints(world, mode, delta);
    EXPECT_TRUE(delta.empty());
  }
}

TEST(SeparateByJoints, changes_nothing_while_all_joints_hold) {
  World world = car_of_sheets();
  EXPECT_EQ(held_joints(world).size(), 3u);
  expect_no_separation(world);
  EXPECT_EQ(world.live_pieces(), 1u);
}

TEST(SeparateByJoints, a_part_follows_the_piece_it_is_welded_to) {
  World world = car_of_sheets();
  const uint64_t hash = state_hash(world);
  const StepResult result = cut(world, {0.15, 0, -0.3}, {0.15, 0, 0.3}, 0.005);
  EXPECT_EQ(held_joints(world).size(), 3u);
  EXPECT_EQ(world.live_pieces(), 2u);
  const uint32_t cut_off = label_of(world, "shell");
  EXPECT_NE(cut_off, 0u);
  EXPECT_EQ(label_of(world, "glass"), cut_off);
  EXPECT_EQ(label_of(world, "handle"), 0u);
  EXPECT_EQ(label_of(world, "badge"), 0u);
  EXPECT_NE(state_hash(world), hash);
  ASSERT_EQ(result.delta.bodies.size(), 1u);
  EXPECT_EQ(result.delta.bodies[0].new_pieces, std::vector<uint32_t>{cut_off});
}

TEST(SeparateByJoints, a_part_with_a_burnt_weld_becomes_a_piece_with_its_attachments) {
  World world = car_of_sheets();
  cut(world, {0.3, 0, -0.02}, {0.3, 0, 0.02}, 0.08);  // from between the sheet and the shell
  EXPECT_EQ(held_joints(world).size(), 2u);
  EXPECT_EQ(world.live_pieces(), 2u);
  const uint32_t mirror = label_of(world, "shell");
  EXPECT_NE(mirror, 0u);
  EXPECT_EQ(label_of(world, "glass"), mirror);
  const Body& body = world.body(world.ids()[0]);
  EXPECT_EQ(body.pieces[mirror].faces, 8u + 2u);
  EXPECT_EQ(body.pieces[mirror].cut_off.faces, 0u);
}

// The connected parts by the counts that the body keeps.
size_t counted_parts(const Body& body) {
  size_t parts = 0;
  for (uint32_t c = 0; c < body.components.left.size(); ++c) parts += body.components.left[c].faces > 0;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) parts += body.pieces[p].cut_off.faces > 0;
  return parts;
}

TEST(SeparateByJoints, jointed_pieces_are_cut_like_any_others) {
  for (const uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = car_of_sheets();
    const auto somewhere = [&] { return Vec3(random.uniform(-0.5, 0.5), 0, random.uniform(-0.2, 0.2)); };
    for (int stroke = 0; stroke < 25; ++stroke) {
      cut(world, somewhere(), somewhere(), 0.004, 0.05);
      const Body& body = world.body(world.ids()[0]);
      test::expect_piece_sums(body);
      std::vector<uint32_t> component;
      ASSERT_EQ(counted_parts(body), label_components(body.mesh, component)) << "stroke " << stroke;
    }
    EXPECT_GT(world.live_pieces(), 5u);
  }
}

// Merges two parts of a piece as a wall between them does.
void merge(World& world, uint32_t label, const std::string& a, const std::string& b) {
  Body& body = world.body(world.ids()[0]);
  const std::vector<FaceId> faces = body.faces_of(label);
  const auto face_of = [&](const std::string& part) {
    return std::ranges::find_if(faces, [&](FaceId f) {
      const uint32_t base = body.mesh.data(f).base.index;
      return std::ranges::any_of(body.named_parts, [&](const MeshPart& p) {
        return p.name == part && p.first <= base && base < p.last;
      });
    });
  };
  ASSERT_TRUE(face_of(a) != faces.end() && face_of(b) != faces.end());
  join_parts(body, *face_of(a), *face_of(b));
}

TEST(SeparateByJoints, a_copy_has_no_joints_and_leaves_those_of_the_original) {
  World world = car_of_sheets();
  Delta delta;
  const BodyId copy = duplicate(world, {world.ids()[0], 0}, 1, delta);
  EXPECT_EQ(held_joints(world).size(), 3u);
  expect_no_separation(world);
  EXPECT_EQ(world.live_pieces(), 2u);
  cut(world, {0.15, 0, -0.3}, {0.15, 0, 0.3}, 0.005);  // the sheets of both
  EXPECT_EQ(world.live_pieces(), 4u);
  detach(world, {copy, 1}, 2, delta);
  EXPECT_EQ(held_joints(world).size(), 3u);
}

TEST(SeparateByJoints, a_part_merged_with_one_without_joints_is_released_with_it) {
  const Soup small = test::rectangle(0.06, 0.06, 2);
  const std::vector<NamedSheet> sheets{{"badge", small, {-0.2, 0.02, 0}},
                                       {"sheet", test::rectangle(1, 0.4, 20)},
                                       {"handle", small, {-0.3, 0.02, 0}}};
  const JointDescription held = weld("handle", "sheet", {-0.3, 0.02, 0}, 0.05);
  World world = test::jointed_world(sheets, {&held, 1});
  ASSERT_NO_FATAL_FAILURE(merge(world, 0, "badge", "handle"));
  cut(world, {-0.3, 0, -0.02}, {-0.3, 0, 0.02}, 0.08);  // from between the sheet and the handle
  EXPECT_EQ(world.live_pieces(), 2u);
  EXPECT_NE(label_of(world, "handle"), 0u);
  EXPECT_EQ(label_of(world, "badge"), label_of(world, "handle"));
}

TEST(SeparateByJoints, accepts_a_part_that_a_wall_merged_into_a_piece_cut_off) {
  World world = car_of_sheets();
  cut(world, {0.15, 0, -0.3}, {0.15, 0, 0.3}, 0.005);
  ASSERT_NO_FATAL_FAILURE(merge(world, label_of(world, "shell"), "shell", "sheet"));
  Delta delta;
  separate_by_joints(world, JointMode::kRigid, delta);
  EXPECT_TRUE(delta.empty());
  EXPECT_EQ(held_joints(world).size(), 3u);
  EXPECT_EQ(world.live_pieces(), 2u);
}

TEST(SeparateByJoints, cutting_the_faces_of_a_weld_releases_it) {
  World world = car_of_sheets();
  cut(world, {-0.3, 0, -0.3}, {-0.3, 0, 0.3}, 0.003);  // divides the faces of the sheet below the handle
  EXPECT_EQ(held_joints(world).size(), 2u);
  const uint32_t handle = label_of(world, "handle");
  EXPECT_NE(handle, 0u);
  EXPECT_EQ(world.body(world.ids()[0]).pieces[handle].faces, 8u);
}

// Cuts straight down at x from z = -0.1 to 0.1, between these heights.
void cut_between(World& world, double x, double high, double low, double radius) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, high - low};
  settings.resolution.target_edge = 0.005;
  const Vec3 down(0, -1, 0);
  for (int i = -20; i < 20; ++i) {
    const BeamMove move{{{x, high, 0.005 * i}, down}, {{x, high, 0.005 * (i + 1)}, down}, 0.1};
    ASSERT_TRUE(test::cut_whole(world, settings, std::span(&move, 1)));
  }
}

// A bar on a sheet, and on the bar a rail that is welded to it at both ends. The bar is cut in two below the
// rail, then off the sheet: what is left of the bar is held, by the rail, to what was cut off it.
TEST(SeparateByJoints, the_rest_of_a_part_stays_separate_from_pieces_cut_off_it) {
  const std::vector<NamedSheet> sheets{{"sheet", test::rectangle(1, 0.4, 20)},
                                       {"bar", test::rectangle(0.8, 0.04, 20), {0, 0.02, 0}},
                                       {"rail", test::rectangle(0.7, 0.02, 20), {0, 0.04, 0}}};
  const std::vector<JointDescription> welds{weld("bar", "sheet", {-0.15, 0.02, 0}, 0.03),
                                            weld("rail", "bar", {-0.3, 0.04, 0}, 0.03),
                                            weld("rail", "bar", {0.3, 0.04, 0}, 0.03)};
  World world = test::jointed_world(sheets, welds);
  ASSERT_EQ(held_joints(world).size(), 3u);
  cut_between(world, 0.05, 0.03, 0.01, 0.004);  // the bar alone
  EXPECT_EQ(held_joints(world).size(), 3u);
  EXPECT_EQ(world.live_pieces(), 2u);
  cut_between(world, -0.15, 0.01, -0.01, 0.05);  // the sheet where it carries the bar
  EXPECT_EQ(held_joints(world).size(), 2u);
  const Body& body = world.body(world.ids()[0]);
  ASSERT_NO_FATAL_FAILURE(test::expect_part_counts(body));
  EXPECT_EQ(world.live_pieces(), 3u);
  EXPECT_NE(label_of(world, "rail"), 0u);
  cut_between(world, -0.3, 0.05, 0.03, 0.05);  // the rail where it holds what is left of the bar
  ASSERT_NO_FATAL_FAILURE(test::expect_part_counts(body));
  EXPECT_EQ(world.live_pieces(), 3u);
}

TEST(SeparateByJoints, undo_and_redo_of_a_stroke_include_joint_changes) {
  Document document(car_of_sheets());
  const World before = document.world();
  const Vec3 down(0, -1, 0);
  CutSettings settings;
  settings.laser.radius = 0.08;
  settings.laser.range = {0, 0.5};
  settings.resolution.target_edge = 0.01;
  document.apply(BeginStroke{settings, {{0.3, 0.01, -0.02}, down}});
  document.apply(MoveBeam{{{0.3, 0.01, 0.02}, down}});
  document.apply(EndStroke{});
  ASSERT_TRUE(test::run_all(document).ok());
  const World after = document.world();
  EXPECT_EQ(after.live_pieces(), 2u);
  document.apply(Undo{});
  test::expect_same_world(document.world(), before);
  EXPECT_EQ(held_joints(document.world()).size(), 3u);
  document.apply(Redo{});
  test::expect_same_world(document.world(), after);
  EXPECT_EQ(held_joints(document.world()).size(), 2u);
}

}  // namespace
}  // namespace kerf
