#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/deterministic_math.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/save.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh_file.h"
#include "core/world/body_mass.h"
#include "core/world/world.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/piece_sums.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

Soup ball(double radius, const Vec3& at = {}) { return moved(sphere(16, 24, radius), at, 1); }

Soup box(const Vec3& size) { return moved(inside_out(brick(size)), -0.5 * size, 1); }

// Along x at this z, from above.
SolidStroke slot_at(double z, double from = -2, double to = 2) {
  return straight_stroke({from, 2, z}, {to, 2, z}, {0, -1, 0}, 0.01, {0, 5});
}

SolidStroke circle_of(double radius) {
  SolidStroke stroke = slot_at(0);
  stroke.poses.clear();
  for (int i = 0; i <= 64; ++i) {
    const double angle = 2 * kPi * (i % 64) / 64;
    stroke.poses.push_back({{radius * std::cos(angle), 2, radius * std::sin(angle)}, {0, -1, 0}});
  }
  return stroke;
}

// Into the middle of a box around the origin.
SolidStroke hole_that_ends_inside() {
  return straight_stroke({-0.1, 2, 0.05}, {0.2, 2, 0.05}, {0, -1, 0}, 0.1, {0, 2});
}

std::vector<size_t> faces_by_label(const Body& body) {
  std::vector<size_t> faces;
  for (uint32_t label = 0; label < body.pieces.size(); ++label) {
    if (body.pieces[label].faces > 0) faces.push_back(body.pieces[label].faces);
  }
  return faces;
}

// A full search finds one label in every connected part, no label but that of the body in two solid parts,
// and what the pieces count.
void expect_right_labels(const Body& body) {
  std::vector<uint32_t> component;
  const uint32_t parts = label_components(body.mesh, component);
  std::vector<std::vector<FaceId>> faces(parts);
  for (uint32_t f = 0; f < component.size(); ++f) {
    if (body.mesh.is_live(FaceId(f))) faces[component[f]].emplace_back(f);
  }
  std::set<uint32_t> in_use;
  for (const std::vector<FaceId>& own : faces) {
    const uint32_t label = body.mesh.data(own[0]).piece;
    for (const FaceId f : own) ASSERT_EQ(body.mesh.data(f).piece, label) << "two labels in one part";
    const FaceCounts& whole = body.whole_of(own[0]);
    ASSERT_EQ(whole.faces, own.size()) << "of a part, as it is counted";
    double area = 0;
    for (const FaceId f : own) area += triangle_area(body.mesh.triangle(f));
    ASSERT_NEAR(whole.area, area, 1e-9 * body.loaded.area);
    if (label == 0 || enclosed_volume(body.mesh, own, body.middle()).volume < 0) continue;
    ASSERT_TRUE(in_use.insert(label).second) << "label " << label << " on two parts";
  }
  ASSERT_NO_FATAL_FAILURE(expect_piece_sums(body));
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  EXPECT_EQ(find_fault(body.mesh), "");
}

struct Case {
  std::string name;
  Soup soup;
  std::vector<SolidStroke> strokes;
  size_t solids = 0, pieces = 0;  // that are left
};

std::vector<Case> cases() {
  const Soup hollow = both(ball(0.5), inside_out(ball(0.35)));
  return {{"box in two", box({1, 1, 1}), {slot_at(0.1)}, 2, 2},
          {"box in three", box({1, 1, 1}), {slot_at(0.1), slot_at(-0.2)}, 3, 3},
          {"slit in a box", box({1, 1, 1}), {slot_at(0.1, -0.2, 0.3)}, 1, 1},
          {"notch in a box", box({1, 1, 1}), {slot_at(0.1, -2, 0.3)}, 1, 1},
          {"blind hole in a box", box({1, 1, 1}), {hole_that_ends_inside()}, 1, 1},
          {"box with a plug", box({1, 0.4, 1}), {circle_of(0.3)}, 2, 2},
          {"plug in two", box({1, 0.4, 1}), {circle_of(0.3), slot_at(0, -0.35, 0.35)}, 3, 3},
          {"box with two plugs", box({1, 0.4, 1}), {circle_of(0.3), circle_of(0.15)}, 3, 3},
          {"ball in two", ball(0.5), {slot_at(0.1)}, 2, 2},
          {"hollow ball in two", hollow, {slot_at(0.1)}, 2, 2},
          {"a cavity that went along is cut",
           both(ball(0.5), inside_out(ball(0.1, {0, 0, 0.3}))),
           {slot_at(0.1), slot_at(0.3)},
           3,
           3},
          {"cap off a hollow ball", hollow, {slot_at(0.42)}, 2, 2},
          {"hollow ball with a hole", hollow, {slot_at(0.05, 0, 0)}, 1, 1},
          // Two of the four parts keep the label of the body.
          {"ball in a hollow ball", both(hollow, ball(0.2)), {slot_at(0.1)}, 4, 3},
          {"two balls in two", both(ball(0.3), ball(0.3, {0.9, 0, 0})), {slot_at(0.1)}, 4, 3},
          {"ring open at one side", torus(32, 16, 0.4, 0.15), {slot_at(0.02, 0, 2)}, 1, 1},
          {"ring in two", torus(32, 16, 0.4, 0.15), {slot_at(0.02)}, 2, 2}};
}

