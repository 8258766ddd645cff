#include <array>
#include <iostream>

#include "app/arguments.h"
#include "app/console.h"
#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/document/cut_effects.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/single_step.h"
#include "core/document/stroke_path.h"
#include "core/document/text/hash.h"
#include "core/document/text/json.h"
#include "core/graph/component_graph.h"
#include "core/tree/queries.h"
#include "core/world/world.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/render/picture.h"

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

// Returns the queries of the tree for the volumes of a sweep.
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
  stage["words"] = stage_label(record, FileUnit::kMetre);
  if (record.kind == Kind::kHit || record.kind == Kind::kHitAgain) stage["hit"] = to_json(record.hit);
  for (const BodyDelta& d : record.done.delta.bodies) {
    stage["born"] = to_json(d.added);
    stage["gone"] = to_json(d.dead);
    stage["relabelled"] = to_json(d.relabelled);
    stage["pieces"] = d.new_pieces;
  }
  return stage;
}

// Executes documents up to a given move and records its stages.
class MoveSearch {
 public:
  MoveSearch(Document& document, size_t number) : document_(document), number_(number) {}

  // Executes the queue of the document. Returns true if the move was found and recorded.
  Result<bool> search(const Progress* progress) {
    while (document_.waiting() > 0) {
      if (progress && !progress->report(0)) return cancelled();
      if (moves_ + 1 == number_ && document_.queue().pending().next_move(document_.world()) &&
          !document_.queue().next_searches())
        return record(progress);
      const Result<StepResult> some = document_.step(1, progress);
      if (!some) return some.error();
      moves_ += some->moves;
    }
    return false;
  }
  const Json& found() const { return found_; }
  // Returns the number of executed moves.
  size_t moves() const { return moves_; }

