#include "core/document/single_step.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

using StageKind = StageRecord::Kind;

void draw(Document& document, const RandomStroke& stroke) {
  document.apply(BeginStroke{stroke.settings, stroke.moves.front().from});
  document.apply(MoveBeam{stroke.moves.back().to});
  document.apply(EndStroke{});
}

// Whether one stage of a move may follow another in the same body or the next one.
bool may_follow(StageKind before, StageKind next) {
  switch (before) {
    case StageKind::kSweep:
      return next == StageKind::kHit;
    case StageKind::kHit:
      return next == StageKind::kRefine;
    case StageKind::kRefine:
      return next == StageKind::kRefine || next == StageKind::kHitAgain || next == StageKind::kRemove;
    case StageKind::kHitAgain:
      return next == StageKind::kRemove;
    case StageKind::kRemove:
      return next == StageKind::kRemove || next == StageKind::kSeparate;
    default:
      return next == StageKind::kSweep || next == StageKind::kCloseRim || next == StageKind::kSeparate;
  }
}

void expect_same_as_steps(const Soup& soup, Random& random) {
  Document stepped(world_of(soup)), walked(world_of(soup));
  RandomStroke stroke = random_stroke(stepped.world(), random, 0.03, random.below(2) == 0);
  if (random.below(2) == 0) stroke.settings.resolution.rim = Rim::kSmooth;
  draw(stepped, stroke);
  draw(walked, stroke);
  const Result<StepResult> all = run_all(walked);
  ASSERT_TRUE(all.ok());
  SingleStep single(stepped);
  StepResult sum;
  StageKind last = StageKind::kSeparate;
  while (stepped.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    ASSERT_TRUE(may_follow(last, stage->kind));
    last = stage->kind;
    sum.moves += stage->done.moves;
    sum.delta.removed_faces += stage->done.delta.removed_faces;
    sum.statistics.add(stage->done.statistics);
  }
  expect_same_world(stepped.world(), walked.world());
  EXPECT_EQ(state_hash(stepped.world()), state_hash(walked.world()));
  EXPECT_EQ(sum.moves, all->moves);
  EXPECT_EQ(sum.delta.removed_faces, all->delta.removed_faces);
  EXPECT_EQ(sum.statistics.tested.boxes, all->statistics.tested.boxes);
}

// Goes forth and back at random, and expects the same state whenever it comes to the same stage.
class RandomWalk {
 public:
  RandomWalk(Document& document, Random& random)
      : document_(document), single_(document, 1 + random.below(2000)), random_(random) {}

  // Until so many stages are executed, or all.
  void walk(size_t most) {
    hashes_.resize(1, state_hash(document_.world()));
    for (size_t turns = 4; single_.stages() < most && document_.waiting() > 0;) {
      ASSERT_TRUE(document_.queue().next_is_of_last_step());
      ASSERT_TRUE(single_.next().ok());
      expect_known_state();
      if (turns > 0 && random_.below(8) == 0) --turns, go_back();
    }
  }

  void go_back() {
    const size_t stages = random_.below(single_.stages() + 1);
    const size_t from = single_.resumes_after(stages);
    ASSERT_TRUE(from < stages || stages == 0);
    size_t reported = from;
    ASSERT_TRUE(single_.go_back_to(stages, [&](const StageRecord&) { ++reported; }).ok());
    ASSERT_EQ(single_.stages(), stages);
    ASSERT_EQ(reported, stages);
    expect_known_state();
  }

 private:
  void expect_known_state() {
    const uint64_t hash = state_hash(document_.world());
    if (single_.stages() == hashes_.size()) hashes_.push_back(hash);
    ASSERT_EQ(hash, hashes_[single_.stages()]) << "after stage " << single_.stages();
  }

  Document& document_;
  SingleStep single_;
  Random& random_;
  std::vector<uint64_t> hashes_;  // by stages
};

// A stroke across the world, and then perhaps the same again at another resolution.
std::vector<Command> random_commands(const World& world, Random& random) {
  RandomStroke stroke = random_stroke(world, random, 0.05, random.below(2) == 0);
  if (random.below(2) == 0) stroke.settings.resolution.rim = Rim::kSmooth;
  std::vector<Command> commands{BeginStroke{stroke.settings, stroke.moves.front().from},
                                MoveBeam{stroke.moves.back().to}, EndStroke{}};
  stroke.settings.resolution.target_edge *= 1.5;
  if (random.below(2) == 0) commands.emplace_back(Recut{stroke.settings});
  return commands;
}

