#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "tests/bench/sections.h"

namespace kerf::bench {
namespace {

void say_what_is_skipped() {
  if (!has_embree()) std::printf("built without Embree 3 (libembree-dev): the rows beside it are skipped\n");
  if (!has_cgal()) std::printf("built without CGAL (libcgal-dev): the rows beside it are skipped\n");
  if (!has_manifold())
    std::printf("KERF_MANIFOLD named no build of Manifold: the rows beside it are skipped\n");
}

using Section = void (*)(const Subject&, const Effort&, const Report&);
const std::map<std::string, Section> kSections = {
    {"cut", bench_cut},       {"build", bench_build},     {"queries", bench_queries}, {"edits", bench_edits},
    {"kernel", bench_kernel}, {"shadows", bench_shadows}, {"heat", bench_heat},       {"fall", bench_fall},
    {"game", bench_game},     {"laser", bench_laser},     {"files", bench_files}};

void run(const std::string& name, const Effort& effort, const std::vector<std::string>& sections,
         const Report& report) {
  const Subject subject = make_subject(name);
  if (subject.mesh.live_faces() == 0) {
    std::printf("%s could not be read: its rows are skipped\n", name.c_str());
    return;
  }
  for (const std::string& section : sections) kSections.at(section)(subject, effort, report);
}

}  // namespace
}  // namespace kerf::bench

int main(int argc, char** argv) {
  using namespace kerf::bench;
  mallopt(M_MMAP_THRESHOLD, 1 << 20);  // as app/main.cpp
  CLI::App app{"The tree beside its peers: processor time of one thread, medians"};
  std::string json;
  std::vector<std::string> only;
  std::vector<std::string> sections = {"cut",  "build", "queries", "edits", "kernel", "shadows",
                                       "heat", "fall",  "game",    "laser", "files"};
  bool tiny = false;
  app.add_option("--json", json, "Write the table to this file as well");
  app.add_option("--mesh", only, "Only these meshes");
  app.add_flag("--tiny", tiny, "Small inputs, to see that it runs");
  app.add_option("--section", sections, "Only these sections")->check(CLI::IsMember(kSections));
  CLI11_PARSE(app, argc, argv);

  say_what_is_skipped();
  if (!tiny && subject_names(false).size() == 1)
    std::printf("KERF_TEST_MESHES names no folder with real meshes: their rows are skipped\n");
  std::vector<Row> rows;
  print_header();
  for (const std::string& name : only.empty() ? subject_names(tiny) : only) {
    run(name, tiny ? Effort{50, 3, 1, 20, 20, 10, 1, 60, 3, 1} : Effort{}, sections, [&](const Row& row) {
      rows.push_back(row);
      print(row);
    });
  }
  if (json.empty() || write_json(rows, json)) return 0;
  std::fprintf(stderr, "kerf: could not write %s\n", json.c_str());
  return 1;
}
