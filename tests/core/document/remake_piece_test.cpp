#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/document/document.h"
#include "core/document/extract.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/save.h"
#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "core/joints/joined_parts.h"
#include "core/mesh/measures.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"
#include "tests/support/features.h"
#include "tests/support/jointed.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/piece_sums.h"
#include "tests/support/same_world.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

// The three commands, for a piece with this many faces.
std::vector<Command> preparations(const PieceId& piece, size_t faces) {
  return {SimplifyPiece{piece, {.faces = faces / 3}},    SimplifyPiece{piece, {.error = 0.1}},
          SubdividePiece{piece, Subdivision::kLoop},     SubdividePiece{piece, Subdivision::kSqrt3},
          SubdividePiece{piece, Subdivision::kMidpoint}, SmoothPiece{piece, 3}};
}

PieceId only_piece(const World& world) { return {world.ids().front(), 0}; }

void expect_sound(const World& world) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    EXPECT_EQ(find_fault(body.mesh, true), "");
    EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
    expect_piece_sums(body);
  }
}

// A torus that a stroke has cut into two pieces at least.
World cut_torus() {
  World world;
  world.add(make_body("torus", build(torus(40, 24, 1, 0.3))));
  CutSettings settings;
  settings.laser.radius = 0.05;
  settings.laser.range = {0, 5};
  settings.resolution.target_edge = 0.05;
  EXPECT_TRUE(
      cut_whole(world, settings, subdivide({{{-2, 3, 0}, {0, -1, 0}}, {{2, 3, 0}, {0, -1, 0}}}, 0.05, 5))
          .ok());
  while (!is_settled(world)) continue_separation(world, 100'000);
  EXPECT_GE(world.live_pieces(), 2u);
  return world;
}

TEST(PrepareCommands, reorient_overlapping_shells_only) {
  const Soup ball = sphere(8, 12, 1), inner = moved(ball, {0.1, 0.05, 0}, 0.5);
  const World before = world_of(both(ball, inner));
  Document document(before);
  ASSERT_TRUE(document.apply(TurnShells{only_piece(before)}).ok());
  const Mesh &old = before.body(before.ids()[0]).mesh,
             &mesh = document.world().body(document.world().ids()[0]).mesh;
  ASSERT_EQ(mesh.live_faces(), old.live_faces());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const bool turned = f >= ball.triangles.size();
    const Triangle a = old.triangle(FaceId(f)), b = mesh.triangle(FaceId(f));
    const Vec3 normal = glm::cross(a[1] - a[0], a[2] - a[0]), now = glm::cross(b[1] - b[0], b[2] - b[0]);
    EXPECT_GT(glm::dot(turned ? -normal : normal, now), 0.99 * glm::dot(normal, normal));
  }
  expect_sound(document.world());
  const World after = document.world();
  const Outcome again = document.apply(TurnShells{only_piece(after)});
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(again.delta.empty()) << "they do not overlap now";
  ASSERT_TRUE(document.apply(Undo{}).ok());
  expect_same_world(document.world(), before);
  ASSERT_TRUE(document.apply(Redo{}).ok());
  expect_same_world(document.world(), after);
}

TEST(PrepareCommands, reorient_overlapping_shells_that_share_a_face) {
  const Soup block = brick({1, 1, 1}), wall = brick({4, 4, 4});
  const Soup soup = both(wall, both(moved(block, {1, 1.25, 1}, 1), moved(block, {1, 1.25, 2}, 1)));
  ASSERT_EQ(build(soup).report.warnings.size(), 1u) << "both blocks overlap with the outer part";
  Document document(world_of(soup));
  const auto enclosed = [&] {
    const World& world = document.world();
    return enclosed_volume(world.body(world.ids()[0]).mesh, {2, 2, 2});
  };
  EXPECT_NEAR(enclosed().volume, 66, 1e-9);
  ASSERT_TRUE(document.apply(TurnShells{only_piece(document.world())}).ok());
  EXPECT_TRUE(enclosed().closed);
  EXPECT_NEAR(enclosed().volume, 62, 1e-9);
  expect_sound(document.world());
  const Outcome again = document.apply(TurnShells{only_piece(document.world())});
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(again.delta.empty());
}

