#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/inspect_step.h"
#include "app/load.h"
#include "app/parse_values.h"
#include "app/tell.h"
#include "core/document/history/piece_origins.h"
#include "core/document/journal/replay.h"
#include "core/document/text/json_text.h"
#include "core/document/text/json_value.h"
#include "core/graph/graph_text.h"
#include "ui/render/picture/scene_strokes.h"

namespace kerf {

namespace {

struct InspectArguments {
  std::string file;
  bool graph = false, dot = false, tree = false;
  std::optional<size_t> step;
};

// The trees of all bodies as the editor draws them: {"bodies": [{"body": "car", "faces": 5008, "boxes":
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

// A step that fails here failed when the journal was made, too.
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

// The document of any file that Kerf opens, at its end: the strokes of a scene are cut, the commands of a
// journal replayed. Fails with an error that names the file, or with stopped() after Ctrl-C.
Result<Document> load_document(const std::filesystem::path& file) {
  auto work = load_file(file);
  if (!work) return work.error();
  Document document(std::move(work->scene.world));
  if (const Status cut = cut_all(work->scene.strokes, document); !cut) return error_or_stopped(cut.error());
  if (const Status run = replay_all(work->journal, document); !run) return error_or_stopped(run.error());
  return document;
}

void write_graph(const InspectArguments& a, const Document& document) {
  const ComponentGraph graph = component_graph(document.world());
  const std::vector<PieceNode> pieces = piece_origins(document);
  (a.dot ? write_graph_dot : write_graph_json)(graph, pieces, document.world(), std::cout);
}

Status write(const nlohmann::ordered_json& json) {
  const Result<std::string> text = dump_json(json);
  if (!text) return text.error();
  std::cout << *text << "\n";
  return Done{};
}

Status write_step(const InspectArguments& a) {
  ProgressLine line("cutting " + std::filesystem::path(a.file).filename().string());
  const Progress progress = line.progress();
  Result<OpenedFile> file = open_file(a.file, &progress);
  if (!file) return error_or_stopped(file.error());
  const auto json = step_json(std::move(*file), *a.step, &progress);
  return json ? write(*json) : Status(error_or_stopped(json.error()));
}

Status write_what(const InspectArguments& a) {
  if (a.step) return write_step(a);
  const auto document = load_document(a.file);
  if (!document) return document.error();
  if (a.tree) return write(tree_json(document->world()));
  write_graph(a, *document);
  return Done{};
}

Status inspect(const InspectArguments& a) {
  catch_interrupts();
  if (a.graph + a.tree + a.step.has_value() != 1)
    return bad_input("inspect: say what to inspect: --graph, --tree or --step N");
  if (const Status written = write_what(a); !written) return written;
  return flush_output();
}

}  // namespace

void add_inspect_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("inspect", "What the debug views show of a scene, a journal or a mesh, as JSON");
  auto a = std::make_shared<InspectArguments>();
  command->add_option("FILE", a->file, "A scene (.json), a journal (.kerf) or a mesh")->required();
  auto* graph = command->add_flag(
      "--graph", a->graph,
      "The component graph after the last cut: faces as nodes, and an edge for two faces that share one; "
      "and the pieces, with what they came off and what holds them");
  command->add_flag("--dot", a->dot, "Write the graph in the language of Graphviz instead of JSON")
      ->needs(graph);
  command->add_flag("--tree", a->tree, "The boxes of the tree after the last cut, and where the beam was");
  add_number(*command, "--step", a->step, {1, 1e9},
             "The stages of this move of the beam, counted from 1, with the walk through the tree");
  on_call(
      *command, invocation, [a] { return inspect(*a); }, "kerf inspect assets/scenes/figure-09.kerf --graph");
}

}  // namespace kerf
