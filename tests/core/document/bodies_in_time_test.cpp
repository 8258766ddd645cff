#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

constexpr double kSecond = 1.0 / static_cast<double>(kTicksPerSecond);

CutSettings settings() {
  CutSettings s;
  s.laser.radius = 0.01;
  s.resolution.target_edge = 0.02;
  return s;
}

// A stroke straight down along x, at z, over everything.
std::vector<Command> stroke_at(double z) {
  const Vec3 down(0, -1, 0);
  return {BeginStroke{settings(), {{-2, 3, z}, down}}, MoveBeam{{{2, 3, z}, down}}, EndStroke{}};
}

class BodiesInTime : public testing::Test {
 protected:
  static World made_world() {
    World world;
    add(world, rectangle(1, 1, 8), {0, 0.5, 0});
    world.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
    return world;
  }
  void apply(const Command& command) { ASSERT_TRUE(document_.apply(command).ok()); }
  void cut(double z) {
    for (const Command& c : stroke_at(z)) apply(c);
  }
  void fall(Ticks ticks) { document_.apply(AdvanceTime{ticks, true}); }
  void run() { ASSERT_TRUE(run_all(document_).ok()); }
  // A stroke and 50 ticks, with a mark at their end.
  Journal cut_and_fallen() {
    cut(0.1);
    apply(Play{});
    fall(50);
    run();
    Journal journal;
    journal.commands = document_.journal();
    mark_state(document_, journal.marks, true);
    return journal;
  }
  const World& world() const { return document_.world(); }
  Vec3 centre(BodyId id) const {
    const Body& body = world().body(id);
    return body.placement.to_world(rigid_frame(body).centre);
  }

  Document document_{made_world()};
};

TEST_F(BodiesInTime, pieces_are_not_detached_without_physics) {
  cut(0.1);
  document_.apply(AdvanceTime{30});
  run();
  EXPECT_EQ(world().ids().size(), 1u);
  EXPECT_EQ(world().live_pieces(), 2u);
}

TEST_F(BodiesInTime, pieces_fall_as_far_as_free_bodies) {
  cut(0.1);
  run();
  apply(Play{});
  constexpr Ticks kTicks = 24;
  fall(kTicks);
  run();
  ASSERT_EQ(world().ids().size(), 2u);
  EXPECT_EQ(world().clock(), kTicks);
  // Each tick adds to the velocity before it moves the body.
  const double way = 0.5 * 9.81 * kSecond * kSecond * static_cast<double>(kTicks * (kTicks + 1));
  for (const BodyId id : world().ids()) EXPECT_NEAR(centre(id).y, 0.5 - way, 0.01 * way);
}

TEST_F(BodiesInTime, pieces_separate_slowly_and_keep_their_common_centre) {
  apply(SetEnvironment{{.gravity = Vec3(0), .ground = std::nullopt}});
  cut(0.1);
  run();
  apply(Play{});
  fall(1);
  run();
  Vec3 momentum(0);
  std::vector<Vec3> velocities;
  for (const BodyId id : world().ids()) {
    velocities.push_back(world().body(id).motion.velocity);
    momentum += rigid_frame(world().body(id)).mass * velocities.back();
  }
  ASSERT_EQ(velocities.size(), 2u);
  const double apart = glm::length(velocities[1] - velocities[0]);
  EXPECT_GT(apart, 0.01);
  EXPECT_LT(apart, 0.05);
  EXPECT_LT(glm::length(momentum), 1e-9);
}

TEST_F(BodiesInTime, a_pinned_plate_stays_and_pieces_cut_off_it_fall) {
  apply(PinPiece{{world().ids().front(), 0}, true});
  apply(Play{});
  fall(10);
  run();
  const BodyId plate = world().ids().front();
  EXPECT_EQ(world().body(plate).placement.position.y, 0.5);
  cut(0.3);
  fall(60);
  run();
  ASSERT_EQ(world().ids().size(), 2u);
  EXPECT_EQ(world().body(plate).placement.position.y, 0.5);
  EXPECT_FALSE(world().body(world().ids().back()).pinned);
  EXPECT_LT(world().body(world().ids().back()).placement.position.y, 0.3);
}