void expect_same_after_going_back(const Soup& soup, Random& random) {
  Document stepped(world_of(soup)), walked(world_of(soup));
  for (int strokes = 0; strokes < 2; ++strokes) {
    for (const Command& command : random_commands(walked.world(), random)) {
      stepped.apply(command);
      walked.apply(command);
      if (random.below(3) == 0) continue;  // a recut finds the stroke uncut or cut
      ASSERT_TRUE(run_all(stepped).ok());
      ASSERT_TRUE(run_all(walked).ok());
    }
    ASSERT_TRUE(run_all(walked).ok());
    const size_t journal = stepped.journal().size();
    stepped.restart_stroke();
    RandomWalk(stepped, random).walk(std::numeric_limits<size_t>::max());
    expect_same_world(stepped.world(), walked.world());
    EXPECT_EQ(state_hash(stepped.world()), state_hash(walked.world()));
    EXPECT_EQ(stepped.history().totals().removed_faces, walked.history().totals().removed_faces);
    EXPECT_EQ(stepped.journal().size(), journal);
    EXPECT_EQ(stepped.history().position(), walked.history().position());
  }
}

TEST(SingleStep, stepping_back_and_forth_gives_the_same_world) {
  for (uint64_t seed = 1; seed <= runs(2); ++seed) {
    Random random(seed);
    for (const auto& [name, soup] : mesh_classes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      expect_same_after_going_back(soup, random);
    }
  }
}

TEST(SingleStep, keeps_the_stroke_undoable_and_redoable_at_any_stage) {
  for (uint64_t seed = 1; seed <= runs(5); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document stepped(world_of(torus(16, 10, 0.5, 0.2))), walked(world_of(torus(16, 10, 0.5, 0.2)));
    const uint64_t before = state_hash(stepped.world());
    const RandomStroke stroke = random_stroke(stepped.world(), random, 0.03, false);
    draw(stepped, stroke);
    draw(walked, stroke);
    ASSERT_TRUE(run_all(walked).ok());
    RandomWalk(stepped, random).walk(5 + random.below(30));
    stepped.apply(Undo{});
    EXPECT_EQ(state_hash(stepped.world()), before);
    stepped.apply(Redo{});
    RandomWalk(stepped, random).walk(std::numeric_limits<size_t>::max());
    expect_same_world(stepped.world(), walked.world());
  }
}