TEST(PrepareCommands, undo_and_redo_exactly) {
  const World before = world_of(in_two_materials(torus(30, 20, 1, 0.3)));
  for (const Command& command : preparations(only_piece(before), 1200)) {
    SCOPED_TRACE(command.index());
    Document document(before);
    const Outcome outcome = document.apply(command);
    ASSERT_TRUE(outcome.ok());
    EXPECT_EQ(outcome.delta.destroyed, before.ids());
    EXPECT_EQ(outcome.delta.created, document.world().ids());
    const World after = document.world();
    expect_sound(after);
    EXPECT_NE(state_hash(after), state_hash(before));
    ASSERT_TRUE(document.apply(Undo{}).ok());
    expect_same_world(document.world(), before);
    ASSERT_TRUE(document.apply(Redo{}).ok());
    expect_same_world(document.world(), after);
  }
}

TEST(PrepareCommands, turn_a_cut_off_piece_into_a_body_and_keep_the_others) {
  const World before = cut_torus();
  for (uint32_t label = 0; label < before.body(before.ids()[0]).pieces.size(); ++label) {
    const PieceId piece{before.ids()[0], label};
    const size_t faces = before.body(piece.body).pieces[label].faces;
    if (faces == 0) continue;
    for (const Command& command : preparations(piece, faces)) {
      SCOPED_TRACE("piece " + std::to_string(label) + ", " + std::to_string(command.index()));
      Document document(before);
      const Outcome outcome = document.apply(command);
      ASSERT_TRUE(outcome.ok()) << outcome.error().message;
      if (outcome.delta.empty()) continue;
      const World& world = document.world();
      expect_sound(world);
      ASSERT_EQ(world.ids().size(), 2u);
      const Body &rest = world.body(world.ids()[0]), &own = world.body(world.ids()[1]);
      EXPECT_EQ(rest.mesh.live_faces() + faces, before.live_faces());
      EXPECT_EQ(own.mesh.live_faces(), own.pieces[label].faces);
      EXPECT_EQ(own.name_of(label), before.body(piece.body).name_of(label));
      EXPECT_EQ(world.live_pieces(), before.live_pieces());
      ASSERT_TRUE(document.apply(Undo{}).ok());
      expect_same_world(document.world(), before);
    }
  }
}

TEST(PrepareCommands, produce_pieces_that_can_be_cut) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document document(cut_at_random(torus(30, 20, 1, 0.3), seed));
    for (const Command& command : preparations(only_piece(document.world()), 1000)) {
      const PieceId piece{document.world().ids().back(), 0};
      Command own = command;
      std::visit(
          [&](auto& c) {
            if constexpr (requires { c.piece; }) c.piece = piece;
          },
          own);
      if (document.world().live_faces() < 20'000 && has_faces(document.world(), piece))
        ASSERT_TRUE(document.apply(own).ok());
      World world = document.world();
      const RandomStroke stroke = random_stroke(world, random, 0.03, true);
      ASSERT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
      while (!is_settled(world)) continue_separation(world, 100'000);
      expect_sound(world);
    }
  }
}

TEST(PrepareCommands, replay_to_the_same_world) {
  const TemporaryFolder folder;
  const Soup soup = torus(20, 12, 1, 0.3);
  std::string obj;
  for (const Vec3& p : soup.positions)
    obj += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  for (const auto& t : soup.triangles) {
    obj += "f";
    for (const uint32_t v : t) obj += " " + std::to_string(v + 1);
    obj += "\n";
  }
  write_text(folder / "torus.obj", obj);
  SceneDescription scene;
  scene.bodies.push_back(body_of_file(folder / "torus.obj"));
  ASSERT_TRUE(record_hashes(scene).ok());
  auto loaded = load_scene(scene);
  ASSERT_TRUE(loaded.ok());
  Document document(std::move(loaded->world));
  const auto piece = [&] { return PieceId{document.world().ids().back(), 0}; };
  ASSERT_TRUE(document.apply(SubdividePiece{piece(), Subdivision::kLoop}).ok());
  ASSERT_TRUE(document.apply(SmoothPiece{piece(), 2}).ok());
  ASSERT_TRUE(document.apply(SimplifyPiece{piece(), {.faces = 900}}).ok());
  ASSERT_TRUE(document.apply(SimplifyPiece{piece(), {.error = 0.01}}).ok());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  ASSERT_TRUE(document.apply(SubdividePiece{piece(), Subdivision::kSqrt3}).ok());
  ASSERT_TRUE(save_journal(folder / "torus.kerf", scene, document.journal(), {}).ok());
  auto opened = open_journal(folder / "torus.kerf");
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  Document again(std::move(opened->scene.world));
  Replay replay(opened->journal, again);
  ASSERT_TRUE(replay.run({}).ok());
  expect_same_world(again.world(), document.world());
}

