#include <array>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/arguments.h"
#include "app/console.h"
#include "core/base/number_format.h"
#include "core/document/commands.h"
#include "core/document/extract.h"
#include "core/document/lost_looks.h"
#include "core/document/piece_looks.h"
#include "core/document/save.h"
#include "core/document/surface_files.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

struct PrepareOptions {
  std::string mesh, out, format, unit = "m";
  std::optional<int64_t> faces;
  std::optional<double> error;
  std::optional<std::string> subdivide;
  std::optional<int> smooth;
  bool turn_shells = false;

  // Returns the extension of the output, which sets its format.
  std::string ending() const {
    if (out != kStream) return std::filesystem::path(out).extension().string();
    return format.empty() ? "obj" : format;
  }
  // Returns true if the mesh is only written again.
  bool only_converts() const {
    return !faces && !error && !subdivide && !smooth && !turn_shells && unit == "m";
  }
};

std::optional<Subdivision> subdivision_named(const std::string& name) {
  for (size_t i = 0; i < kSubdivisionNames.size(); ++i) {
    if (name == kSubdivisionNames[i]) return static_cast<Subdivision>(i);
  }
  return std::nullopt;
}

Status check(const PrepareOptions& o) {
  if (o.faces && o.error) return bad_input("--simplify-error: cannot be given together with --simplify");
  const auto from = mesh_format(std::filesystem::path(o.mesh).extension().string());
  if (o.only_converts() && from && from == mesh_format(o.ending())) {
    return bad_input(
        "nothing to do; give --unit, --turn-shells, --simplify, --simplify-error, --subdivide or --smooth, "
        "or another format");
  }
  if (o.subdivide && !subdivision_named(*o.subdivide)) {
    return bad_input("--subdivide: \"" + *o.subdivide +
                     "\" is not a valid value; the values are: loop, sqrt3, midpoint");
  }
  if (o.out != kStream && !o.format.empty())
    return bad_input("--format: only for standard output (--out -); the extension of a file sets its format");
  if (o.out == kStream && !mesh_format(o.ending()))
    return bad_input("--format: \"" + o.format +
                     "\" is not a valid value; the values are: " + list_mesh_endings(""));
  if (o.out != kStream && !mesh_format(o.ending()))
    return bad_input("--out: " + o.out + " must end in " + list_mesh_endings());
  return Done{};
}

// One run of `kerf prepare`, from file to file.
class PrepareRun {
 public:
  explicit PrepareRun(PrepareOptions options) : options_(std::move(options)) {}

  Status run() {
    if (const auto s = check(options_); !s) return s;
    MeshReading reading;
    if (const auto s = unpack(parse_unit(options_.unit), reading.unit); !s) return s;
    if (const auto s = unpack(input_file(options_.mesh), options_.mesh); !s) return s;
    catch_interrupts();
    if (const auto s =
            input_files(std::array{std::filesystem::path(options_.mesh)}).check("--out", options_.out);
        !s)
      return s;
    auto built = load_mesh(options_.mesh, reading);
    if (!built) return built.error();
    if (options_.turn_shells) std::erase(built->report.warnings, built->report.overlap_warning);
    print_repairs(built->report);
    world_.add(make_body("", std::move(*built)));
    const size_t before = world_.live_faces();
    if (const auto s = prepare(); !s) return error_or_stopped(s.error());
    if (const auto s = write(); !s) return s;
    const std::string became = options_.only_converts() ? std::string(before == 1 ? " is" : " are")
                                                        : " became " + grouped(world_.live_faces());
    summarize(count_text(before, "face") + became + " in " + out_name());
    return Done{};
  }

 private:
  const Body& body() const { return world_.body(world_.ids()[0]); }
  std::string out_name() const { return options_.out == kStream ? "standard output" : options_.out; }

  Status prepare() {
    if (options_.turn_shells) {
      if (const auto s = step("turning shells", TurnShells()); !s) return s;
    }
    if (options_.faces || options_.error) {
      SimplifyTarget target;
      if (options_.faces) target.faces = static_cast<size_t>(*options_.faces);
      if (options_.error) target.error = *options_.error;
      if (const auto s = step("simplifying", SimplifyPiece{{}, target}); !s) return s;
      report_remaining(target.faces);
    }
    if (options_.subdivide) {
      if (world_.live_faces() > kMaxToSubdivide) return bad_input("--subdivide: the mesh has too many faces");
      const auto s = step("subdividing", SubdividePiece{{}, *subdivision_named(*options_.subdivide)});
      if (!s) return s;
    }
    if (!options_.smooth) return Done{};
    return step("smoothing", SmoothPiece{{}, static_cast<size_t>(*options_.smooth)});
  }

