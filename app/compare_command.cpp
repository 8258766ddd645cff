#include <array>
#include <iostream>
#include <string>

#include "app/arguments.h"
#include "app/console.h"
#include "app/run_description.h"
#include "core/document/text/json.h"
#include "core/mesh/measures.h"
#include "core/tree/surface_comparison.h"

namespace kerf {

namespace {

struct CompareOptions {
  std::array<std::string, 2> meshes;
  std::string align = "none", unit = "m";
};

Result<Alignment> parse_alignment(const std::string& name) {
  if (name == "none") return Alignment::kNone;
  if (name == "centre") return Alignment::kCentre;
  if (name == "icp") return Alignment::kIcp;
  return bad_input("--align: \"" + name + "\" is not a valid value; the values are: none, centre, icp");
}

// A mesh file with its tree and its measures.
struct LoadedSurface {
  explicit LoadedSurface(BuiltMesh built)
      : mesh(std::move(built.mesh)),
        area(built.report.area),
        enclosed(enclosed_volume(mesh, 0.5 * (built.report.min + built.report.max))),
        tree(mesh) {}

  Surface surface() const { return {mesh, tree}; }
  nlohmann::ordered_json volume() const {
    return enclosed.closed ? nlohmann::ordered_json(enclosed.volume) : nlohmann::ordered_json();
  }

  Mesh mesh;
  double area;
  EnclosedVolume enclosed;
  AabbTree tree;
};

nlohmann::ordered_json to_json(const SurfaceComparison::Signed& s) {
  return {{"min", s.min}, {"max", s.max}, {"mean", s.mean}, {"histogram", s.histogram}};
}

nlohmann::ordered_json to_json(const SurfaceComparison& c, const RigidMotion& motion) {
  const glm::dquat& q = motion.rotation;
  nlohmann::ordered_json json{
      {"motion",
       {{"position", vector_json(motion.translation)}, {"orientation", std::array{q.w, q.x, q.y, q.z}}}},
      {"distance", {{"max", c.max}, {"mean", c.mean}, {"rms", c.rms}, {"p95", c.p95}}}};
  if (c.signed_by) json["signed"] = to_json(*c.signed_by);
  return json;
}

// One run of `kerf compare`.
class CompareRun {
 public:
  explicit CompareRun(CompareOptions options) : options_(std::move(options)) {}

  Status run() {
    if (const Status s = unpack(parse_alignment(options_.align), alignment_); !s) return s;
    if (const Status s = unpack(parse_unit(options_.unit), reading_.unit); !s) return s;
    record_mesh_unit(reading_.unit);
    record_inputs({options_.meshes.begin(), options_.meshes.end()});
    for (std::string& mesh : options_.meshes) {
      if (const Status s = unpack(input_file(mesh), mesh); !s) return s;
    }
    catch_interrupts();
    const auto a = load(options_.meshes[0]);
    if (!a) return a.error();
    const auto b = load(options_.meshes[1]);
    if (!b) return b.error();
    const auto report = compare(**a, **b);
    if (!report) return error_or_stopped(report.error());
    std::cout << with_run_description(*report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
              << '\n';
    return flush_output();
  }

 private:
  // On the heap, because a tree keeps no reference to a mesh that moves, but a Surface does.
  Result<std::unique_ptr<LoadedSurface>> load(const std::string& file) const {
    auto built = load_mesh(file, reading_);
    if (!built) return built.error();
    print_repairs(built->report);
    return std::make_unique<LoadedSurface>(std::move(*built));
  }

  Result<nlohmann::ordered_json> compare(const LoadedSurface& a, const LoadedSurface& b) const {
    ProgressLine line("comparing");
    const Progress progress = line.progress();
    ProgressShares shares(&progress);
    const Progress aligning = shares.next(0.5), measuring = shares.next(0.5);
    const auto motion = align_surfaces(a.surface(), b.surface(), alignment_, &aligning);
    if (!motion) return motion.error();
    const auto found = compare_surfaces(a.surface(), b.surface(), b.enclosed.closed, *motion, &measuring);
    if (!found) return found.error();
    nlohmann::ordered_json json{{"align", options_.align}};
    json.update(to_json(*found, *motion));
    json["area"] = {a.area, b.area};
    json["volume"] = {a.volume(), b.volume()};
    return json;
  }

  CompareOptions options_;
  Alignment alignment_ = Alignment::kNone;
  MeshReading reading_;
};

}  // namespace

void add_compare_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "compare", "Measure how far the surface of one mesh is from another, as JSON on standard output");
  auto o = std::make_shared<CompareOptions>();
  command->add_option("A", o->meshes[0], "The mesh file to measure, or - for standard input")->required();
  command->add_option("B", o->meshes[1], "The reference mesh file, or -, unless A is")->required();
  command->add_option("--align", o->align,
                      "Motion of A before it is measured: none, centre (equal centroids) or icp (least "
                      "squares of the distances) (none)");
  add_unit_option(*command, o->unit);
  on_call(
      *command, invocation, [o] { return CompareRun(*o).run(); },
      "kerf compare assets/meshes/sphere.obj assets/meshes/sphere.obj --align icp");
}

}  // namespace kerf
