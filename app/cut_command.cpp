#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/console.h"
#include "app/cut_output.h"
#include "app/job_input.h"
#include "app/knife_options.h"
#include "app/run_description.h"
#include "core/base/platform.h"
#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/cut/stopwatch.h"
#include "core/cut/thermal_step.h"
#include "core/document/command_queue.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/material_table.h"
#include "core/document/stroke_path.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

// Options of `kerf cut`. The default of an empty option depends on the meshes and the path file.
struct CutOptions {
  std::vector<std::string> meshes;
  KnifeOptions knife;
  std::string path, out, settings, journal, provenance;
  JobInput job;  // a drawing or a program instead of the path
  std::optional<double> radius, target_edge, tolerance, power;
  std::optional<double> settle, ground, thickness, density;
  std::optional<std::string> range, pattern, scheme, rim, model, material, format, assist, cut_material;
  std::optional<std::string> colliders, collider_names;
  std::optional<int> depth;
  std::optional<int> steps;
  bool split_all = false;
  bool single_file = false;
  bool solid = false;
  bool recentre = false;
  bool turn_shells = false;
};

constexpr NumberRange kFall{0.001, 3600, "s", true};

using Names = std::vector<std::string>;

Names format_names() {
  Names names;
  for (const MeshFormatRow& row : kMeshFormats) names.emplace_back(row.ending);
  return names;
}

// Parses "MIN,MAX", an interval in metres.
Result<Interval> parse_range(const std::string& text) {
  const auto wrong = bad_input("--range: must be MIN,MAX in metres, 0 <= MIN <= MAX");
  const size_t comma = text.find(',');
  if (comma == std::string::npos) return wrong;
  Interval range;
  const std::string_view view = text;
  if (!parse_number(view.substr(0, comma), range.low) || !parse_number(view.substr(comma + 1), range.high))
    return wrong;
  if (range.low < 0 || range.low > range.high) return wrong;
  return range;
}

// Visits the options that a settings file may contain: key, allowed values, help.
template <typename Visitor>
void visit_options(CutOptions& o, Visitor& v) {
  v.number("radius", o.radius, kPositive, "Beam radius in metres (diagonal/400, or that of the path file)");
  v.range("range", o.range, "MIN,MAX: the part of the beam that cuts, in metres (0 to 10 diagonals)");
  v.choice("pattern", o.pattern, {"volume", "rays4"}, "volume or rays4 (volume)");
  v.choice("scheme", o.scheme, {"one-to-four", "longest-edge"},
           "Subdivision of faces: one-to-four or longest-edge (longest-edge)");
  v.choice("rim", o.rim, {"faces", "smooth"}, "Rim of the cut: faces (jagged) or smooth (faces)");
  v.flag("solid", o.solid,
         "The meshes are solids: walls cap the cut, so pieces are closed (implies --rim smooth)");
  v.text("cut-material", o.cut_material,
         "Material of the cut faces of solids: one of the mesh, or a new one (cut)");
  v.flag("turn-shells", o.turn_shells,
         "Flip closed parts inside others that face the same way, which makes them cavities");
  v.number("target-edge", o.target_edge, kPositive,
           "Longest edge under the beam in metres (radius/4; thermal: radius)");
  v.number("tolerance", o.tolerance, kPositive,
           "Instead: maximum overshoot of removed faces beyond the beam, in metres");
  v.whole("depth", o.depth, 0, Resolution::kMaxDepth, "Instead: maximum refinement level");
  v.whole("steps", o.steps, 1, 1'000'000, "Number of steps per stroke (as many as the sweep needs)");
  v.choice("model", o.model, {"geometric", "thermal"},
           "Cut mode: geometric removes faces at once, thermal when they have absorbed enough energy "
           "(geometric)");
  v.text("material", o.material, "Material of the sheets (mild-steel); kerf materials lists them");
  v.number("power", o.power, kPositive, "Beam power in watts (2000, or that of the path file)");
  v.choice("assist", o.assist, {"none", "oxygen"},
           "Assist gas of the thermal model: mild steel burns in oxygen (none)");
  v.choice("format", o.format, format_names(),
           ("Format of the pieces: " + list_mesh_endings("") + " (obj)").c_str());
  v.choice(
      "colliders", o.colliders, {"hull"},
      "For glTF: add a convex hull of at most 64 vertices to each piece, with its mass properties (none)");
  v.choice("collider-names", o.collider_names, {"unreal", "godot"},
           "Names of the hulls: UCX_NODE_00 for unreal, NODE-convcolonly for godot (unreal)");
  v.flag("single-file", o.single_file, "For glTF and 3MF: write all pieces to one file, such as pieces.glb");
  v.flag("split-all", o.split_all, "Make every connected component a piece");
  v.flag("recentre", o.recentre,
         "Write coordinates relative to an origin near the meshes, stated in the report (\"origin\")");
  v.number("settle", o.settle, kFall,
           "Simulate this many seconds of falling after the last stroke before the pieces are written");
  v.number("ground", o.ground, kFinite,
           "With --settle: height of the ground in metres (the lowest point of all meshes)");
  v.number("thickness", o.thickness, kThickness.range, "Thickness of the sheets, in metres (0.001)");
  v.number("density", o.density, kDensity.range, "Density of the sheets in kg/m3 (7850, that of mild steel)");
}