  // Runs a command on the only piece.
  template <typename Tool>
  Status step(const char* work, Tool tool) {
    ProgressLine line(work);
    const Progress progress = line.progress();
    tool.piece = {world_.ids()[0], 0};
    const Result<Delta> done = tool.run(world_, ++generation_, &progress);
    return done ? Status(Done{}) : done.error();
  }

  void report_remaining(size_t target) const {
    if (target == 0 || world_.live_faces() <= target) return;
    std::cerr << "kerf: note: " << world_.live_faces()
              << " faces are left, because removing more would move boundaries or features or flip a "
                 "face\n";
  }

  Status write() {
    if (interrupted()) return stopped();
    const std::vector<FaceId> faces = body().faces_of(0);
    const Extract e = extract_faces(body(), faces);
    const MeshFormat format = *mesh_format(options_.ending());
    MeshView view{e.positions, e.triangles, e.materials, body().material_names, {}, {}, e.colours};
    CornerLooks looks;
    if (format_row(format).uvs_and_normals)
      looks = looks_of(body(), faces, is_gltf(format) ? LookNormals::kAll : LookNormals::kSmooth);
    if (looks.any()) view.looks = &looks;
    const std::string part = part_name_of(body(), body().named_parts, faces);
    const auto names =
        std::ranges::count_if(body().named_parts, [](const MeshPart& p) { return !p.name.empty(); });
    const bool holds_name = format == MeshFormat::kObj || format == MeshFormat::k3mf || is_gltf(format);
    if (names == 1 && holds_name) view.name = view.object = part;
    if (body().looks) view.surfaces = body().looks->surfaces().get();
    SurfaceFiles surfaces(world_);
    if (format == MeshFormat::kObj && options_.out != kStream) {
      const std::filesystem::path out = options_.out;
      if (const auto s = surfaces.write(out.parent_path(), out.stem().string() + ".mtl"); !s) {
        surfaces.remove();
        return s;
      }
      view.mtl = surfaces.mtl_name();
      if (!view.mtl.empty()) view.material_names = surfaces.names(body());
    }
    const auto write_to = [&](const std::filesystem::path& file) { return write_mesh(view, file, format); };
    const Status written =
        options_.out == kStream ? write_to_output(options_.ending(), write_to) : write_to(options_.out);
    if (!written) {
      surfaces.remove();
      return written;
    }
    LostLooks lost;
    lost.add(body(), faces, e, format);
    std::vector<std::string> notes;
    lost.add_notes(format, notes);
    if (const auto note = precision_note(precision_loss(view, format), format, "write OBJ, PLY or OFF"))
      notes.push_back(*note);
    if (format == MeshFormat::kObj && options_.out == kStream && view.surfaces != nullptr)
      notes.emplace_back(
          "standard output holds no material library: materials keep their names only; use --format glb");
    if (names == 1 && !holds_name) notes.emplace_back("the name of the part is not written");
    if (names > 1) notes.push_back("the names of " + std::to_string(names) + " parts are not written");
    for (const std::string& note : notes) warn(out_name() + ": " + note);
    return Done{};
  }

  PrepareOptions options_;
  World world_;
  uint32_t generation_ = 0;
};

}  // namespace

void add_prepare_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "prepare", "Convert a mesh, turn its inner shells, simplify, subdivide or smooth it, in this order");
  auto o = std::make_shared<PrepareOptions>();
  command->footer(
      "Boundaries, edges of three faces or more and edges between materials are features and are kept.");
  command->add_option("MESH", o->mesh, "A mesh file, or - for standard input: " + list_mesh_titles())
      ->required();
  command
      ->add_option("-o,--out", o->out,
                   "The file to write; its extension sets the format: " + list_mesh_endings("") +
                       "; - for standard output")
      ->required();
  command->add_option("--format", o->format, "With --out -: format of the mesh (obj)");
  add_unit_option(*command, o->unit);
  command->add_flag(
      "--turn-shells", o->turn_shells,
      "Flip closed parts that lie inside others and face the same way, so that they become cavities");
  add_number(*command, "--simplify", o->faces, {1, FaceId::kNone}, "Simplify to at most this many faces");
  add_number(*command, "--simplify-error", o->error, kPositive,
             "Instead: maximum approximate distance between the old and the new surface, in metres");
  command->add_option(
      "--subdivide", o->subdivide,
      "loop and sqrt3 round the surface, midpoint keeps it; a face becomes four (sqrt3: three)");
  add_number(*command, "--smooth", o->smooth, {1, kMaxSmoothing},
             "Number of passes that move each vertex halfway to the mean of its neighbours");
  on_call(
      *command, invocation, [o] { return PrepareRun(*o).run(); },
      "kerf prepare assets/meshes/knot.obj --simplify 2000 --out light.obj");
}

}  // namespace kerf