TEST_F(BodiesInTime, a_body_that_loses_its_support_wakes_and_falls) {
  World table;
  const BodyId top = add(table, rectangle(1, 1, 8), {0, 0.5, 0});
  table.body(top).pinned = true;
  const BodyId box = add(table, closed_box({0.2, 0.1, 0.2}), {0, 0.57, 0.3});
  table.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
  document_ = Document(std::move(table));
  apply(Play{});
  fall(240);
  run();
  ASSERT_TRUE(world().body(box).motion.asleep);
  ASSERT_GT(centre(box).y, 0.5);
  cut(0.1);  // the smaller part, under the box, comes off
  fall(240);
  run();
  EXPECT_LT(centre(box).y, 0.3);
}

TEST_F(BodiesInTime, moving_a_body_by_hand_stops_it_and_wakes_bodies_resting_on_it) {
  World pile;
  const BodyId low = add(pile, closed_box({0.5, 0.2, 0.5}), {0, 0.1, 0});
  const BodyId high = add(pile, closed_box({0.3, 0.2, 0.3}), {0, 0.31, 0});
  pile.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
  document_ = Document(std::move(pile));
  apply(Play{});
  fall(240);
  run();
  ASSERT_TRUE(world().body(high).motion.asleep);
  apply(MovePiece{{low, 0}, {{3, 0.1, 0}, {1, 0, 0, 0}}});
  fall(120);
  run();
  EXPECT_LT(centre(high).y, 0.12);
  EXPECT_NEAR(centre(low).x, 3, 0.01);
}

TEST_F(BodiesInTime, one_undo_entry_spans_play_to_pause_and_each_stroke_has_its_own) {
  apply(Play{});
  fall(10);
  fall(10);
  cut(0.1);
  fall(10);
  run();
  EXPECT_EQ(document_.history().position(), 2u);
  const uint64_t end = state_hash(world());
  apply(Undo{});
  EXPECT_EQ(world().clock(), 20u);
  EXPECT_EQ(world().ids().size(), 1u);
  apply(Undo{});
  EXPECT_EQ(world().clock(), 0u);
  EXPECT_EQ(state_hash(world()), state_hash(made_world()));
  apply(Redo{});
  apply(Redo{});
  EXPECT_EQ(state_hash(world()), end);
}

TEST_F(BodiesInTime, undo_of_time_reports_merged_bodies) {
  cut(0.1);
  run();
  const BodyId plate = world().ids().front();
  apply(Play{});
  fall(1);
  run();
  ASSERT_EQ(world().ids().size(), 2u);
  const BodyId piece = world().ids().back();
  const Outcome outcome = document_.apply(Undo{});
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(world().ids(), std::vector{plate});
  EXPECT_EQ(outcome.delta.destroyed, std::vector{piece});
  ASSERT_EQ(outcome.delta.detached.size(), 1u);
  EXPECT_EQ(outcome.delta.detached[0].from, piece);
  EXPECT_EQ(outcome.delta.detached[0].to, plate);
}

TEST_F(BodiesInTime, replay_of_the_journal_is_bit_identical) {
  apply(Play{});
  fall(20);
  cut(0.1);
  fall(30);
  cut(-0.2);
  fall(100);
  apply(Undo{});
  cut(0.3);
  fall(200);
  run();
  Document again(made_world());
  for (const Command& c : document_.journal()) {
    ASSERT_TRUE(again.apply(c).ok());
    again.seal_journal();
    ASSERT_TRUE(run_all(again).ok());
  }
  expect_same_world(again.world(), world());
}

