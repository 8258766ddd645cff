#include "app/inspect_step.h"

#include <array>

#include "core/base/assert.h"
#include "core/document/files/stroke_settings.h"
#include "core/document/history/single_step.h"
#include "core/document/text/hash_text.h"
#include "core/document/text/json_value.h"
#include "core/tree/touched_walk.h"
#include "core/world/state_hash.h"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;
using Kind = StageRecord::Kind;

const char* name(Kind kind) {
  constexpr std::array kNames{"sweep",  "hit",      "refine",    "hit-again",
                              "remove", "separate", "close-rim", "time"};
  return kNames.at(static_cast<size_t>(kind));
}

const char* name(TouchedWalk::Outcome outcome) {
  constexpr std::array kNames{"entered", "culled", "missed", "touched"};
  return kNames.at(static_cast<size_t>(outcome));
}

const char* name(TouchedWalk::Side side) {
  constexpr std::array kNames{"", "depth", "motion", "lateral"};
  return kNames.at(static_cast<size_t>(side));
}

Json to_json(const std::vector<FaceId>& faces) {
  Json list = Json::array();
  for (const FaceId f : faces) list.push_back(f.index);
  return list;
}

Json to_json(const Pose& pose) {
  return {{"origin", vector_json(pose.origin)}, {"direction", vector_json(pose.direction)}};
}

Json to_json(const TouchedWalk& walk) {
  Json boxes = Json::array();
  for (const TouchedWalk::Visit& v : walk.visits) {
    Json box = {{"min", vector_json(v.box.min)},
                {"max", vector_json(v.box.max)},
                {"depth", v.box.depth},
                {"outcome", name(v.outcome)}};
    if (v.parent != TouchedWalk::kNoParent) box["parent"] = v.parent;
    if (v.outside != TouchedWalk::Side::kNone) box["outside"] = name(v.outside);
    if (v.face.valid()) box["face"] = v.face.index;
    boxes.push_back(std::move(box));
  }
  return {{"boxes_tested", walk.counts.boxes},
          {"faces_tested", walk.counts.faces},
          {"touched", to_json(walk.touched)},
          {"boxes", std::move(boxes)}};
}

// The queries of the tree for the volumes of a sweep.
Json queries_json(const World& world, const StageRecord& sweep) {
  Json queries = Json::array();
  const Body& body = world.body(sweep.body);
  for (const SweptCylinder& volume : sweep.beam)
    queries.push_back(to_json(trace_touched(body.tree, body.mesh, volume)));
  return queries;
}

Json to_json(const World& world, const StageRecord& record) {
  Json stage = {{"stage", name(record.kind)}};
  if (world.contains(record.body)) stage["body"] = world.body(record.body).name;
  stage["words"] = words(record, FileUnit::kMetre);
  if (record.kind == Kind::kHit || record.kind == Kind::kHitAgain) stage["hit"] = to_json(record.hit);
  for (const BodyDelta& d : record.done.delta.bodies) {
    stage["born"] = to_json(d.born);
    stage["gone"] = to_json(d.gone);
    stage["relabelled"] = to_json(d.relabelled);
    stage["pieces"] = d.new_pieces;
  }
  return stage;
}

// Executes documents up to the move of a number, and records the stages of that one.
class MoveSearch {
 public:
  MoveSearch(Document& document, size_t number) : document_(document), number_(number) {}

  // Executes the queue of the document. Returns whether the move was found and recorded.
  Result<bool> search(const Progress* progress) {
    while (document_.waiting() > 0) {
      if (progress && !progress->report(0)) return cancelled();
      if (moves_ + 1 == number_ && document_.execution().next_move() &&
          !document_.execution().next_searches())
        return record(progress);
      const Result<StepResult> some = document_.step(1, progress);
      if (!some) return some.error();
      moves_ += some->moves;
    }
    return false;
  }
  const Json& found() const { return found_; }
  // The number of moves that were executed.
  size_t moves() const { return moves_; }

 private:
  Result<bool> record(const Progress* progress) {
    const BeamMove move = *document_.execution().next_move();
    Json stages = Json::array(), queries;
    StageRecord sweep;
    SingleStep single(document_);
    for (bool finished = false; !finished;) {
      if (document_.execution().unfinished_move().stage == UnfinishedMove::Stage::kFindAgain)
        queries = queries_json(document_.world(), sweep);
      Result<StageRecord> some = single.next(progress);
      if (!some) return some.error();
      finished = some->done.moves > 0;
      stages.push_back(to_json(document_.world(), *some));
      if (some->kind == Kind::kHit || some->kind == Kind::kHitAgain)
        stages.back()["queries"] = std::move(queries);
      if (some->kind != Kind::kSweep) continue;
      queries = queries_json(document_.world(), *some);
      sweep = std::move(*some);
    }
    found_ = {{"move", {{"from", to_json(move.from)}, {"to", to_json(move.to)}, {"seconds", move.seconds}}},
              {"stages", std::move(stages)},
              {"state_hash", hash_text(state_hash(document_.world()))}};
    return true;
  }

  Document& document_;
  const size_t number_;
  size_t moves_ = 0;
  Json found_;
};

}  // namespace

Result<nlohmann::ordered_json> step_json(OpenedFile file, size_t number, const Progress* progress) {
  KERF_ASSERT(number > 0);
  const double diagonal = file.scene.world.bounds().diagonal();
  Document document(std::move(file.scene.world));
  MoveSearch moves(document, number);
  const auto run = [&](const std::vector<Command>& commands) -> Result<bool> {
    for (const Command& command : commands) {
      (void)document.apply(command, progress);  // what fails here failed when the journal was recorded
      if (const Result<bool> found = moves.search(progress); !found || *found) return found;
    }
    return false;
  };
  Result<bool> found = false;
  for (size_t i = 0; found && !*found && i < file.scene.strokes.size(); ++i)
    found = run(scene_stroke_commands(file.scene.strokes[i], diagonal));
  if (found && !*found) found = run(file.journal.commands);
  if (!found) return found.error();
  if (!*found)
    return bad_input("--step " + std::to_string(number) + ": the strokes of this file have only " +
                     std::to_string(moves.moves()) + " moves of the beam");
  Json json = {{"step", number}};
  json.update(moves.found());
  return json;
}

}  // namespace kerf