// Offers the options on the command line.
struct Offer {
  CLI::App& command;

  template <typename T>
  void add(const char* key, T& x, const std::string& help) {
    command.add_option("--" + std::string(key), x, help);
  }
  void number(const char* key, std::optional<double>& x, const NumberRange& range, const char* help) {
    add(key, x, help_with_limits(help, range));
  }
  void whole(const char* key, std::optional<int>& x, int least, int most, const char* help) {
    add(key, x, help_with_limits(help, {static_cast<double>(least), static_cast<double>(most)}));
  }
  void choice(const char* key, std::optional<std::string>& x, const Names&, const char* help) {
    add(key, x, help);
  }
  void text(const char* key, std::optional<std::string>& x, const char* help) { add(key, x, help); }
  void range(const char* key, std::optional<std::string>& x, const char* help) { add(key, x, help); }
  void flag(const char* key, bool& x, const char* help) {
    command.add_flag("--" + std::string(key), x, help);
  }
};

// Reads one entry of a settings file, unless the command line has the option.
struct FileEntry {
  const std::string& key;
  const JsonValue& value;
  Status status;

  template <typename T, typename Read>
  void take(const char* option, std::optional<T>& x, Read read) {
    if (option != key) return;
    const auto found = read();
    status = found ? Status(Done{}) : Status(found.error());
    if (found && !x) x = *found;
  }
  void number(const char* option, std::optional<double>& x, const NumberRange&, const char*) {
    take(option, x, [&] { return value.number(); });
  }
  void whole(const char* option, std::optional<int>& x, int, int, const char*) {
    take(option, x, [&]() -> Result<int> {
      if (!value.json().is_number_integer()) return value.wrong("must be a whole number");
      const auto number = value.json().get<int64_t>();
      if (std::abs(number) > 1'000'000'000) return value.wrong("is out of range");
      return static_cast<int>(number);
    });
  }
  void text(const char* option, std::optional<std::string>& x, const char*) {
    take(option, x, [&] { return value.text(); });
  }
  void choice(const char* option, std::optional<std::string>& x, const Names&, const char* help) {
    text(option, x, help);
  }
  void range(const char* option, std::optional<std::string>& x, const char*) {
    take(option, x, [&]() -> Result<std::string> {
      if (const auto range = value.interval(); !range) return range.error();
      return value.json()[0].dump() + "," + value.json()[1].dump();
    });
  }
  void flag(const char* option, bool& x, const char*) {
    if (option != key) return;
    status = value.json().is_boolean() ? Status(Done{}) : Status(value.wrong("must be true or false"));
    if (status) x = x || value.json().get<bool>();
  }
};

// Lists the keys.
struct Keys {
  std::vector<std::string> all;

  void number(const char* key, auto&, const NumberRange&, const char*) { all.emplace_back(key); }
  void whole(const char* key, auto&, int, int, const char*) { all.emplace_back(key); }
  void choice(const char* key, auto&, const Names&, const char*) { all.emplace_back(key); }
  void text(const char* key, auto&, const char*) { all.emplace_back(key); }
  void range(const char* key, auto&, const char*) { all.emplace_back(key); }
  void flag(const char* key, bool&, const char*) { all.emplace_back(key); }
};

// Checks the values. The error names the first wrong one.
struct Check {
  Status status = Done{};