TEST(CloseByWalls, creates_the_expected_number_of_closed_pieces) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Random random(1);
    SolidCut cut(world_of(c.soup));
    for (const SolidStroke& stroke : c.strokes)
      EXPECT_TRUE(cut.draw(stroke, random)) << (cut.reasons().empty() ? "" : cut.reasons().back());
    EXPECT_EQ(cut.solids(), c.solids);
    EXPECT_EQ(faces_by_label(cut.body()).size(), c.pieces);
    ASSERT_NO_FATAL_FAILURE(expect_right_labels(cut.body()));
    EXPECT_EQ(find_fault(cut.body().mesh), "");
  }
}

// A beam that turns about a point above a plate takes a strip as wide as the beam from it, and half of the
// beam at each end.
TEST(CloseByWalls, removes_the_volume_swept_by_a_beam_tilting_up_to_70_degrees) {
  constexpr double kRadius = 0.03, kHeight = 1.25, kThickness = 0.5;
  for (const double degrees : {20, 45, 60, 70}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * kPi / 180;
    SolidStroke stroke = straight_stroke({}, {}, {0, -1, 0}, kRadius, {0, 20});
    stroke.poses.clear();
    for (int i = -4; i <= 4; ++i) {
      const double turned = angle * i / 4;
      stroke.poses.push_back({{0, kHeight, 0}, {std::sin(turned), -std::cos(turned), 0}});
    }
    SolidCut cut(world_of(box({12, kThickness, 1})));
    Random random(1);
    ASSERT_TRUE(cut.draw(stroke, random)) << (cut.reasons().empty() ? "" : cut.reasons().back());
    const double strip = 2 * kHeight * std::tan(angle) * kThickness * 2 * kRadius;
    const double ends = kPi * kRadius * kRadius * kThickness / std::cos(angle);
    const double left = enclosed_volume(cut.body().mesh, cut.body().middle()).volume;
    EXPECT_NEAR(12 * kThickness - left, strip + ends, 1e-3 * (strip + ends));
  }
}

TEST(CloseByWalls, assigns_the_cut_material_to_walls_only) {
  Random random(1);
  World world = world_of(box({1, 1, 1}));
  Body& body = world.body(world.ids().front());
  body.solid = false;
  EXPECT_FALSE(cut_material(body));
  make_solid(body, true);
  const auto material = cut_material(body);
  ASSERT_TRUE(material);
  EXPECT_EQ(body.material_names, (std::vector<std::string>{"", "cut"}));
  make_solid(body, true);
  EXPECT_EQ(body.material_names.size(), 2u);
  SolidCut cut(std::move(world));
  ASSERT_TRUE(cut.draw(slot_at(0.1), random));
  ASSERT_TRUE(cut.draw(slot_at(-0.2), random));
  const Body& after = cut.body();
  size_t walls = 0;
  for (uint32_t f = 0; f < after.mesh.face_slots(); ++f) {
    if (!after.mesh.is_live(FaceId(f))) continue;
    const bool is_wall = after.walls.beside(after.mesh, FaceId(f)).valid();
    EXPECT_EQ(after.mesh.data(FaceId(f)).material == *material, is_wall);
    walls += is_wall;
  }
  EXPECT_GT(walls, 100u);
}

TEST(CloseByWalls, keeps_labels_and_sums_correct_in_random_strokes) {
  const std::vector<NamedSoup> solids = generated_solids();
  for (uint64_t seed = 1001; seed <= 1000 + runs(80); ++seed) {
    const auto& [name, soup] = solids[seed % solids.size()];
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    Random random(seed);
    SolidCut cut(world_of(soup));
    for (int i = 0; i < 3; ++i) {
      if (!cut.draw(random_solid_stroke(cut.document().world(), random), random)) break;
      ASSERT_NO_FATAL_FAILURE(expect_right_labels(cut.body()));
    }
  }
}

TEST(CloseByWalls, undoes_and_redoes_exactly) {
  const std::vector<Case> all = cases();
  for (const Case& c : all) {
    SCOPED_TRACE(c.name);
    Random random(1);
    SolidCut cut(world_of(c.soup));
    Document& document = cut.document();
    std::vector<World> worlds{World(document.world())};
    for (const SolidStroke& stroke : c.strokes) {
      cut.draw(stroke, random);
      worlds.emplace_back(document.world());
    }
    for (size_t i = c.strokes.size(); i-- > 0;) {
      ASSERT_TRUE(document.apply(Undo{}).ok());
      expect_same_world(document.world(), worlds[i]);
    }
    for (size_t i = 1; i <= c.strokes.size(); ++i) {
      ASSERT_TRUE(document.apply(Redo{}).ok());
      while (document.waiting() > 0) ASSERT_TRUE(document.step(1).ok());
      expect_same_world(document.world(), worlds[i]);
    }
  }
}

