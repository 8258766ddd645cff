#include <CLI/CLI.hpp>
#include <iostream>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/load_document.h"
#include "core/graph/graph_text.h"

namespace kerf {

namespace {

struct InspectArguments {
  std::string file;
  bool graph = false, dot = false;
};

void write_graph(const InspectArguments& a, const Document& document) {
  const ComponentGraph graph = component_graph(document.world());
  (a.dot ? write_graph_dot : write_graph_json)(graph, document.world(), std::cout);
}

Status inspect(const InspectArguments& a) {
  if (!a.graph) return bad_input("inspect: say what to inspect: --graph");
  const auto document = load_document(a.file);
  if (!document) return document.error();
  write_graph(a, *document);
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
      "The component graph after the last cut: faces as nodes, and an edge for two faces that share one");
  command->add_flag("--dot", a->dot, "Write the graph in the language of Graphviz instead of JSON")
      ->needs(graph);
  command->callback([a, &invocation] {
    invocation = [a] {
      catch_interrupts();
      const Status status = inspect(*a);
      return status ? 0 : report_error(status.error());
    };
  });
}

}  // namespace kerf
