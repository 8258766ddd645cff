#include <malloc.h>

#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdio>

#include "tests/bench/run_progress.h"
#include "tests/bench/sections.h"
#include "tests/support/checkout.h"

namespace kerf::bench {
namespace {

void say_what_is_skipped() {
  if (!has_embree()) std::printf("built without Embree 3 (libembree-dev): the rows beside it are skipped\n");
  if (!has_cgal()) std::printf("built without CGAL (libcgal-dev): the rows beside it are skipped\n");
  if (!has_manifold())
    std::printf("KERF_MANIFOLD named no build of Manifold: the rows beside it are skipped\n");
}

const Effort kTiny{50, 3, 1, 20, 20, 10, 1, 60, 3, 1, 2000, 1000, 3};
const Effort kLong{.published_cuts = 34, .scale_faces = 30'000'000};

struct Section {
  std::string name;
  void (*run)(const Subject&, const Effort&, const Report&);
  bool of_mesh;  // runs on each mesh; otherwise once, whatever the mesh
  size_t rows;   // at most
};

std::vector<Section> all_sections(const Effort& effort) {
  return {{"cut", bench_cut, true, 7},
          {"build", bench_build, true, 5},
          {"queries", bench_queries, true, 16},
          {"edits", bench_edits, true, 4},
          {"kernel", bench_kernel, true, 4},
          {"shadows", bench_shadows, true, 2},
          {"heat", bench_heat, true, 1},
          {"files", bench_files, true, 7},
          {"fall", bench_fall, false, 18},
          {"game", bench_game, false, 14},
          {"scale", bench_scale, false, 6},
          {"league", bench_league, false, 5},
          {"laser", bench_laser, false, 2 * effort.published_cuts}};
}

std::vector<std::string> names_of(const std::vector<Section>& sections) {
  std::vector<std::string> names;
  for (const Section& s : sections) names.push_back(s.name);
  return names;
}

// These have a table of their own on the page.
std::vector<Row> without_published_cuts(std::vector<Row> rows) {
  std::erase_if(rows, [](const Row& row) { return row.unit == "m/min"; });
  return rows;
}

// The chosen sections, on the chosen meshes where they are of a mesh.
class Run {
 public:
  Run(const Effort& effort, std::vector<Section> sections, std::vector<std::string> meshes)
      : effort_(effort),
        sections_(std::move(sections)),
        meshes_(std::move(meshes)),
        progress_(count_sections()) {}

  std::vector<Row> all() {
    print_header();
    for (const std::string& mesh : meshes_) run_on(mesh);
    for (const Section& section : sections_) {
      if (!section.of_mesh) run(section, {}, section.name);
    }
    progress_.end();
    return std::move(rows_);
  }

 private:
  size_t count_sections() const {
    const auto of_mesh = static_cast<size_t>(
        std::count_if(sections_.begin(), sections_.end(), [](const Section& s) { return s.of_mesh; }));
    return of_mesh * meshes_.size() + sections_.size() - of_mesh;
  }

  void run_on(const std::string& mesh) {
    if (std::none_of(sections_.begin(), sections_.end(), [](const Section& s) { return s.of_mesh; })) return;
    const Subject subject = make_subject(mesh);
    if (subject.mesh.live_faces() == 0) {
      std::printf("%s could not be read: its rows are skipped\n", mesh.c_str());
      return;
    }
    for (const Section& section : sections_) {
      if (section.of_mesh) run(section, subject, section.name + " of " + mesh);
    }
  }

  void run(const Section& section, const Subject& subject, const std::string& what) {
    progress_.begin_section(what, section.rows);
    section.run(subject, effort_, [&](const Row& row) {
      rows_.push_back(row);
      progress_.clear();
      print(row);
      progress_.next_row();
    });
  }

  Effort effort_;
  std::vector<Section> sections_;
  std::vector<std::string> meshes_;
  RunProgress progress_;
  std::vector<Row> rows_;
};

}  // namespace
}  // namespace kerf::bench

int main(int argc, char** argv) {
  using namespace kerf::bench;
  mallopt(M_MMAP_THRESHOLD, 1 << 20);  // as app/main.cpp
  CLI::App app{"The tree beside its peers: processor time of one thread, medians"};
  std::string json;
  std::vector<std::string> only;
  std::vector<std::string> sections = names_of(all_sections({}));
  bool tiny = false, everything = false, write = false;
  app.add_option("--json", json, "Write the table to this file as well");
  app.add_option("--mesh", only, "Only these meshes");
  app.add_flag("--tiny", tiny, "Small inputs, to see that it runs");
  app.add_flag("--long", everything, "Also what takes longer than ten minutes")->excludes("--tiny");
  app.add_option("--section", sections, "Only these sections")->check(CLI::IsMember(sections));
  app.add_flag("--write", write, "Write the table to the page of the benchmarks")
      ->excludes("--mesh")
      ->excludes("--tiny")
      ->excludes("--section");
  CLI11_PARSE(app, argc, argv);

  say_what_is_skipped();
  if (!tiny && subject_names(false).size() == 1)
    std::printf("KERF_TEST_MESHES names no folder with real meshes: their rows are skipped\n");
  const Effort effort = tiny ? kTiny : everything ? kLong : Effort{};
  std::vector<Section> selected = all_sections(effort);
  std::erase_if(selected, [&](const Section& s) {
    return std::find(sections.begin(), sections.end(), s.name) == sections.end();
  });
  const std::vector<Row> rows =
      Run(effort, std::move(selected), only.empty() ? subject_names(tiny) : only).all();
  const auto failed = [](const std::string& file) {
    std::fprintf(stderr, "kerf: could not write %s\n", file.c_str());
    return 1;
  };
  if (!json.empty() && !write_json(rows, json)) return failed(json);
  const std::filesystem::path page = kerf::test::checkout() / "tests" / "bench" / "README.md";
  if (write && !write_page(without_published_cuts(rows), page)) return failed(page.string());
  return 0;
}
