#include "core/document/document.h"

#include <gtest/gtest.h>

#include <set>

#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

CutSettings settings_of(double radius) {
  CutSettings s;
  s.laser.radius = radius;
  s.resolution.target_edge = radius / 2;
  return s;
}

TEST(Document, replays_its_journal_to_the_same_world) {
  Document first(world_of(torus(16, 10, 0.5, 0.2)));
  first.apply(BeginStroke{settings_of(0.02), {{-0.8, 1, 0.1}, {0, -1, 0}}});
  while (first.waiting() > 0) ASSERT_TRUE(first.step(1).ok());
  for (int i = 1; i <= 10; ++i) {
    first.apply(MoveBeam{{{-0.8 + 0.16 * i, 1, 0.1}, glm::normalize(Vec3(0.02 * i, -1, 0.01 * i))}});
    while (first.waiting() > 0) ASSERT_TRUE(first.step(3).ok());
  }
  first.apply(EndStroke{});

  Document second(world_of(torus(16, 10, 0.5, 0.2)));
  for (const Command& command : first.journal()) ASSERT_TRUE(second.apply(command).ok());
  ASSERT_TRUE(run_all(second).ok());
  EXPECT_EQ(state_hash(first.world()), state_hash(second.world()));
  EXPECT_LT(first.world().live_faces(), 1u << 20);
  EXPECT_GT(first.world().live_pieces(), 0u);
}

TEST(Document, recut_matches_a_stroke_drawn_with_the_same_settings) {
  const auto draw = [](Document& document, double radius, double z) {
    document.apply(BeginStroke{settings_of(radius), {{-0.8, 1, z}, {0, -1, 0}}});
    document.apply(MoveBeam{{{0.8, 1, z + 0.03}, {0, -1, 0}}});
    document.apply(EndStroke{});
    ASSERT_TRUE(run_all(document).ok());
  };
  Document recut(world_of(sphere(12, 16, 0.5))), drawn(world_of(sphere(12, 16, 0.5)));
  EXPECT_FALSE(can_recut(recut));
  draw(recut, 0.02, 0.1);
  draw(recut, 0.01, -0.1);
  for (const double radius : {0.03, 0.015}) {
    ASSERT_TRUE(can_recut(recut));
    ASSERT_TRUE(recut.apply(Recut{settings_of(radius)}).ok());
    ASSERT_TRUE(run_all(recut).ok());
  }
  draw(drawn, 0.02, 0.1);
  draw(drawn, 0.015, -0.1);
  EXPECT_EQ(state_hash(recut.world()), state_hash(drawn.world()));
  EXPECT_EQ(recut.history().totals().strokes, 2u);
}

TEST(Document, the_same_pieces_come_off_for_any_distribution_of_moves) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<std::vector<size_t>> faces_of_pieces;
    for (const size_t moves : {1u, 3u, 16u, 100'000u}) {
      Random random(seed);
      Document document(world_of(torus(24, 16, 0.5, 0.2)));
      for (int stroke = 0; stroke < 3; ++stroke) {
        const auto pose = [&] {
          return Pose{{random.uniform(-0.6, 0.6), 1, random.uniform(-0.6, 0.6)}, {0, -1, 0}};
        };
        document.apply(BeginStroke{settings_of(0.02), pose()});
        for (int i = 0; i < 5; ++i) document.apply(MoveBeam{pose()});
        document.apply(EndStroke{});
        while (document.waiting() > 0) ASSERT_TRUE(document.step(moves).ok());
      }
      std::vector<size_t>& faces = faces_of_pieces.emplace_back();
      for (const BodyId id : document.world().ids()) {
        const auto& pieces = document.world().body(id).pieces;
        for (uint32_t p = 0; p < pieces.size(); ++p) faces.push_back(pieces[p].faces);
      }
    }
    EXPECT_GT(faces_of_pieces.front().size(), 3u) << "seed " << seed;
    for (const auto& faces : faces_of_pieces) EXPECT_EQ(faces, faces_of_pieces.front()) << "seed " << seed;
  }
}