TEST(PrepareCommands, keep_materials_and_part_names) {
  const std::vector<NamedSheet> sheets{{"left", grid(8, 1), {-2, 0, 0}}, {"right", grid(8, 1), {2, 0, 0}}};
  Soup soup = assembled(sheets);
  soup = in_two_materials(std::move(soup));
  const World before = world_of(soup);
  for (const Command& command : preparations(only_piece(before), 256)) {
    SCOPED_TRACE(command.index());
    Document document(before);
    ASSERT_TRUE(document.apply(command).ok());
    const Body& body = document.world().body(document.world().ids()[0]);
    EXPECT_EQ(body.material_names, soup.material_names);
    ASSERT_EQ(body.named_parts.size(), 2u);
    size_t named = 0;
    for (const MeshPart& part : body.named_parts) {
      named += part.last - part.first;
      for (uint32_t f = part.first; f < part.last; ++f) {
        const Triangle t = body.mesh.triangle(FaceId(f));
        EXPECT_EQ(t[0].x < 0, part.name == "left");
        EXPECT_EQ(body.mesh.data(FaceId(f)).material, t[0].x < 0 ? 0 : 1);
      }
    }
    EXPECT_EQ(named, body.mesh.live_faces());
    EXPECT_EQ(body.components.left.size(), 2u);
  }
}

TEST(PrepareCommands, keep_the_energy_of_faces) {
  World before = cut_torus();
  Body& body = before.body(before.ids()[0]);
  Random random(5);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f))) body.heat.set_energy(body.mesh, FaceId(f), random.uniform(0, 10));
  }
  const auto stored = [](const World& world) {
    double sum = 0;
    for (const BodyId id : world.ids()) sum += world.body(id).heat.stored(world.body(id).mesh);
    return sum;
  };
  const double joules = stored(before);
  for (const Command& command : preparations(only_piece(before), body.pieces[0].faces)) {
    SCOPED_TRACE(command.index());
    Document document(before);
    ASSERT_TRUE(document.apply(command).ok());
    EXPECT_NEAR(stored(document.world()), joules, 1e-9 * joules);
  }
}

// What was hot on a sheet from (-0.5, 0, -0.5) to (0.5, 0, 0.5): within `width` of its middle, or of the side
// on which x is least.
struct OnceHot {
  bool at_side;
  double width, hottest;

  double distance(const Triangle& t) const {
    if (!at_side) return std::sqrt(squared_distance(Vec3(0), t));
    return std::min({t[0].x, t[1].x, t[2].x}) + 0.5;
  }
  World world() const {
    World world = world_of(grid(40, 1));
    Body& body = world.body(world.ids()[0]);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      const Triangle t = body.mesh.triangle(FaceId(f));
      const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
      if (distance({middle, middle, middle}) < width) body.heat.record_hottest(body.mesh, FaceId(f), hottest);
    }
    return world;
  }
};

// The highest temperatures over the ambient, integrated over the area (K m^2).
double tint_of(const World& world) {
  const Body& body = world.body(world.ids()[0]);
  double sum = 0;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const double rise = body.heat.hottest_of(body.mesh, FaceId(f)) - kAmbient;
    sum += rise * triangle_area(body.mesh.triangle(FaceId(f)));
  }
  return sum;
}