 private:
  Result<bool> record(const Progress* progress) {
    const BeamMove move = *document_.queue().pending().next_move(document_.world());
    Json stages = Json::array(), queries;
    StageRecord sweep;
    SingleStep single(document_);
    for (bool finished = false; !finished;) {
      if (document_.queue().pending().unfinished().stage == UnfinishedMove::Stage::kFindAgain)
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

// Returns the stages of one move of the beam, like the single steps of the editor. Moves are counted from 1
// over all strokes of the file, in the order of execution and with their subdivision:
// {"step": 3, "move": {"from": {"origin": [..], "direction": [..]}, "to": {..}, "seconds": 0.1},
//  "stages": [{"stage": "hit", "body": "car", "words": "..", "hit": [..], "born": [..], "gone": [..],
//              "relabelled": [..], "pieces": [..], "queries": [{..}]}], "state_hash": "0123456789abcdef"}
// The queries of "hit" and "hit-again" list the boxes of the tree in the order of the tests: the index of the
// parent, the outcome ("entered", "culled", "missed" or "touched"), the side that culled it ("depth",
// "motion" or "lateral"), and the face of a leaf. Boxes are in the frame of the body. Fails with bad input if
// there are fewer moves, and with cancelled() when stopped.
Result<nlohmann::ordered_json> step_json(OpenedFile file, size_t number, const Progress* progress) {
  KERF_ASSERT(number > 0);
  const double diagonal = file.scene.world.bounds().diagonal();
  Document document = document_of(std::move(file.scene.world), file.scene);
  MoveSearch moves(document, number);
  const auto run = [&](const std::vector<Command>& commands) -> Result<bool> {
    for (const Command& command : commands) {
      (void)document.apply(command, progress);  // a failure here also occurred when recording
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
    return bad_input("--step " + std::to_string(number) + ": the strokes of the file have only " +
                     std::to_string(moves.moves()) + " moves of the beam");
  Json json = {{"step", number}};
  json.update(moves.found());
  return json;
}

struct InspectArguments {
  std::string file, unit = "m";
  bool graph = false, dot = false, tree = false;
  std::optional<size_t> step;
};

// Returns the trees of all bodies as the editor draws them: {"bodies": [{"body": "car", "faces": 5008,
// "boxes":
// [{"min": [..], "max": [..], "depth": 0, "leaf": false, "hit": false}]}]}, parents before children, in the
// frame of each body. O(boxes).
nlohmann::ordered_json tree_json(const World& world) {
  auto bodies = nlohmann::ordered_json::array();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    auto boxes = nlohmann::ordered_json::array();
    body.tree.for_each_box(body.mesh, [&](const AabbTree::Box& box) {
      boxes.push_back({{"min", vector_json(box.min)},
                       {"max", vector_json(box.max)},
                       {"depth", box.depth},
                       {"leaf", box.leaf},
                       {"hit", box.hit}});
    });
    bodies.push_back({{"body", body.name}, {"faces", body.tree.leaf_count()}, {"boxes", std::move(boxes)}});
  }
  return {{"bodies", std::move(bodies)}};
}

// A step that fails here also failed during recording.
Status replay_all(const Journal& journal, Document& document) {
  ProgressLine line("replaying");
  const Progress progress = line.progress();
  QueueRun how;
  how.progress = &progress;
  how.told = [](const Result<StepResult>&) -> Status { return interrupted() ? Status(stopped()) : Done{}; };
  return Replay(journal, document).run(how);
}

Status cut_all(const std::vector<StrokePath>& strokes, Document& document) {
  ProgressLine line("cutting");
  const Progress progress = line.progress();
  return cut_strokes(
      document, strokes, [](const StepResult&) {}, &progress);
}

// Opens any file of Kerf, cuts the strokes of a scene or replays the commands of a journal. Fails with an
// error that names the file, or with stopped() after Ctrl-C.
Result<Document> load_document(const std::filesystem::path& file, FileUnit unit) {
  auto work = load_file(file, unit);
  if (!work) return work.error();
  Document document = document_of(std::move(work->scene.world), work->scene);
  if (const Status cut = cut_all(work->scene.strokes, document); !cut) return error_or_stopped(cut.error());
  if (const Status run = replay_all(work->journal, document); !run) return error_or_stopped(run.error());
  return document;
}

void write_graph(const InspectArguments& a, const Document& document) {
  const ComponentGraph graph = component_graph(document.world());
  const std::vector<PieceNode> pieces = piece_origins(document);
  (a.dot ? write_graph_dot : write_graph_json)(graph, pieces, document.world(), std::cout);
}

// Replaces bytes of names that are not UTF-8.
Status write(const nlohmann::ordered_json& json) {
  std::cout << json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  return Done{};
}

Status write_step(const InspectArguments& a, FileUnit unit) {
  ProgressLine line("cutting " + std::filesystem::path(a.file).filename().string());
  const Progress progress = line.progress();
  Result<OpenedFile> file = open_file(a.file, &progress, unit);
  if (!file) return error_or_stopped(file.error());
  if (!file->journal.damage.empty()) warn(file->journal.damage);
  const auto json = step_json(std::move(*file), *a.step, &progress);
  return json ? write(*json) : Status(error_or_stopped(json.error()));
}

Status write_what(const InspectArguments& a) {
  const auto unit = parse_unit(a.unit);
  if (!unit) return unit.error();
  if (a.step) return write_step(a, *unit);
  const auto document = load_document(a.file, *unit);
  if (!document) return document.error();
  if (a.tree) return write(tree_json(document->world()));
  write_graph(a, *document);
  return Done{};
}

Status inspect(const InspectArguments& a) {
  catch_interrupts();
  if (a.graph + a.tree + a.step.has_value() != 1)
    return bad_input("inspect: give one of --graph, --tree and --step N");
  if (const Status written = write_what(a); !written) return written;
  return flush_output();
}

}  // namespace

void add_inspect_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "inspect", "Print the data of the debug views of a scene, a journal or a mesh as JSON");
  auto a = std::make_shared<InspectArguments>();
  command->add_option("FILE", a->file, "A scene (.json), a journal (.kerf) or a mesh")->required();
  add_unit_option(*command, a->unit);
  auto* graph = command->add_flag(
      "--graph", a->graph,
      "The component graph after the last cut: faces as nodes, shared edges as links; and the pieces with "
      "their origins and supports");
  command->add_flag("--dot", a->dot, "Write the graph for Graphviz instead of JSON")->needs(graph);
  command->add_flag("--tree", a->tree,
                    "The boxes of the tree after the last cut, and whether the beam hit them");
  add_number(*command, "--step", a->step, {1, 1e9},
             "The stages of this move of the beam, counted from 1, with its tree queries");
  on_call(
      *command, invocation, [a] { return inspect(*a); }, "kerf inspect assets/scenes/figure-09.kerf --graph");
}

}  // namespace kerf