// A journal that is replayed to its end, made on another machine or not. The journal must outlive it.
struct Replayed {
  Replayed(Journal& journal, bool other, World world)
      : document(std::move(world)), replay(on_machine(journal, other), document) {
    EXPECT_TRUE(replay.run({}));
    EXPECT_EQ(replay.difference().has_value(), !other);
  }
  static const Journal& on_machine(Journal& journal, bool other) {
    if (other) journal.marks[0].machine = "another one";
    return journal;
  }

  Document document;
  Replay replay;
};

// A stroke that was drawn while they moved cuts other faces there.
TEST_F(BodiesInTime, replay_from_another_machine_accepts_different_cuts) {
  Journal journal = cut_and_fallen();
  journal.marks[0].hash += 1;
  for (const bool other : {false, true}) {
    const Replayed again(journal, other, made_world());
    EXPECT_EQ(again.replay.cut_otherwise(), other);
  }
}

// The same commands, but a mark of a machine on which the bodies came elsewhere.
TEST_F(BodiesInTime, replay_from_another_machine_restores_body_poses) {
  Journal journal = cut_and_fallen();
  ASSERT_EQ(journal.marks.size(), 1u);
  ASSERT_EQ(journal.marks[0].bodies.size(), 2u);
  World there = world();
  for (BodyState& state : journal.marks[0].bodies) {
    state.placement.position.x += 0.001;
    state.motion.velocity.y *= 1.001;
    there.body(state.id).placement = state.placement;
    there.body(state.id).motion = state.motion;
  }
  journal.marks[0].hash = state_hash(there);
  for (const bool other : {false, true}) {
    Replayed again(journal, other, made_world());
    EXPECT_EQ(again.replay.other_machine(), other ? "another one" : "");
    EXPECT_FALSE(again.replay.cut_otherwise());
    EXPECT_EQ(state_hash(again.document.world()), state_hash(other ? there : world()));
    ASSERT_TRUE(again.document.apply(Undo{}).ok());
    ASSERT_TRUE(again.document.apply(Undo{}).ok());
    EXPECT_EQ(state_hash(again.document.world()), state_hash(made_world()));
  }
}

TEST_F(BodiesInTime, replay_reports_a_mark_with_bodies_before_the_first_command) {
  Journal journal;
  StateMark& mark = journal.marks.emplace_back();
  mark.hash = state_hash(world()) + 1;
  mark.machine = "another one";
  mark.bodies.push_back({world().ids().front(), {{0, 1, 0}}, {}});
  Document again(made_world());
  Replay replay(journal, again);
  EXPECT_TRUE(replay.run({}));
  EXPECT_TRUE(replay.difference());
  EXPECT_EQ(replay.other_machine(), "");
  EXPECT_EQ(state_hash(again.world()), state_hash(world()));
}

TEST_F(BodiesInTime, replay_from_another_machine_restores_a_body_that_was_pinned_after_it_fell) {
  const BodyId plate = world().ids().front();
  apply(Play{});
  fall(50);
  run();
  apply(PinPiece{{plate, 0}});
  Journal journal;
  journal.commands = document_.journal();
  mark_state(document_, journal.marks, true);
  ASSERT_EQ(journal.marks.size(), 1u);
  ASSERT_EQ(journal.marks[0].bodies.size(), 1u);
  journal.marks[0].bodies[0].placement.position.x += 0.001;
  World there = world();
  there.body(plate).placement = journal.marks[0].bodies[0].placement;
  journal.marks[0].hash = state_hash(there);
  const Replayed again(journal, true, made_world());
  EXPECT_EQ(again.replay.other_machine(), "another one");
  EXPECT_FALSE(again.replay.cut_otherwise());
  EXPECT_EQ(state_hash(again.document.world()), state_hash(there));
}

