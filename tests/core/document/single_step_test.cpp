#include "core/document/single_step.h"

#include <gtest/gtest.h>

#include "core/world/state_hash.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

using Kind = StageRecord::Kind;

void draw(Document& document, const RandomStroke& stroke) {
  document.apply(BeginStroke{stroke.settings, stroke.moves.front().from});
  document.apply(MoveStroke{stroke.moves.back().to});
  document.apply(EndStroke{});
}

// Whether one stage of a move may follow another in the same body or the next one.
bool may_follow(Kind before, Kind next) {
  switch (before) {
    case Kind::kSweep:
      return next == Kind::kHit;
    case Kind::kHit:
      return next == Kind::kRefine;
    case Kind::kRefine:
      return next == Kind::kRefine || next == Kind::kHitAgain || next == Kind::kRemove;
    case Kind::kHitAgain:
      return next == Kind::kRemove;
    case Kind::kRemove:
      return next == Kind::kRemove || next == Kind::kSeparate;
    default:
      return next == Kind::kSweep || next == Kind::kCloseRim || next == Kind::kSeparate;
  }
}

void expect_same_as_steps(const Soup& soup, Random& random) {
  Document stepped(world_of(soup)), walked(world_of(soup));
  RandomStroke stroke = random_stroke(stepped.world(), random, 0.03, random.below(2) == 0);
  if (random.below(2) == 0) stroke.settings.resolution.rim = Rim::kSmooth;
  draw(stepped, stroke);
  draw(walked, stroke);
  const Result<StepResult> all = walk_all(walked);
  ASSERT_TRUE(all.ok());
  SingleStep single(stepped);
  StepResult sum;
  Kind last = Kind::kSeparate;
  while (stepped.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    ASSERT_TRUE(may_follow(last, stage->kind)) << words(*stage);
    ASSERT_FALSE(words(*stage).empty());
    last = stage->kind;
    sum.moves += stage->done.moves;
    sum.delta.removed_faces += stage->done.delta.removed_faces;
    sum.figures.add(stage->done.figures);
  }
  expect_same_world(stepped.world(), walked.world());
  EXPECT_EQ(state_hash(stepped.world()), state_hash(walked.world()));
  EXPECT_EQ(sum.moves, all->moves);
  EXPECT_EQ(sum.delta.removed_faces, all->delta.removed_faces);
  EXPECT_EQ(sum.figures.tested.boxes, all->figures.tested.boxes);
}

TEST(SingleStep, cuts_what_steps_cut_to_the_bit) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    for (const auto& [name, soup] : mesh_classes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      expect_same_as_steps(soup, random);
    }
  }
}

TEST(SingleStep, tells_of_every_face_that_a_move_hits_and_removes) {
  Document document(world_of(grid(20, 2)));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  document.apply(BeginStroke{settings, {{0.02, 1, 0.03}, {0, -1, 0}}});
  document.apply(EndStroke{});
  SingleStep single(document);
  std::vector<FaceId> hit, gone;
  while (document.waiting() > 0) {
    const auto stage = single.next();
    ASSERT_TRUE(stage.ok());
    if (stage->kind == Kind::kHit || stage->kind == Kind::kHitAgain) hit = stage->hit;
    if (stage->kind != Kind::kRemove) continue;
    for (const BodyDelta& body : stage->done.delta.bodies)
      gone.insert(gone.end(), body.gone.begin(), body.gone.end());
  }
  std::sort(hit.begin(), hit.end());
  EXPECT_FALSE(hit.empty());
  EXPECT_EQ(gone, hit);
}

}  // namespace
}  // namespace kerf::test
