#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/cut_options.h"
#include "app/cut_report.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/load_mesh.h"
#include "app/progress_line.h"
#include "core/base/atomic_file.h"
#include "core/cut/stopwatch.h"
#include "core/document/document.h"
#include "core/mesh/load_notes.h"

namespace kerf {

namespace {

// One run of `kerf cut`, from its files to its folder.
class CutRun {
 public:
  explicit CutRun(CutOptions options) : options_(std::move(options)) {}

  Status run() {
    if (const auto s = merge_settings_file(options_); !s) return s;
    if (const auto s = check_cut_options(options_); !s) return s;
    if (const auto s = read_strokes(); !s) return s;
    if (const auto s = load(); !s) return s;
    if (const auto s = make_folder(); !s) return s;
    {
      const Stopwatch watch(job_.cut_s);
      ProgressLine line("cutting");
      const Progress cutting = line.progress();
      const double share = 1 / std::max(1.0, static_cast<double>(strokes_.size()));
      for (size_t i = 0; i < strokes_.size(); ++i) {
        const double before = share * static_cast<double>(i);
        const auto s = cut(strokes_[i], share_of(&cutting, before, before + share));
        if (!s) return error_or_stopped(s.error());
      }
    }
    return save();
  }

 private:
  Status read_strokes() {
    if (options_.path.empty()) return Done{};
    auto strokes = read_path_file(options_.path);
    if (!strokes) return strokes.error();
    strokes_ = std::move(*strokes);
    return Done{};
  }

  Status load() {
    World world;
    for (const std::string& file : options_.meshes) {
      if (interrupted()) return stopped();
      Result<BuiltMesh> built = [&] {
        const Stopwatch watch(job_.load_s);
        return load_mesh(file);
      }();
      if (!built) return built.error();
      tell(built->report);
      job_.input_faces += built->report.faces;
      job_.input_vertices += built->report.vertices;
      job_.input_area += built->report.area;
      job_.input_components += built->report.components;
      const Stopwatch watch(job_.build_tree_s);
      world.add(make_body(std::filesystem::path(file).stem().string(), std::move(*built)));
    }
    job_.input_min_angle = smallest_angle(world);
    diagonal_ = world.bounds().diagonal();
    document_ = Document(std::move(world));
    return Done{};
  }

  static void tell(const MeshReport& report) {
    for (const std::string& warning : report.warnings) std::cerr << "kerf: warning: " << warning << '\n';
    for (const std::string& note : dropped_notes(report.repairs)) std::cerr << "kerf: note: " << note << '\n';
  }

  Status make_folder() const {
    std::error_code error;
    std::filesystem::create_directories(options_.out, error);
    if (error) return failed(options_.out + ": the folder cannot be made: " + error.message());
    return Done{};
  }

  Status cut(const StrokePath& stroke, const Progress& progress) {
    const CutSettings settings = stroke_settings(options_, stroke, diagonal_);
    document_.apply(BeginStroke{settings, stroke.keys.front()});
    for (size_t k = 1; k < stroke.keys.size(); ++k) document_.apply(MoveStroke{stroke.keys[k]});
    document_.apply(EndStroke{});
    const size_t moves = document_.waiting();
    const size_t steps = options_.steps ? static_cast<size_t>(*options_.steps) : moves;
    for (size_t i = 0; i < steps; ++i) {
      const auto done = [&](size_t n) { return static_cast<double>(n) / static_cast<double>(steps); };
      const Progress stepping = share_of(&progress, done(i), done(i + 1));
      if (!stepping.report(0)) return cancelled();
      if (const auto s = step(moves * (i + 1) / steps - moves * i / steps, stepping); !s) return s;
    }
    return settle();
  }

  // A search for what came apart may be left when all moves are walked.
  Status settle() {
    while (document_.waiting() > 0) {
      const Result<StepResult> result = document_.step(1);
      if (!result) return result.error();
      job_.figures.add(result->figures);
    }
    return Done{};
  }