// However many moves go into a step.
TEST(CloseByWalls, gives_the_same_state_for_any_step_size) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    uint64_t hash = 0;
    for (const size_t moves : {size_t{1000}, size_t{1}, size_t{7}}) {
      Document document(world_of(c.soup));
      ASSERT_TRUE(document.apply(SetSolid{{document.world().ids().front(), 0}, true}).ok());
      for (const SolidStroke& stroke : c.strokes) {
        document.apply(BeginStroke{stroke.settings, stroke.poses[0]});
        for (size_t i = 1; i < stroke.poses.size(); ++i) document.apply(MoveBeam{stroke.poses[i]});
        document.apply(EndStroke{});
        while (document.waiting() > 0) ASSERT_TRUE(document.step(moves).ok());
      }
      if (hash == 0) hash = state_hash(document.world());
      EXPECT_EQ(state_hash(document.world()), hash) << moves << " moves a step";
    }
  }
}

TEST(CloseByWalls, replays_from_a_journal_and_continues_identically) {
  const TemporaryFolder folder;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Soup& soup = c.soup;
    const MeshView view{soup.positions, soup.triangles, {}, {}, {}, {}, {}};
    ASSERT_TRUE(write_mesh(view, folder / "part.obj", MeshFormat::kObj).ok());
    SceneDescription scene;
    scene.bodies.push_back(body_of_file(folder / "part.obj"));
    ASSERT_TRUE(record_hashes(scene).ok());
    const auto draw = [](Document& document, const SolidStroke& stroke) {
      document.apply(BeginStroke{stroke.settings, stroke.poses[0]});
      for (size_t i = 1; i < stroke.poses.size(); ++i) document.apply(MoveBeam{stroke.poses[i]});
      document.apply(EndStroke{});
      ASSERT_TRUE(run_all(document).ok());
    };
    auto loaded = load_scene(scene, nullptr);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    Document document(std::move(loaded->world));
    ASSERT_TRUE(document.apply(SetSolid{{document.world().ids().front(), 0}, true}).ok());
    for (const SolidStroke& stroke : c.strokes) draw(document, stroke);
    std::vector<StateMark> marks;
    mark_state(document, marks, true);
    ASSERT_TRUE(save_journal(folder / "part.kerf", scene, document.journal(), marks).ok());

    auto opened = open_journal(folder / "part.kerf", nullptr);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    Document again(std::move(opened->scene.world));
    Replay replay(opened->journal, again);
    QueueRun how;
    how.told = [](const Result<StepResult>&) -> Status { return Done{}; };
    ASSERT_TRUE(replay.run(how).ok());
    EXPECT_FALSE(replay.difference());
    EXPECT_EQ(state_hash(again.world()), state_hash(document.world()));
    for (Document* d : {&document, &again}) draw(*d, slot_at(-0.13));
    EXPECT_EQ(state_hash(again.world()), state_hash(document.world()));
  }
}

// A body that was open is cut as a sheet, and one of two parts does not keep the other from being closed.
TEST(CloseByWalls, keeps_sheets_open_and_closes_closed_parts_of_the_same_body) {
  Random random(1);
  Document document(world_of(both(grid(4, 1), ball(0.3, {0, 1, 0}))));
  ASSERT_TRUE(document.apply(SetSolid{{document.world().ids().front(), 0}, true}).ok());
  const SolidStroke stroke = slot_at(0.1);
  document.apply(BeginStroke{stroke.settings, stroke.poses[0]});
  document.apply(MoveBeam{stroke.poses[1]});
  document.apply(EndStroke{});
  const Result<StepResult> cut = run_all(document);
  ASSERT_TRUE(cut.ok());
  EXPECT_GT(cut->delta.solid.wall_faces, 0u);
  const Body& body = document.world().body(document.world().ids().front());
  std::vector<Mesh::Side> open;
  body.mesh.append_open_sides(open);
  for (const Mesh::Side& s : open) EXPECT_EQ(body.mesh.position(s.from).y, 0) << "an open side of the ball";
  EXPECT_FALSE(open.empty());
  ASSERT_NO_FATAL_FAILURE(expect_right_labels(body));
}

// A cavity that the beam did not touch belongs to the piece that is around it.
TEST(CloseByWalls, moves_cavities_with_the_piece_around_them) {
  for (const double z : {0.3, -0.3}) {
    SCOPED_TRACE(z);
    Random random(1);
    SolidCut cut(world_of(both(ball(0.5), inside_out(ball(0.1, {0, 0, z})))));
    ASSERT_TRUE(cut.draw(slot_at(0.1), random));
    const Body& body = cut.body();
    const std::vector<bool> closed = closed_pieces(body.mesh, body.pieces.size());
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      bool has_cavity = false, has_outside = false;
      for (const FaceId f : body.faces_of(label)) {
        const Triangle t = body.mesh.triangle(f);
        const bool of_cavity = glm::distance(t[0], Vec3(0, 0, z)) < 0.101;
        (of_cavity ? has_cavity : has_outside) = true;
        if (!of_cavity && has_cavity) EXPECT_EQ(t[0].z > 0.1, z > 0.1);
      }
      EXPECT_TRUE(!has_cavity || has_outside);
    }
  }
}

}  // namespace
}  // namespace kerf::test