TEST(SingleStep, steps_back_while_a_stroke_is_being_drawn) {
  Document stepped(world_of(grid(20, 2))), walked(world_of(grid(20, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  const BeginStroke begin{settings, {{-0.5, 1, 0.03}, {0, -1, 0}}};
  const MoveBeam half{{{0, 1, 0.03}, {0, -1, 0}}}, rest{{{0.5, 1, 0.1}, {0, -1, 0}}};
  stepped.apply(begin);
  stepped.apply(half);
  SingleStep single(stepped);
  while (single.stages() < 20) ASSERT_TRUE(single.next().ok());
  ASSERT_TRUE(single.go_back_to(7).ok());
  stepped.apply(rest);
  stepped.apply(EndStroke{});
  ASSERT_TRUE(run_all(stepped).ok());
  for (const Command& command : {Command(begin), Command(half), Command(rest), Command(EndStroke{})})
    walked.apply(command);
  ASSERT_TRUE(run_all(walked).ok());
  expect_same_world(stepped.world(), walked.world());
}

TEST(SingleStep, a_stroke_may_be_stopped_after_a_step_back) {
  Document stepped(world_of(grid(20, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  stepped.apply(BeginStroke{settings, {{-0.5, 1, 0.03}, {0, -1, 0}}});
  for (const double x : {0.0, 0.3, 0.6}) stepped.apply(MoveBeam{{{x, 1, 0.03}, {0, -1, 0}}});
  stepped.apply(EndStroke{});
  Document replayed(world_of(grid(20, 2)));
  SingleStep single(stepped, 1);  // with a save point after each move
  size_t moves = 0;
  std::vector<size_t> ends;  // stages at the ends of moves
  while (stepped.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    moves += stage->done.moves;
    if (stage->done.moves > 0) ends.push_back(single.stages());
  }
  ASSERT_GT(moves, 10u);
  ASSERT_TRUE(single.go_back_to(ends[4] + 1).ok());  // the sweep of the next move executes nothing
  ASSERT_TRUE(stop_strokes(stepped).ok());
  ASSERT_TRUE(run_all(stepped).ok());
  for (const Command& command : stepped.journal()) ASSERT_TRUE(replayed.apply(command).ok());
  ASSERT_TRUE(run_all(replayed).ok());
  expect_same_world(stepped.world(), replayed.world());
}

// A stroke along the middle of a sheet waits.
Document sheet_with_stroke() {
  Document document(world_of(grid(20, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  document.apply(BeginStroke{settings, {{-0.5, 1, 0.03}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.5, 1, 0.03}, {0, -1, 0}}});
  document.apply(EndStroke{});
  return document;
}

std::vector<uint32_t> live_slots(const World& world) {
  const Mesh& mesh = world.body(world.ids().front()).mesh;
  std::vector<uint32_t> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) faces.push_back(f);
  }
  return faces;
}

TEST(SingleStep, resumes_within_the_stroke_after_enough_work) {
  Document document = sheet_with_stroke();
  SingleStep single(document, 1);
  while (document.waiting() > 0) ASSERT_TRUE(single.next().ok());
  EXPECT_GT(single.resumes_after(single.stages()), 0u);
}

TEST(SingleStep, reports_changes_of_a_step_back) {
  Document document = sheet_with_stroke();
  SingleStep single(document);
  while (single.stages() < 20) ASSERT_TRUE(single.next().ok());
  const std::vector<uint32_t> live = live_slots(document.world());
  while (document.waiting() > 0) ASSERT_TRUE(single.next().ok());
  std::vector<uint32_t> reported = live_slots(document.world());
  const Outcome back = single.go_back_to(20);
  ASSERT_EQ(back.delta.bodies.size(), 1u);
  const BodyDelta& delta = back.delta.bodies.front();
  std::erase_if(reported, [&](uint32_t f) {
    return std::binary_search(delta.dead.begin(), delta.dead.end(), FaceId(f));
  });
  for (const FaceId f : delta.added) reported.push_back(f.index);
  std::sort(reported.begin(), reported.end());
  reported.erase(std::unique(reported.begin(), reported.end()), reported.end());
  EXPECT_EQ(reported, live);
}

TEST(SingleStep, stepping_back_can_be_cancelled) {
  Document document = sheet_with_stroke();
  SingleStep single(document);
  while (document.waiting() > 0) ASSERT_TRUE(single.next().ok());
  const uint64_t end = state_hash(document.world());
  const Progress half{[](double share) { return share < 0.5; }};
  const size_t all = single.stages();
  EXPECT_FALSE(single.go_back_to(all - 1, {}, &half).ok());
  EXPECT_LT(single.stages(), all - 1);
  EXPECT_GE(2 * single.stages(), all - 1);
  while (document.waiting() > 0) ASSERT_TRUE(single.next().ok());
  EXPECT_EQ(single.stages(), all);
  EXPECT_EQ(state_hash(document.world()), end);
}

TEST(SingleStep, matches_normal_steps_bit_for_bit) {
  for (uint64_t seed = 1; seed <= runs(4); ++seed) {
    Random random(seed);
    for (const auto& [name, soup] : mesh_classes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      expect_same_as_steps(soup, random);
    }
  }
}

TEST(SingleStep, distinguishes_time_from_closing_a_rim) {
  Document document(world_of(sphere(12, 16, 1)));
  SingleStep single(document);
  document.apply(AdvanceTime{3, true});
  while (document.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    EXPECT_EQ(stage->kind, StageKind::kTime);
  }
}

TEST(SingleStep, reports_every_face_a_move_hits_and_removes) {
  Document document(world_of(grid(20, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  document.apply(BeginStroke{settings, {{0.02, 1, 0.03}, {0, -1, 0}}});
  document.apply(EndStroke{});
  SingleStep single(document);
  std::vector<FaceId> hit, dead;
  while (document.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    if (stage->kind == StageKind::kHit || stage->kind == StageKind::kHitAgain) hit = stage->hit;
    if (stage->kind != StageKind::kRemove) continue;
    for (const BodyDelta& body : stage->done.delta.bodies)
      dead.insert(dead.end(), body.dead.begin(), body.dead.end());
  }
  std::sort(hit.begin(), hit.end());
  EXPECT_FALSE(hit.empty());
  EXPECT_EQ(dead, hit);
}

TEST(SingleStep, reports_unrefined_faces_only_after_partial_refinement) {
  Document document(world_of(grid(80, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 3;  // over the whole sheet
  document.apply(BeginStroke{settings, {{0, 1, 0}, {0, -1, 0}}});
  document.apply(EndStroke{});
  SingleStep single(document);
  bool any_left = false;
  while (document.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    if (stage->kind == StageKind::kRemove) continue;
    const bool refines = stage->kind == StageKind::kRefine;
    const size_t to_split = document.queue().pending().unfinished().to_split.size();
    EXPECT_EQ(stage->left, refines ? to_split : 0);
    any_left = any_left || stage->left > 0;
  }
  EXPECT_TRUE(any_left);
}

TEST(SingleStep, executes_all_parts_of_a_stage_at_once) {
  Document document(world_of(grid(20, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 3;  // over the whole sheet, of 800 faces
  settings.resolution.rim = Rim::kFaces;
  document.apply(BeginStroke{settings, {{0, 1, 0}, {0, -1, 0}}});
  document.apply(EndStroke{});
  SingleStep single(document);
  size_t refined = 0, removed = 0;
  while (document.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    refined += stage->kind == StageKind::kRefine;
    removed += stage->kind == StageKind::kRemove;
  }
  EXPECT_EQ(refined, 1u);
  EXPECT_EQ(removed, 1u);
  EXPECT_EQ(document.world().live_faces(), 0u);
}

}  // namespace
}  // namespace kerf::test
