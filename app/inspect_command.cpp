#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/inspect_step.h"
#include "app/inspect_tree.h"
#include "app/interrupt.h"
#include "app/load_document.h"
#include "app/progress_line.h"
#include "core/document/history/piece_origins.h"
#include "core/document/text/json_text.h"
#include "core/graph/graph_text.h"

namespace kerf {

namespace {

struct InspectArguments {
  std::string file;
  bool graph = false, dot = false, tree = false;
  std::optional<size_t> step;
};

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
  if (a.graph + a.tree + a.step.has_value() != 1)
    return bad_input("inspect: say what to inspect: --graph, --tree or --step N");
  if (a.step && *a.step == 0) return bad_input("--step: moves are counted from 1");
  if (const Status written = write_what(a); !written) return written;
  return std::cout.flush() ? Status(Done{}) : failed("standard output cannot be written");
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
  command->add_option("--step", a->step,
                      "The stages of this move of the beam, counted from 1, with the walk through the tree");
  command->callback([a, &invocation] {
    invocation = [a] {
      catch_interrupts();
      const Status status = inspect(*a);
      return status ? 0 : report_error(status.error());
    };
  });
}

}  // namespace kerf