// Two strokes, the first of which takes so much away that the world gets smaller.
uint64_t hash_of_wide_strokes(uint64_t seed, bool walk_between) {
  Random random(seed);
  Document document(world_of(sphere(36, 70, 0.25)));
  const auto pose = [&] {
    const double x = random.uniform(-0.45, 0.45), z = random.uniform(-0.45, 0.45);
    const double u = random.uniform(-0.6, 0.6), v = random.uniform(-0.6, 0.6);
    return Pose{{x, 0.26, z}, glm::normalize(Vec3(u, -1, v))};
  };
  const auto run_all = [&] {
    while (document.waiting() > 0) EXPECT_TRUE(document.step(64).ok());
  };
  for (const double radius : {0.17, 0.015}) {
    CutSettings settings = settings_of(radius);
    settings.resolution.rule = Resolution::Rule::kDepth;
    settings.resolution.depth = radius < 0.1 ? 2 : 0;
    document.apply(BeginStroke{settings, pose()});
    for (int i = 0; i < (radius < 0.1 ? 6 : 3); ++i) {
      if (walk_between) run_all();
      document.apply(MoveBeam{pose()});
    }
    if (walk_between) run_all();
  }
  document.apply(EndStroke{});
  run_all();
  return state_hash(document.world());
}

TEST(Document, a_move_is_divided_identically_at_any_progress_of_the_cut) {
  // At 75 the world gets so much smaller that moves cut up by its size would be others.
  for (uint64_t seed = 73; seed <= 78; ++seed)
    EXPECT_EQ(hash_of_wide_strokes(seed, true), hash_of_wide_strokes(seed, false)) << "seed " << seed;
}

// The search for what came apart goes on from move to move, and takes longer than one: a user who draws
// slowly and one whose moves wait get the same pieces under the same labels, and so does whoever replays the
// journal.
TEST(Document, labels_do_not_depend_on_when_the_queue_runs) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    CutSettings settings = settings_of(0.03);
    settings.search_a_move = 1 + random.below(40);
    settings.resolution.rim = random.below(2) == 0 ? Rim::kSmooth : Rim::kFaces;
    std::vector<Document> documents;
    for (int i = 0; i < 3; ++i) documents.emplace_back(world_of(torus(32, 20, 0.5, 0.2)));
    const auto apply = [&](const Command& command) {
      for (Document& document : documents) ASSERT_TRUE(document.apply(command).ok());
      ASSERT_TRUE(run_all(documents[1]).ok());
      ASSERT_TRUE(documents[2].step(random.below(4)).ok());
    };
    // To and fro, so that what came off is cut again while the search for it goes on.
    const auto pose = [&](int i) {
      const double x = 0.4 * (i % 4) - 0.6 + random.uniform(-0.02, 0.02);
      return Pose{{x, 1, i / 2 % 2 == 0 ? 0.8 : -0.8}, {0, -1, 0}};
    };
    apply(BeginStroke{settings, pose(0)});
    for (int i = 1; i < 16; ++i) apply(MoveBeam{pose(i)});
    apply(EndStroke{});
    for (Document& document : documents) ASSERT_TRUE(run_all(document).ok());
    EXPECT_GT(documents[0].world().live_pieces(), 3u);
    expect_same_world(documents[0].world(), documents[1].world());
    expect_same_world(documents[0].world(), documents[2].world());
    if (HasFailure()) return;
  }
}

TEST(Document, a_failed_stroke_does_not_affect_the_next_one) {
  CutSettings too_fine = settings_of(0.02);
  too_fine.max_faces = 40;
  too_fine.faces_per_step = 1;
  const auto strokes = [&](Document& document, bool step_between) {
    for (const double z : {0.2, -0.2}) {
      document.apply(BeginStroke{z > 0 ? too_fine : settings_of(0.02), {{-0.7, 1, z}, {0, -1, 0}}});
      document.apply(MoveBeam{{{0.7, 1, z}, {0, -1, 0}}});
      document.apply(EndStroke{});
      while (step_between && document.waiting() > 0) (void)document.step(4).ok();
    }
    while (document.waiting() > 0) (void)document.step(4).ok();
  };
  Document one(world_of(plate(1))), other(world_of(plate(1)));
  strokes(one, true);
  strokes(other, false);
  EXPECT_EQ(state_hash(one.world()), state_hash(other.world()));
  EXPECT_GT(one.world().live_faces(), 200u);
}