  Status step(size_t moves, const Progress& progress) {
    double seconds = 0;
    Result<StepResult> result = [&] {
      const Stopwatch watch(seconds);
      return document_.step(moves, &progress);
    }();
    if (!result) return result.error();
    ++job_.steps;
    job_.figures.add(result->figures);
    job_.removed_faces += result->delta.removed_faces;
    job_.removed_area += result->delta.removed_area;
    if (result->delta.removed_faces > 0) job_.step_s.push_back(seconds);
    return Done{};
  }

  struct Part {
    Extract extract;
    const Body* body;
  };

  std::vector<Part> parts() const {
    std::vector<Part> parts;
    for (const BodyId id : document_.world().ids()) {
      const Body& body = document_.world().body(id);
      for (const auto& faces : faces_by_piece(body, options_.split_all)) {
        parts.push_back({extract_faces(body, faces), &body});
      }
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.extract.area > b.extract.area; });
    return parts;
  }

  Status save() {
    std::vector<WrittenPiece> written;
    {
      const Stopwatch watch(job_.save_s);
      const std::string ending = options_.format.value_or("obj");
      const std::vector<Part> pieces = parts();
      ProgressLine line("writing");
      for (const Part& part : pieces) {
        if (!line.update(static_cast<double>(written.size()) / static_cast<double>(pieces.size()))) {
          return failed("stopped; of " + std::to_string(pieces.size()) + " pieces " +
                        std::to_string(written.size()) + " are written, and no report");
        }
        char name[40];
        std::snprintf(name, sizeof name, "piece-%04zu.%s", written.size(), ending.c_str());
        const Extract& e = part.extract;
        const MeshView view{e.positions, e.triangles, e.materials, part.body->material_names};
        if (const auto s = write_mesh(view, std::filesystem::path(options_.out) / name, *mesh_format(ending));
            !s) {
          return s;
        }
        written.push_back(
            {name, e.triangles.size(), e.positions.size(), e.boundary_edges, e.area, e.centroid});
      }
    }
    const auto report = cut_report(job_, document_.world(), settings_json(), written);
    return write_file_atomically(std::filesystem::path(options_.out) / "report.json", report.dump(2) + "\n");
  }

  nlohmann::ordered_json settings_json() const {
    const CutSettings s =
        stroke_settings(options_, strokes_.empty() ? StrokePath{} : strokes_.front(), diagonal_);
    nlohmann::ordered_json json = {{"radius", s.laser.radius},
                                   {"range", {s.laser.range.low, s.laser.range.high}},
                                   {"pattern", s.laser.pattern == Pattern::kRays4 ? "rays4" : "volume"},
                                   {"scheme", options_.scheme.value_or("longest-edge")},
                                   {"rim", options_.rim.value_or("faces")}};
    switch (s.resolution.rule) {
      case Resolution::Rule::kTargetEdge:
        json["target-edge"] = s.resolution.target_edge;
        break;
      case Resolution::Rule::kTolerance:
        json["tolerance"] = s.resolution.tolerance;
        break;
      case Resolution::Rule::kDepth:
        json["depth"] = s.resolution.depth;
        break;
    }
    json["model"] = "geometric";
    json["format"] = options_.format.value_or("obj");
    json["split-all"] = options_.split_all;
    return json;
  }

  CutOptions options_;
  std::vector<StrokePath> strokes_;
  Document document_;
  double diagonal_ = 0;
  CutJob job_;
};

}  // namespace

void add_cut_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("cut", "Cut meshes along a path and write the pieces and a report");
  auto options = std::make_shared<CutOptions>();
  add_cut_options(*command, *options);
  command->callback([options, &action] {
    action = [options] {
      catch_interrupts();
      const Status status = CutRun(*options).run();
      return status ? 0 : report_error(status.error());
    };
  });
}

}  // namespace kerf