TEST_F(BodiesInTime, save_points_with_bodies_round_trip_exactly) {
  cut(0.1);
  apply(Play{});
  fall(50);
  run();
  std::vector<StateMark> marks;
  mark_state(document_, marks, true);
  const TemporaryFolder folder;
  const auto lines = journal_lines(document_.journal(), marks, folder.path());
  ASSERT_TRUE(lines);
  write_text(
      folder / "fall.kerf",
      std::string(R"({"kerf":"journal","format":1,"program":"0.2.0","bodies":[{"mesh":"plate.obj"}]})") +
          '\n' + *lines);
  const auto read = read_journal(folder / "fall.kerf");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->damage, "");
  ASSERT_EQ(read->marks.size(), 1u);
  EXPECT_EQ(read->marks[0].machine, marks[0].machine);
  EXPECT_EQ(read->marks[0].bodies, marks[0].bodies);
  EXPECT_FALSE(marks[0].pairs.empty());
  EXPECT_EQ(read->marks[0].pairs, marks[0].pairs);
  EXPECT_EQ(read->marks[0].clock, 50u);
}

TEST_F(BodiesInTime, a_spring_follows_a_piece_that_an_edit_detaches) {
  const BodyId plate = world().ids().front();
  cut(0.1);
  document_.apply(DragBody{{plate, 1}, {0, 0, 0.3}, {0, 1, 0.3}});
  run();
  ASSERT_EQ(world().spring()->piece, (PieceId{plate, 1}));
  apply(MovePiece{{plate, 1}, {{0, 0.7, 0}, {1, 0, 0, 0}}});
  ASSERT_EQ(world().ids().size(), 2u);
  EXPECT_EQ(world().spring()->piece, (PieceId{world().ids().back(), 1}));
  apply(Undo{});
  EXPECT_EQ(world().spring()->piece, (PieceId{plate, 1}));
}

TEST_F(BodiesInTime, a_spring_lifts_and_releases_a_plate) {
  const BodyId plate = world().ids().front();
  apply(Play{});
  fall(120);
  document_.apply(DragBody{{plate, 0}, {0, 0, 0}, {0.2, 1, 0}});
  fall(240);
  run();
  EXPECT_LT(glm::distance(world().body(plate).placement.position, Vec3(0.2, 1, 0)), 0.05);
  document_.apply(ReleaseBody{});
  fall(240);
  run();
  EXPECT_LT(world().body(plate).placement.position.y, 0.05);
}

// A plate without weight that moves under a beam that stands still, and one that stands still under a beam
// that moves as the other plate sees it move.
class MovingPlate : public testing::TestWithParam<Rim> {
 protected:
  static World plate_in_space(const Motion& motion) {
    World world;
    const BodyId id = add(world, rectangle(1, 1, 6), {0, 0, 0});
    world.body(id).motion = motion;
    world.set_environment({.gravity = Vec3(0), .ground = std::nullopt});
    return world;
  }

  static CutSettings settings_of(Rim rim) {
    CutSettings s = settings();
    s.laser.radius = 0.02;
    s.resolution.rim = rim;
    return s;
  }

  // Cuts the moving plate, and returns where the beam was in its frame after each tick.
  static std::vector<Pose> cut_moving(Document& document, const Pose& beam, Ticks ticks) {
    const BodyId plate = document.world().ids().front();
    std::vector<Pose> seen;
    document.apply(Play{});
    document.apply(BeginStroke{settings_of(GetParam()), beam});
    for (Ticks i = 0; i < ticks; ++i) {
      document.apply(AdvanceTime{1, true});
      EXPECT_TRUE(run_all(document).ok());
      seen.push_back(document.world().body(plate).placement.to_body(beam));
    }
    document.apply(EndStroke{});
    EXPECT_TRUE(run_all(document).ok());
    return seen;
  }

  static void cut_still(Document& document, const Pose& beam, const std::vector<Pose>& seen) {
    document.apply(BeginStroke{settings_of(GetParam()), beam});
    for (const Pose& pose : seen) document.apply(MoveBeam{pose});
    document.apply(EndStroke{});
    EXPECT_TRUE(run_all(document).ok());
  }