  void expect(bool right, const char* key, const std::string& words) {
    if (status && !right) status = bad_input("--" + std::string(key) + ": " + words);
  }
  void number(const char* key, const std::optional<double>& x, const NumberRange& range, const char*) {
    expect(!x || range.contains(*x), key, x ? out_of_limits(*x, range) : "");
  }
  void whole(const char* key, const std::optional<int>& x, int least, int most, const char*) {
    expect(!x || (*x >= least && *x <= most), key,
           "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  void choice(const char* key, const std::optional<std::string>& x, const Names& names, const char*) {
    if (!x || std::find(names.begin(), names.end(), *x) != names.end()) return;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    expect(false, key, "\"" + *x + "\" is not a valid value; the values are: " + list);
  }
  void range(const char*, const std::optional<std::string>& x, const char*) {
    if (!x || !status) return;
    if (const auto range = parse_range(*x); !range) status = range.error();
  }
  void text(const char*, const std::optional<std::string>&, const char*) {}
  void flag(const char*, bool, const char*) {}
};

constexpr const char* kPathFile =
    R"(The path file holds strokes. Between the keys of a stroke the origin of the beam
moves on a straight line and its direction along the shorter arc; the beam is on
for the whole of the stroke. Lengths are in metres, and "t" is in seconds: it
gives the order of the keys and, for the thermal model, the speed. "laser" and
what it holds may be left out; it may also hold "wavelength" and "focus" (metres),
"pulse_rate" (Hz) and "duty" (0 to 1).
  {"strokes": [{"laser": {"radius": 0.01, "range": [0, 10], "power": 2000},
                "keys": [{"t": 0, "origin": [-1.5, 3, 0.4], "direction": [0, -1, 0]},
                         {"t": 1, "origin": [1.5, 3, 0.4], "direction": [0, -1, 0]}]}]}
One key is a beam that stands still. Directions need not have unit length.)";

bool is_resolution(const std::string& key) {
  return key == "target-edge" || key == "tolerance" || key == "depth";
}

// Adds the options to the subcommand. Parsing fills `options`, which must outlive it.

void add_cut_options(CLI::App& command, CutOptions& o) {
  command.footer(kPathFile);
  command
      .add_option("MESH", o.meshes,
                  "Mesh files (" + list_mesh_titles(", ") +
                      "), cut together, - for one on standard input, or a scene (.json)")
      ->required();
  command.add_option("--path", o.path,
                     "The strokes of the laser (JSON), or - for standard input; default: no strokes");
  o.knife.add_to(command);
  o.job.add_to(command);
  command.add_option("-o,--out", o.out, "The folder for the pieces and report.json")->required();
  Offer offer{command};
  visit_options(o, offer);
  command.add_option("--journal", o.journal, "The file for the journal (.kerf) of the cut, for kerf replay");
  command.add_option("--provenance", o.provenance,
                     "The file (.npz) for the source face of each face of the pieces and the barycentric "
                     "coordinates of its corners there");
  command.add_option("--settings", o.settings, "A JSON file with the same keys; the command line wins");
}

// Fills empty options from the file of --settings, a JSON object with the same keys. The error names the file
// and the key; some options may be filled then.
Status merge_settings_file(CutOptions& o) {
  if (o.settings.empty()) return Done{};
  const auto text = read_text_file(o.settings);
  if (!text) return text.error();
  const auto json = parse_json(*text, o.settings);
  if (!json) return json.error();
  const JsonValue root(*json, o.settings);
  if (const auto object = root.object(); !object) return object;
  // A resolution on the command line replaces that of the file, even if they are of different kinds.
  const bool has_resolution = o.target_edge || o.tolerance || o.depth;
  Keys keys;
  visit_options(o, keys);
  for (const auto& item : json->items()) {
    if (has_resolution && is_resolution(item.key())) continue;
    const JsonValue value = root[item.key()];
    FileEntry entry{
        item.key(), value,
        value.wrong("is not a setting of this version" + nearest_name_hint(item.key(), keys.all))};
    visit_options(o, entry);
    if (!entry.status) return entry.status;
  }
  return Done{};
}

Status check_solid(const CutOptions& o) {
  if (o.cut_material && (o.cut_material->empty() || *o.cut_material != one_line(*o.cut_material)))
    return bad_input("--cut-material: must be a name of one line, and not empty");
  if (!o.solid) return Done{};
  if (o.pattern == "rays4")
    return bad_input("--solid: walls need the whole volume of the beam; remove --pattern rays4");
  if (o.model == "thermal")
    return bad_input("--solid: walls need the geometric model; remove --model thermal");
  if (o.rim == "faces") return bad_input("--solid: walls need a smooth rim; remove --rim faces");
  return Done{};
}

// Checks the values in the order of the options. The error names the first wrong option.
Status check_gltf_options(const CutOptions& o) {
  if (o.collider_names && !o.colliders) return bad_input("--collider-names: requires --colliders");
  const MeshFormat format = *mesh_format(o.format.value_or("obj"));
  if (o.colliders && !is_gltf(format))
    return bad_input("--colliders: only glTF holds colliders; add --format glb or gltf");
  if (o.single_file && !holds_several_meshes(format))
    return bad_input("--single-file: requires --format glb, gltf or 3mf");
  return Done{};
}

Status check_cut_options(CutOptions o) {
  Check check;
  visit_options(o, check);
  if (!check.status) return check.status;
  if (o.target_edge.has_value() + o.tolerance.has_value() + o.depth.has_value() > 1) {
    return bad_input("--target-edge, --tolerance and --depth: give only one of them");
  }
  if (o.ground && !o.settle) return bad_input("--ground: requires --settle");
  if (const Status s = check_gltf_options(o); !s) return s;
  return check_solid(o);
}

// Makes the rim smooth, as walls require, unless the options name a rim or a beam that leaves none.
void prefer_smooth_rim(CutOptions& o) {
  if (!o.rim && o.pattern != "rays4" && o.model != "thermal") o.rim = "smooth";
}

// Returns the settings of one stroke. Options take precedence over the laser of the path file, and that over
// the defaults for a bounding box with this diagonal [m]. Precondition: check_cut_options() succeeded.
CutSettings stroke_settings(const CutOptions& o, const StrokePath& stroke, double diagonal) {
  CutSettings settings = default_settings(stroke, diagonal);
  if (o.radius) settings.laser.radius = *o.radius;
  if (o.range) settings.laser.range = *parse_range(*o.range);
  if (o.power) settings.laser.power = *o.power;
  if (o.model == "thermal") settings.model = Model::kThermal;
  if (o.assist == "oxygen") settings.laser.assist = Assist::kOxygen;
  if (o.pattern == "rays4") settings.laser.pattern = Pattern::kRays4;
  Resolution& resolution = settings.resolution;
  if (o.rim == "smooth") resolution.rim = Rim::kSmooth;
  if (o.scheme) resolution.scheme = o.scheme == "one-to-four" ? Scheme::kOneToFour : Scheme::kLongestEdge;
  const double finest = settings.model == Model::kThermal ? settings.laser.radius : settings.laser.radius / 4;
  resolution.target_edge = o.target_edge.value_or(positive(finest));
  resolution.tolerance = o.tolerance.value_or(positive(settings.laser.radius / 8));
  resolution.depth = o.depth.value_or(resolution.depth);
  if (o.tolerance) resolution.rule = Resolution::Rule::kTolerance;
  if (o.depth) resolution.rule = Resolution::Rule::kDepth;
  return settings;
}

// Returns a point near the centre. Its coordinates are multiples of the largest power of two that is at most
// the diagonal, which minimises the rounding of differences to it.
Vec3 near_origin(const World::Bounds& bounds) {
  const double diagonal = bounds.diagonal();
  if (!(diagonal > 0) || !std::isfinite(diagonal)) return bounds.min;
  const double unit = std::ldexp(1.0, std::ilogb(diagonal));
  return unit * glm::round((0.5 * bounds.min + 0.5 * bounds.max) / unit);
}

// One run of `kerf cut`, from its files to its folder.
class CutRun {
 public:
  explicit CutRun(CutOptions options) : options_(std::move(options)) {}