TEST(Document, a_failed_stroke_is_not_retried_by_redo) {
  CutSettings too_fine = settings_of(0.02);
  too_fine.max_faces = 40;
  Document document(world_of(plate(1)));
  const uint64_t whole = state_hash(document.world());
  document.apply(BeginStroke{too_fine, {{-0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(EndStroke{});
  EXPECT_FALSE(run_all(document).ok());
  EXPECT_TRUE(document.history().last().done());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  ASSERT_TRUE(document.apply(Redo{}).ok());
  EXPECT_EQ(document.history().position(), 1u);
  EXPECT_EQ(document.waiting(), 0u);
  EXPECT_EQ(state_hash(document.world()), whole);
}

// The oldest images are discarded, so an undo replays the strokes before.
TEST(Document, an_undo_by_a_replay_passes_a_failed_stroke) {
  Document document(world_of(plate(1)), [](const Progress*) { return Result<World>(world_of(plate(1))); });
  CutSettings too_fine = settings_of(0.02);
  too_fine.max_faces = 40;
  uint64_t cut = 0;
  for (const double z : {0.2, 0.0, -0.2}) {
    cut = state_hash(document.world());
    document.apply(BeginStroke{z > 0 ? too_fine : settings_of(0.02), {{-0.7, 1, z}, {0, -1, 0}}});
    document.apply(MoveBeam{{{0.7, 1, z}, {0, -1, 0}}});
    document.apply(EndStroke{});
    while (document.waiting() > 0) (void)document.step(4).ok();
  }
  document.set_window(1);
  ASSERT_FALSE(document.history().holds_images(2, 3));
  const Outcome undone = document.apply(Undo{});
  ASSERT_TRUE(undone.ok()) << undone.error().message;
  EXPECT_EQ(document.history().position(), 2u);
  EXPECT_EQ(state_hash(document.world()), cut);
}

TEST(Document, a_failed_recut_removes_nothing) {
  Document document(world_of(plate(1)));
  document.apply(BeginStroke{settings_of(0.02), {{-0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
  const uint64_t cut = state_hash(document.world());
  const double removed = document.history().totals().removed_area;
  CutSettings too_fine = settings_of(0.02);
  too_fine.max_faces = 40;
  document.apply(Recut{too_fine});
  while (document.waiting() > 0) (void)document.step(4).ok();
  EXPECT_EQ(document.history().totals().removed_area, 0);
  EXPECT_NEAR(live_area(document.world().body(document.world().ids()[0]).mesh), 1, 1e-12);
  document.apply(Undo{});
  EXPECT_EQ(state_hash(document.world()), cut);
  EXPECT_EQ(document.history().totals().removed_area, removed);
}

TEST(Document, the_rest_of_a_failed_stroke_is_cut_the_same_at_any_failure_time) {
  std::array<Document, 2> documents{Document(world_of(plate(1))), Document(world_of(plate(1)))};
  CutSettings too_fine = settings_of(0.02);
  too_fine.max_faces = 40;
  const auto drain = [](Document& document) {
    while (document.waiting() > 0) (void)document.step(4).ok();
  };
  for (Document& document : documents) {
    const bool immediate = &document == &documents[0];
    document.apply(BeginStroke{too_fine, {{-0.3, 1, 0.2}, {0, -1, 0}}});
    if (immediate) drain(document);
    for (const double x : {0.0, 0.3}) document.apply(MoveBeam{{{x, 1, 0.2}, {0, -1, 0}}});
    document.apply(EndStroke{});
    drain(document);
    EXPECT_EQ(document.history().totals().removed_area, 0);
    document.apply(Recut{settings_of(0.02)});
    EXPECT_TRUE(run_all(document).ok());
    EXPECT_GT(document.history().totals().removed_area, 0.6 * 0.04);
  }
  EXPECT_EQ(documents[0].journal().size(), documents[1].journal().size());
  EXPECT_EQ(state_hash(documents[0].world()), state_hash(documents[1].world()));
}

// The live faces of the only body.
std::set<FaceId> live_faces(const World& world) {
  const Mesh& mesh = world.body(world.ids()[0]).mesh;
  std::set<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) faces.insert(FaceId(f));
  }
  return faces;
}

// The same as somebody knows them who follows deltas.
void follow(std::set<FaceId>& faces, const World& world, const Delta& delta) {
  if (delta.replaced) faces = live_faces(world);
  for (const BodyDelta& body : delta.bodies) {
    for (const FaceId f : body.dead) faces.erase(f);
    faces.insert(body.added.begin(), body.added.end());
  }
}

TEST(Document, a_failed_command_reports_changes_of_earlier_strokes) {
  for (const bool too_fine : {false, true}) {
    Document document(world_of(plate(1)));
    std::set<FaceId> known = live_faces(document.world());
    const auto draw = [&](double z, size_t max_faces) {
      CutSettings settings = settings_of(0.02);
      settings.max_faces = max_faces;
      document.apply(BeginStroke{settings, {{-0.7, 1, z}, {0, -1, 0}}});
      document.apply(MoveBeam{{{0.7, 1, z}, {0, -1, 0}}});
    };
    draw(0.2, CutSettings{}.max_faces);
    if (too_fine) draw(-0.2, 40);
    const size_t before = document.world().live_faces();
    const Outcome outcome = document.apply(MovePiece{{{7, 0}, 1}, {}});
    ASSERT_FALSE(outcome.ok());
    EXPECT_FALSE(document.queue().in_stroke());
    EXPECT_GT(document.world().live_faces(), before + 50);
    EXPECT_FALSE(outcome.delta.empty());
    follow(known, document.world(), outcome.delta);
    EXPECT_EQ(known, live_faces(document.world()));
    EXPECT_EQ(document.history().size(), too_fine ? 2u : 1u);
  }
}

TEST(Document, a_recut_reports_restored_faces) {
  Document document(world_of(plate(1)));
  document.apply(BeginStroke{settings_of(0.02), {{-0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
  std::set<FaceId> known = live_faces(document.world());
  const Outcome outcome = document.apply(Recut{settings_of(0.03)});
  ASSERT_TRUE(outcome.ok());
  EXPECT_NE(known, live_faces(document.world()));
  follow(known, document.world(), outcome.delta);
  EXPECT_EQ(known, live_faces(document.world()));
}

// Without before-images an edit is undone by a replay and redone by its execution.
TEST(Document, a_redo_without_images_reports_its_changes) {
  Document document(world_of(plate(1)), [](const Progress*) { return Result<World>(world_of(plate(1))); });
  document.set_window(0);
  const PieceId piece{document.world().ids().front(), 0};
  ASSERT_TRUE(document.apply(SubdividePiece{piece, Subdivision::kMidpoint}).ok());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  const Outcome outcome = document.apply(Redo{});
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome.delta.created, document.world().ids());
}

TEST(Document, a_failed_history_jump_reports_how_far_it_got) {
  const auto file = std::filesystem::path(testing::TempDir()) / "kerf-journey.obj";
  std::filesystem::copy_file(checkout() / "assets/meshes/sphere.obj", file,
                             std::filesystem::copy_options::overwrite_existing);
  Document document(world_of(plate(1)), [](const Progress*) { return Result<World>(world_of(plate(1))); });
  document.set_window(0);
  document.apply(BeginStroke{settings_of(0.02), {{-0.7, 1, 0.2}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.7, 1, 0.2}, {0, -1, 0}}});
  ASSERT_TRUE(document.apply(AddMesh{file, "sphere"}).ok());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  std::set<FaceId> known = live_faces(document.world());
  std::filesystem::remove(file);
  const Outcome outcome = document.travel(2);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(document.history().position(), 1u);
  follow(known, document.world(), outcome.delta);
  EXPECT_EQ(known, live_faces(document.world()));
}

TEST(Document, ignores_moves_outside_a_stroke) {
  Document document(world_of(plate(1)));
  document.apply(MoveBeam{{{0, 1, 0}, {0, -1, 0}}});
  EXPECT_EQ(document.waiting(), 0u);
  document.apply(BeginStroke{settings_of(0.02), {{0, 1, 0}, {0, -1, 0}}});
  document.apply(EndStroke{});
  document.apply(MoveBeam{{{0.3, 1, 0}, {0, -1, 0}}});
  EXPECT_EQ(document.waiting(), 1u);
}

TEST(Document, cuts_through_all_bodies) {
  World world;
  world.add(make_body("upper", build(plate(1))));
  world.add(make_body("lower", build(moved(plate(1), {0, -0.3, 0}, 1))));
  Document document(std::move(world));
  document.apply(BeginStroke{settings_of(0.02), {{-0.7, 1, 0.1}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.7, 1, 0.12}, {0, -1, 0}}});
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_EQ(document.world().live_pieces(), 4u);
}

}  // namespace
}  // namespace kerf::test
