#include <CLI/CLI.hpp>
#include <cstdio>

#include "tests/bench/sections.h"

namespace kerf::bench {
namespace {

void say_what_is_skipped() {
  if (!has_embree()) std::printf("built without Embree 3 (libembree-dev): the rows beside it are skipped\n");
  if (!has_cgal()) std::printf("built without CGAL (libcgal-dev): the rows beside it are skipped\n");
}

void run(const std::string& name, const Effort& effort, bool cuts_only, const Report& report) {
  const Subject subject = make_subject(name);
  if (subject.mesh.live_faces() == 0) {
    std::printf("%s could not be read: its rows are skipped\n", name.c_str());
    return;
  }
  bench_cut(subject, effort, report);
  if (cuts_only) return;
  bench_build(subject, effort, report);
  bench_queries(subject, effort, report);
  bench_edits(subject, effort, report);
  bench_shadows(subject, effort, report);
}

}  // namespace
}  // namespace kerf::bench

int main(int argc, char** argv) {
  using namespace kerf::bench;
  CLI::App app{"The tree beside its peers: processor time of one thread, medians"};
  std::string json;
  std::vector<std::string> only;
  bool tiny = false, cuts_only = false;
  app.add_option("--json", json, "Write the table to this file as well");
  app.add_option("--mesh", only, "Only these meshes");
  app.add_flag("--tiny", tiny, "Small inputs, to see that it runs");
  app.add_flag("--cuts", cuts_only, "Only whole cuts");
  CLI11_PARSE(app, argc, argv);

  say_what_is_skipped();
  if (!tiny && subject_names(false).size() == 1)
    std::printf("KERF_TEST_MESHES names no folder with real meshes: their rows are skipped\n");
  std::vector<Row> rows;
  print_header();
  for (const std::string& name : only.empty() ? subject_names(tiny) : only) {
    run(name, tiny ? Effort{50, 3, 1, 20, 20} : Effort{}, cuts_only, [&](const Row& row) {
      rows.push_back(row);
      print(row);
    });
  }
  if (json.empty() || write_json(rows, json)) return 0;
  std::fprintf(stderr, "kerf: could not write %s\n", json.c_str());
  return 1;
}