  Status run() {
    if (const auto s = open_inputs(); !s) return s;
    catch_interrupts();
    if (const auto s = merge_settings_file(options_); !s) return s;
    if (const auto s = check_cut_options(options_); !s) return s;
    if (const auto s = read_scene_description(); !s) return s;
    if (const auto s = read_strokes(); !s) return s;
    if (const auto s = options_.knife.read(); !s) return s;
    if (const auto s = options_.job.read(!options_.path.empty(), options_.radius); !s) return s;
    if (const auto s = read_material(); !s) return s;
    const PiecesFolder folder{
        options_.out,        options_.format.value_or("obj"),
        options_.split_all,  options_.solid,
        options_.provenance, options_.colliders ? options_.collider_names.value_or("unreal") : "",
        options_.single_file};
    if (const auto s = check_outputs(folder); !s) return s;
    if (const auto s = load(); !s) return s;
    options_.job.add_strokes(bounds_, strokes_, job_);
    if (const auto s = begin_journal(); !s) return s;
    if (const auto s = folder.make(); !s) return s;
    if (const auto s = cut_strokes(); !s) return s;
    if (const auto s = cut_planes(); !s) return s;
    if (const auto s = settle(); !s) return s;
    for (const Command& move : options_.knife.lay_flat(document_.world())) {
      if (const Outcome laid = document_.apply(move); !laid.ok()) return laid.error();
    }
    // If the journal cannot be written, the pieces are.
    const Status journal = end_journal();
    const StrokePath first = strokes_.empty() ? StrokePath{} : strokes_.front();
    const auto written = folder.write(job_, document_.world(), stroke_settings(options_, first, diagonal_));
    if (!written) return written.error();
    for (size_t i = loaded_notes_; i < job_.notes.size(); ++i) warn(job_.notes[i]);
    if (!job_.missed.empty()) warn(missed_text(job_, stroke_file()));
    summarize(cut_summary(job_, strokes_.size(), options_.knife.planes(), written->size(), options_.out));
    return journal;
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Reads standard input if it is a mesh or the path.
  Status open_inputs() {
    std::vector<std::string> inputs = options_.meshes;
    for (const std::string& file : {options_.path, options_.job.drawing, options_.job.gcode}) {
      if (!file.empty()) inputs.push_back(file);
    }
    record_inputs(std::move(inputs));
    const bool streamed = std::ranges::find(options_.meshes, kStream) != options_.meshes.end();
    if (streamed && !options_.journal.empty())
      return bad_input(
          "--journal: a journal cannot name a mesh from standard input; save the mesh in a file");
    if (const Status s = unpack(input_file(options_.path), options_.path); !s) return s;
    for (std::string& mesh : options_.meshes) {
      if (const Status s = unpack(input_file(mesh), mesh); !s) return s;
    }
    return Done{};
  }

  const std::string& stroke_file() const {
    if (!options_.job.file().empty()) return options_.job.file();
    return options_.path.empty() ? options_.meshes.front() : options_.path;
  }

  // A scene must be the only file; its own strokes are cut unless --path is given.
  Status read_scene_description() {
    for (const std::string& file : options_.meshes) {
      auto scene = read_description(file);
      if (!scene) return scene.error();
      if (options_.meshes.size() == 1) {
        strokes_ = scene->strokes;
        scene_ = std::move(*scene);
      } else if (std::filesystem::path(file).extension() == ".json") {
        return bad_input(file +
                         ": a scene cannot be combined with other files; list the meshes in the scene");
      } else {
        scene_.bodies.push_back(std::move(scene->bodies.front()));
      }
    }
    return Done{};
  }

  Status read_strokes() {
    if (options_.path.empty()) return Done{};
    return unpack(read_path_file(options_.path), strokes_);
  }

  Status read_material() {
    if (!options_.material) return Done{};
    const auto materials = load_materials(assets_folder() / "materials.json");
    if (!materials) return materials.error();
    if (const Material* material = find_material(*materials, *options_.material)) {
      substance_ = material->substance;
      return Done{};
    }
    std::string names;
    for (const Material& material : *materials) names += (names.empty() ? "" : ", ") + material.name;
    return bad_input("--material: \"" + *options_.material + "\" is unknown; the materials are: " + names);
  }

  Status check_outputs(const PiecesFolder& folder) const {
    InputFiles inputs;
    for (const std::string& file : options_.meshes) inputs.add(file);
    inputs.add_meshes(scene_);
    for (const std::string& file : {options_.path, options_.settings, options_.job.file()}) inputs.add(file);
    if (options_.material) inputs.add(assets_folder() / "materials.json");
    if (const Status free = folder.check("--out", inputs); !free) return free;
    if (!options_.provenance.empty()) {
      if (folder.may_write(options_.provenance))
        return bad_input("--provenance: " + options_.provenance +
                         " is a name of a piece or of the report; use another name");
      if (const Status free = inputs.check("--provenance", options_.provenance); !free) return free;
    }
    if (options_.journal.empty()) return Done{};
    if (folder.may_write(options_.journal))
      return bad_input("--journal: " + options_.journal +
                       " is a name of a piece or of the report; use another name");
    return inputs.check("--journal", options_.journal);
  }

  Status load() {
    World world;
    for (SceneBody& body : scene_.bodies) {
      if (interrupted()) return stopped();
      Result<BuiltMesh> built = [&] {
        const Stopwatch watch(job_.load_s);
        return options_.provenance.empty() ? load_mesh(body.mesh) : load_mesh_with_corners(body.mesh);
      }();
      if (!built) return built.error();
      print_repairs(built->report);
      job_.record_loaded(built->report);
      job_.notes.insert(job_.notes.end(), built->report.warnings.begin(), built->report.warnings.end());
      loaded_notes_ = job_.notes.size();
      const Stopwatch watch(job_.build_tree_s);
      if (substance_) body.sheet.substance = *substance_;
      if (substance_) body.sheet.density = substance_->density;
      if (options_.thickness) body.sheet.thickness = *options_.thickness;
      if (options_.density) body.sheet.density = *options_.density;
      if (options_.solid) body.solid = Solidity::kSolid;
      if (options_.cut_material) body.cut_material = *options_.cut_material;
      const auto added = add_scene_body(body, make_body(body.name, std::move(*built)), world);
      if (!added) return added.error();
    }
    if (!options_.journal.empty()) {
      if (const auto noted = record_hashes(scene_); !noted) return noted;
    }
    if (any_is_solid(world)) prefer_smooth_rim(options_);
    job_.input_min_angle = smallest_angle(world);
    bounds_ = world.bounds();
    diagonal_ = bounds_.diagonal();
    if (options_.recentre) job_.origin = near_origin(bounds_);
    document_ = Document(std::move(world));
    document_.set_window(0);  // no undo here
    document_.set_face_budget(usual_face_budget(machine_memory()));
    return turn_shells();
  }

  Status turn_shells() {
    if (!options_.turn_shells) return Done{};
    ProgressLine line("turning shells");
    const Progress turning = line.progress();
    const std::vector<BodyId> bodies = document_.world().ids();
    for (const BodyId id : bodies) {
      const Outcome turned = document_.apply(TurnShells{{id, 0}}, &turning);
      if (!turned.ok()) return error_or_stopped(turned.error());
    }
    return Done{};
  }

  Status cut_strokes() {
    const Stopwatch watch(job_.cut_s);
    ProgressLine line("cutting");
    const Progress cutting = line.progress();
    const double share = 1 / std::max(1.0, static_cast<double>(strokes_.size()));
    for (size_t i = 0; i < strokes_.size(); ++i) {
      const double before = share * static_cast<double>(i);
      const Progress own = share_of(&cutting, before, before + share);
      const CutSettings settings = stroke_settings(options_, strokes_[i], diagonal_);
      const auto s = settings.laser.radius == 0 ? cut_by_knife(strokes_[i], settings, own)
                                                : cut(strokes_[i], settings, own);
      if (!s) return error_or_stopped(s.error());
      if (!options_.journal.empty()) mark_state(document_, marks_);
    }
    return Done{};
  }

  Status cut_by_knife(const StrokePath& stroke, const CutSettings& settings, const Progress& progress) {
    const Result<bool> met = run_knife(stroke_commands(stroke, settings).front(), progress);
    if (!met) return met.error();
    if (!*met) job_.missed.push_back(job_.strokes);
    ++job_.strokes;
    return Done{};
  }

  Status cut(const StrokePath& stroke, const CutSettings& settings, const Progress& progress) {
    job_.begin_stroke();
    job_.thermal = settings.model == Model::kThermal;
    if (job_.thermal && scales_removal(settings) && !warned_scaled_) {
      warned_scaled_ = true;
      std::cerr
          << "kerf: faces may be wider than the kerf (two radii) at this resolution: each is removed for "
             "the energy of a strip as wide as the kerf\n";
    }
    for (const Command& command : stroke_commands(stroke, settings)) document_.apply(command);
    const size_t moves = document_.waiting();
    const size_t steps = options_.steps ? static_cast<size_t>(*options_.steps) : moves;
    for (size_t i = 0; i < steps; ++i) {
      const auto done = [&](size_t n) { return static_cast<double>(n) / static_cast<double>(steps); };
      const Progress stepping = share_of(&progress, done(i), done(i + 1));
      if (!stepping.report(0)) return cancelled();
      if (const auto s = step(moves * (i + 1) / steps - moves * i / steps, stepping); !s) return s;
    }
    job_.end_stroke();
    return Done{};
  }

  // Executes the given number of moves in as many steps as needed. After the last move it completes the
  // search for separated parts.
  Status step(size_t moves, const Progress& progress) {
    auto began = Clock::now();
    QueueRun how;
    how.moves_a_step = moves;
    how.leave = document_.waiting() - moves;
    how.progress = &progress;
    how.told = [&](const Result<StepResult>& step) -> Status {
      if (!step) return step.error();
      job_.record_step(*step, document_.world(), std::chrono::duration<double>(Clock::now() - began).count());
      began = Clock::now();
      return Done{};
    };
    const Status ran = run_queue(document_, how);
    if (ran) ++job_.steps;
    return ran;
  }

  Status cut_planes() {
    const Stopwatch watch(job_.cut_s);
    ProgressLine line("cutting");
    const Progress cutting = line.progress();
    const Status cut = options_.knife.cut(
        document_.world(),
        [&](const Command& command) {
          Result<bool> met = run_knife(command, cutting);
          if (met && !options_.journal.empty()) mark_state(document_, marks_);
          return met;
        },
        job_.notes);
    return cut ? cut : error_or_stopped(cut.error());
  }

  // Executes a command of the knife. Returns false if it met nothing.
  Result<bool> run_knife(const Command& command, const Progress& progress) {
    const auto began = Clock::now();
    Outcome outcome = document_.apply(command, &progress);
    if (!outcome.ok()) return outcome.error();
    StepResult step;
    step.delta = std::move(outcome.delta);
    job_.record_step(step, document_.world(), std::chrono::duration<double>(Clock::now() - began).count());
    ++job_.steps;
    return !step.delta.empty();
  }

  // Simulates the falling pieces.
  Status settle() {
    if (!options_.settle) return Done{};
    ProgressLine line("falling");
    const Progress falling = line.progress();
    Environment around;
    around.ground = options_.ground.value_or(bounds_.min.y);
    document_.apply(Command(SetEnvironment{around}));
    document_.apply(Play{});
    document_.apply(AdvanceTime{static_cast<Ticks>(std::ceil(*options_.settle * kTicksPerSecond)), true});
    QueueRun how;
    how.progress = &falling;
    if (const Status ran = run_queue(document_, how); !ran) return error_or_stopped(ran.error());
    return Done{};
  }

  // Writes the head of the journal, so that an unwritable path is reported before the cut.
  Status begin_journal() {
    if (options_.journal.empty()) return Done{};
    auto file = AtomicFile::open(options_.journal);
    if (!file) return file.error();
    const auto head = journal_head(scene_, {}, journal_folder());
    if (!head) return head.error();
    if (const Status written = file->append(*head); !written) return written;
    journal_.emplace(std::move(*file));
    return Done{};
  }

  Status end_journal() {
    if (!journal_) return Done{};
    mark_state(document_, marks_, true);
    const auto lines = journal_lines(document_.journal(), marks_, journal_folder());
    if (!lines) return lines.error();
    if (const Status written = journal_->append(*lines); !written) return written;
    return journal_->commit();
  }

  std::filesystem::path journal_folder() const {
    return std::filesystem::absolute(options_.journal).parent_path();
  }

  CutOptions options_;
  std::vector<StrokePath> strokes_;
  SceneDescription scene_;
  std::optional<Substance> substance_;  // of all bodies
  Document document_;
  std::vector<StateMark> marks_;
  std::optional<AtomicFile> journal_;
  World::Bounds bounds_;  // as loaded
  double diagonal_ = 0;
  CutJob job_;
  size_t loaded_notes_ = 0;  // the first notes of job_, reported on loading
  bool warned_scaled_ = false;
};

}  // namespace

void add_cut_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("cut", "Cut meshes along a path and write the pieces and a report");
  auto options = std::make_shared<CutOptions>();
  add_cut_options(*command, *options);
  on_call(
      *command, invocation, [options] { return CutRun(*options).run(); },
      "kerf cut assets/scenes/car-cut.json --out pieces --target-edge 0.01");
}

}  // namespace kerf
