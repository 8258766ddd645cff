#include "ui/editor/single_step/stage_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/made_meshes.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/single_step/single_step_panel.h"

namespace kerf {
namespace {

using StageKind = StageRecord::Kind;

// A sheet, with a stroke from edge to edge that waits.
Document sheet(bool turns = false) {
  World world;
  world.add(make_body("sheet", test::build(test::grid(10, 2))));
  Document document(std::move(world));
  CutSettings settings;
  settings.laser.radius = 0.03;
  settings.resolution.target_edge = 0.08;
  const Vec3 down(0, -1, 0), aslant = glm::normalize(Vec3(0.2, -1, 0));
  document.apply(BeginStroke{settings, {{0.1, 3, -1.3}, down}});
  document.apply(MoveBeam{{{0.1, 3, 1.3}, turns ? aslant : down}});
  document.apply(EndStroke{});
  return document;
}

size_t count(const StageMarks& marks, StageMarks::Kind kind) {
  size_t fills = 0;
  for (const StageMarks::OfBody& body : marks.bodies) {
    fills += static_cast<size_t>(std::count_if(body.fills.begin(), body.fills.end(),
                                               [&](const StageMarks::Fill& f) { return f.kind == kind; }));
  }
  return fills;
}

size_t lines(const StageMarks& marks, StageMarks::Kind kind) {
  size_t lines = 0;
  for (const StageMarks::OfBody& body : marks.bodies) {
    lines += static_cast<size_t>(std::count_if(body.lines.begin(), body.lines.end(),
                                               [&](const StageMarks::Line& l) { return l.kind == kind; }));
  }
  return lines;
}

TEST(StageLog, counts_the_moves_of_the_stroke_and_their_stages) {
  Document document = sheet();
  SingleStep single(document);
  StageLog log;
  EXPECT_EQ(log.moves(), 0u);
  size_t moves = 0, stage = 0;
  std::vector<std::pair<size_t, size_t>> places{{0, 0}};
  while (document.waiting() > 0) {
    const Result<StageRecord> record = single.next();
    ASSERT_TRUE(record.ok());
    log.note(document.world(), *record, FileUnit::kMetre);
    const bool begins = record->kind == StageKind::kSweep;
    moves += begins;
    stage = begins ? 1 : stage + 1;
    EXPECT_EQ(log.moves(), moves);
    EXPECT_EQ(log.stage_of_move(), stage);
    places.emplace_back(moves, stage);
  }
  EXPECT_GT(moves, 1u);
  for (const size_t back : {places.size() / 2, size_t{1}, size_t{0}}) {
    log.restart(back);
    EXPECT_EQ(std::pair(log.moves(), log.stage_of_move()), places[back]);
  }
}

TEST(StageLog, marks_the_faces_hit_created_and_removed_by_each_stage) {
  Document document = sheet();
  SingleStep single(document);
  StageLog log;
  EXPECT_EQ(log.marks(document.world()), nullptr);
  std::set<StageKind> seen;
  std::vector<PieceId> came_off, stayed;
  while (document.waiting() > 0) {
    const Result<StageRecord> stage = single.next();
    ASSERT_TRUE(stage.ok());
    log.note(document.world(), *stage, FileUnit::kMetre);
    const auto marks = log.marks(document.world());
    ASSERT_NE(marks, nullptr);
    EXPECT_EQ(marks, log.marks(document.world())) << "made once";
    size_t added = 0;
    for (const BodyDelta& b : stage->done.delta.bodies) added += b.added.size();
    EXPECT_EQ(count(*marks, StageMarks::Kind::kHit), stage->hit.size());
    EXPECT_EQ(count(*marks, StageMarks::Kind::kRemoved), stage->done.delta.removed_faces);
    EXPECT_EQ(lines(*marks, StageMarks::Kind::kAdded), stage->kind == StageKind::kRefine ? 3 * added : 0);
    EXPECT_EQ(count(*marks, StageMarks::Kind::kSwept) > 0, stage->move.has_value());
    if (!marks->came_off.empty()) {
      EXPECT_FALSE(marks->stayed.empty());
      came_off.insert(came_off.end(), marks->came_off.begin(), marks->came_off.end());
      stayed.insert(stayed.end(), marks->stayed.begin(), marks->stayed.end());
    }
    seen.insert(stage->kind);
  }
  const BodyId body = document.world().ids().front();
  EXPECT_EQ(came_off, (std::vector<PieceId>{{body, 1}}));
  EXPECT_EQ(stayed, (std::vector<PieceId>{{body, 0}}));
  for (const StageKind kind :
       {StageKind::kSweep, StageKind::kHit, StageKind::kRefine, StageKind::kHitAgain, StageKind::kRemove})
    EXPECT_TRUE(seen.contains(kind));
}

TEST(StageLog, steps_through_the_last_tree_query) {
  for (const bool turns : {false, true}) {
    Document document = sheet(turns);
    SingleStep single(document);
    StageLog log;
    while (document.waiting() > 0) {
      const Result<StageRecord> stage = single.next();
      ASSERT_TRUE(stage.ok());
      log.note(document.world(), *stage, FileUnit::kMetre);
      if (stage->kind != StageKind::kHit && stage->kind != StageKind::kHitAgain) continue;
      const QueryWalk& query = log.query();
      ASSERT_EQ(query.visited(), query.size());
      std::set<uint32_t> touched;
      for (size_t boxes = 1; boxes <= query.size(); ++boxes) {
        log.visit(boxes);
        const bool hits = query.words().ends_with("the beam hits it.");
        if (hits) touched.insert(query.face().index);
        const bool culled = query.words().find("culled") != std::string::npos;
        EXPECT_EQ(culled, query.words().find("lies") != std::string::npos) << query.words();
      }
      std::set<uint32_t> hit;
      for (const FaceId f : stage->hit) hit.insert(f.index);
      ASSERT_EQ(touched, hit);
    }
  }
}

TEST(StageLog, draws_the_visited_boxes_of_the_query) {
  Document document = sheet();
  SingleStep single(document);
  StageLog log;
  while (log.query().count(TouchedWalk::Outcome::kTouched) == 0) {
    const Result<StageRecord> stage = single.next();
    ASSERT_TRUE(stage.ok());
    log.note(document.world(), *stage, FileUnit::kMetre);
  }
  EXPECT_EQ(lines(*log.marks(document.world()), StageMarks::Kind::kEntered), 0u);
  log.visit(1);
  EXPECT_EQ(lines(*log.marks(document.world()), StageMarks::Kind::kEntered), 12u);
  EXPECT_EQ(lines(*log.marks(document.world()), StageMarks::Kind::kLast), 12u);
  log.visit(log.query().size());
  EXPECT_EQ(lines(*log.marks(document.world()), StageMarks::Kind::kTouched),
            12 * log.query().count(TouchedWalk::Outcome::kTouched));
  log.draw_query(false);
  EXPECT_EQ(lines(*log.marks(document.world()), StageMarks::Kind::kLast), 0u);
}

TEST(StageLog, keeps_messages_of_later_stages_after_stepping_back) {
  Document document = sheet();
  SingleStep single(document);
  StageLog log;
  const auto note = [&](const StageRecord& stage) { log.note(document.world(), stage, FileUnit::kMetre); };
  while (single.stages() < 30) {
    const Result<StageRecord> stage = single.next();
    ASSERT_TRUE(stage.ok());
    note(*stage);
  }
  const std::vector<std::string> labels = log.told();
  log.restart();
  ASSERT_TRUE(single.go_back_to(11, note).ok());
  EXPECT_EQ(log.done(), 11u);
  EXPECT_EQ(log.told(), labels);
  EXPECT_EQ(stage_label(*log.last(), FileUnit::kMetre), labels[10]);
  log.restart();
  StageRecord other;
  other.kind = StageKind::kTime;
  log.note(document.world(), other, FileUnit::kMetre);
  EXPECT_EQ(log.told(), (std::vector<std::string>{stage_label(other, FileUnit::kMetre)}))
      << "the queue is another one";
  log.forget();
  EXPECT_EQ(log.told().size(), 0u);
}

TEST(StageState, reports_why_there_is_nothing_to_step_through) {
  Document document = sheet();
  StageState stages;
  EXPECT_NE(next_stage_disabled_reason(stages, document), nullptr) << "off";
  stages.requests.on = true;
  EXPECT_EQ(next_stage_disabled_reason(stages, document), nullptr);
  EXPECT_NE(stage_back_disabled_reason(stages, document), nullptr) << "nothing was executed";
  EXPECT_EQ(restart_disabled_reason(document), nullptr);
  document.apply(RenamePiece{{document.world().ids().front(), 0}, "plate"});
  EXPECT_NE(restart_disabled_reason(document), nullptr) << "the stroke is not the last step";
  EXPECT_NE(next_stage_disabled_reason(stages, document), nullptr) << "everything is cut";
  EXPECT_NE(restart_disabled_reason(Document(World())), nullptr);
}

TEST(StageState, plays_from_the_current_stage_or_restarts_at_the_end) {
  Document document = sheet();
  StageState stages;
  play_or_pause(stages, document);
  EXPECT_TRUE(stages.requests.on && stages.requests.playing && stages.requests.start_again);
  stages.requests.start_again = false;
  play_or_pause(stages, document);
  EXPECT_FALSE(stages.requests.playing);
  play_or_pause(stages, document);
  EXPECT_TRUE(stages.requests.playing && !stages.requests.start_again);
}

}  // namespace
}  // namespace kerf