TEST(PrepareCommands, spread_no_trace_of_heat_to_cold_faces) {
  for (const OnceHot& hot : {OnceHot{false, 0.08, 1200}, OnceHot{false, 0.15, 1200}, OnceHot{false, 0.3, 700},
                             OnceHot{true, 0.03, 1200}, OnceHot{true, 0.1, 1200}}) {
    const World before = hot.world();
    for (const Command& command : preparations(only_piece(before), 3200)) {
      SCOPED_TRACE((hot.at_side ? "side, " : "middle, ") + std::to_string(hot.width) + ", command " +
                   std::to_string(command.index()));
      Document document(before);
      ASSERT_TRUE(document.apply(command).ok());
      const Body& body = document.world().body(document.world().ids()[0]);
      EXPECT_LE(tint_of(document.world()), tint_of(before) * (1 + 1e-6));
      EXPECT_GE(tint_of(document.world()), tint_of(before) * 0.5);
      for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
        const double hottest = body.heat.hottest_of(body.mesh, FaceId(f));
        ASSERT_LE(hottest, hot.hottest + 1e-3) << f;
        if (hot.distance(body.mesh.triangle(FaceId(f))) > hot.width + 0.05)
          ASSERT_LT(hottest, kAmbient + 1e-3) << f;
      }
    }
  }
}

// A sheet and a door beside it, which a hinge holds at their common edge.
World door() {
  JointDescription hinge;
  hinge.kind = Joint::Kind::kHinge;
  hinge.parts = {"door", "frame"};
  hinge.anchor = {0.5, 0, 0};
  hinge.axis = {0, 0, 1};
  hinge.radius = 0.2;
  const std::vector<NamedSheet> sheets{{"frame", rectangle(1, 1, 20)},
                                       {"door", rectangle(1, 1, 20), {1.02, 0, 0}}};
  return jointed_world(sheets, {&hinge, 1});
}

TEST(PrepareCommands, keep_the_joints_of_a_piece_intact) {
  const World before = door();
  ASSERT_EQ(held_joints(before).size(), 1u);
  for (const Command& command : preparations(only_piece(before), 1600)) {
    SCOPED_TRACE(command.index());
    Document document(before);
    ASSERT_TRUE(document.apply(command).ok());
    World world = document.world();
    const auto held = held_joints(world);
    ASSERT_EQ(held.size(), 1u);
    EXPECT_NE(held[0].parts[0].component, held[0].parts[1].component);
    EXPECT_EQ(part_bodies(world).size(), 2u);
    ASSERT_TRUE(document.apply(Undo{}).ok());
    expect_same_world(document.world(), before);
    EXPECT_EQ(held_joints(document.world()).size(), 1u);
  }
}

TEST(PrepareCommands, reject_a_piece_joined_to_a_moving_body) {
  World world = door();
  ASSERT_EQ(part_bodies(world).size(), 2u);
  for (const BodyId id : world.ids()) {
    for (uint32_t label = 0; label < world.body(id).pieces.size(); ++label) {
      if (world.body(id).pieces[label].faces == 0) continue;
      Document document(world);
      const Outcome outcome = document.apply(SmoothPiece{{id, label}, 1});
      ASSERT_FALSE(outcome.ok());
      EXPECT_NE(outcome.error().message.find("is joined to a piece"), std::string::npos);
      expect_same_world(document.world(), world);
    }
  }
}

TEST(PrepareCommands, change_nothing_if_cancelled_or_without_effect) {
  const World before = world_of(sphere(20, 30, 1));
  for (const Command& command : preparations(only_piece(before), 1100)) {
    SCOPED_TRACE(command.index());
    int reports = 0;
    const Progress counted{[&](double fraction) {
      EXPECT_LE(fraction, 1.0);
      return ++reports > 0;
    }};
    Document all(before);
    ASSERT_TRUE(all.apply(command, &counted).ok());
    EXPECT_GT(reports, 4);
    for (int most = 0; most < reports; most += reports / 8 + 1) {
      Document document(before);
      int calls = 0;
      const Progress stop{[&](double) { return calls++ < most; }};
      const Outcome outcome = document.apply(command, &stop);
      ASSERT_FALSE(outcome.ok());
      EXPECT_EQ(outcome.error().message, cancelled().message);
      expect_same_world(document.world(), before);
      EXPECT_EQ(document.history().size(), 0u);
    }
  }
  Document document(before);
  const Outcome nothing = document.apply(SimplifyPiece{only_piece(before), {.faces = 5000}});
  EXPECT_TRUE(nothing.ok() && nothing.delta.empty());
  EXPECT_TRUE(document.journal().empty());
  EXPECT_FALSE(document.apply(SmoothPiece{{{9, 0}, 0}, 1}).ok());
}

}  // namespace
}  // namespace kerf::test