  static void expect_equal_cuts(const Motion& motion) {
    const Pose beam{{0.3, 1, 0.1}, {0, -1, 0}};
    Document moving(plate_in_space(motion)), still(plate_in_space({}));
    cut_still(still, beam, cut_moving(moving, beam, 30));
    EXPECT_GT(moving.history().totals().removed_area, 0.005);
    EXPECT_NEAR(moving.history().totals().removed_area, still.history().totals().removed_area, 1e-9);
    const Body &a = moving.world().body(moving.world().ids().front()),
               &b = still.world().body(still.world().ids().front());
    EXPECT_EQ(a.mesh.live_faces(), b.mesh.live_faces());
    EXPECT_LT(glm::length(a.pieces[0].moments.first - b.pieces[0].moments.first), 1e-9);
  }
};

TEST_P(MovingPlate, cut_by_a_still_beam_matches_a_still_plate_cut_by_the_opposite_beam) {
  expect_equal_cuts({.velocity = {1.5, 0, 0.3}});
}

TEST_P(MovingPlate, spinning_matches_a_still_plate) {
  expect_equal_cuts({.velocity = {0.4, 0.1, 0}, .spin = {0, 3, 0}});
}

TEST_P(MovingPlate, tumbling_matches_a_still_plate) {
  expect_equal_cuts({.velocity = {0.4, 0, -0.5}, .spin = {1, 0.5, 0.3}});
}

INSTANTIATE_TEST_SUITE_P(BothRims, MovingPlate, testing::Values(Rim::kFaces, Rim::kSmooth),
                         [](const auto& rim) { return rim.param == Rim::kFaces ? "faces" : "smooth"; });

TEST_F(BodiesInTime, a_still_beam_cuts_a_falling_plate_and_both_halves_keep_falling) {
  apply(Play{});
  apply(BeginStroke{settings(), {{-3, 0.25, 0.1}, {1, 0, 0}}});  // level, below the plate, across all of it
  fall(60);
  apply(EndStroke{});
  fall(60);
  run();
  EXPECT_EQ(world().ids().size(), 2u);
  for (const BodyId id : world().ids()) EXPECT_LT(centre(id).y, 0.1);
  const uint64_t end = state_hash(world());
  apply(Undo{});
  EXPECT_EQ(state_hash(world()), state_hash(made_world()));
  apply(Redo{});
  EXPECT_EQ(state_hash(world()), end);
}

// Cuts a plate of which a piece falls during the stroke, and compares the area left.
class FallingPiece : public BodiesInTime {
 protected:
  void expect_smooth_rims(std::vector<BodyId> bodies_to_cut) {
    CutSettings smooth = settings();
    smooth.laser.radius = 0.03;
    smooth.resolution.rim = Rim::kSmooth;
    smooth.bodies = std::move(bodies_to_cut);
    const Vec3 down(0, -1, 0);
    apply(PinPiece{{world().ids().front(), 0}, true});
    apply(Play{});
    apply(BeginStroke{smooth, {{-0.7, 3, 0.3}, down}});
    apply(MoveBeam{{{0.7, 3, 0.3}, down}});
    fall(20);
    apply(EndStroke{});
    fall(1);
    run();
    ASSERT_EQ(world().ids().size(), 2u);
    // The slit is as wide as the beam in both: what is left is the plate without it.
    double area = 0;
    for (const BodyId id : world().ids())
      area += world().body(id).pieces[0].area +
              (world().body(id).pieces.size() > 1 ? world().body(id).pieces[1].area : 0);
    EXPECT_NEAR(area, 1 - 2 * smooth.laser.radius, 1e-6);
  }
};

TEST_F(FallingPiece, has_its_smooth_rim_closed_at_the_end_of_the_stroke) { expect_smooth_rims({}); }

TEST_F(FallingPiece, is_cut_by_a_stroke_limited_to_the_body_that_it_came_off) {
  expect_smooth_rims({world().ids().front()});
}

}  // namespace
}  // namespace kerf::test
