#include "app/cut_options.h"

#include <algorithm>
#include <array>

#include "app/arguments.h"
#include "core/base/platform.h"
#include "core/cut/thermal_step.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

constexpr NumberRange kFall{0.001, 3600, "s"};

using Names = std::vector<std::string>;

Names format_names() {
  Names names;
  for (const MeshFormatRow& row : kMeshFormats) names.emplace_back(row.ending);
  return names;
}

bool is_one_of(const std::string& name, const Names& names) {
  return std::ranges::find(names, name) != names.end();
}

std::string must_be_one_of(const std::string& name, const Names& names) {
  std::string list;
  for (const std::string& value : names) list += (list.empty() ? "" : ", ") + value;
  return "\"" + name + "\" is not a valid value; the values are: " + list;
}

std::string must_be_whole(int least, int most) {
  return "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most);
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

// Visits the options that a settings file may contain, from --radius to --density: key, allowed values, help.
template <typename Visitor>
void visit_options(CutOptions& o, Visitor& v) {
  v.number("radius", o.radius, kPositive, "Beam radius in metres (diagonal/400, or that of the path file)");
  v.range("range", o.range, "MIN,MAX: the part of the beam that cuts, in metres (0 to 10 diagonals)");
  v.choice("pattern", o.pattern, {"volume", "rays4"}, "volume or rays4 (volume)");
  v.choice("scheme", o.scheme, {"one-to-four", "longest-edge"},
           "Subdivision of faces: one-to-four or longest-edge (longest-edge)");
  v.choice(
      "rim", o.rim, {"faces", "smooth"},
      "Rim of the cut: faces (jagged) or smooth, which needs --model geometric and --pattern volume (faces)");
  v.flag("solid", o.solid,
         "The meshes are solids: walls cap the cut, so pieces are closed (implies --rim smooth)");
  v.text("cut-material", o.cut_material,
         "Material of the cut faces of solids: one of the mesh, or a new one (cut)");
  v.flag("turn-shells", o.turn_shells,
         "Flip closed parts that lie inside others and face the same way, so that they become cavities");
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
  v.choice("unit", o.unit, {"mm", "cm", "m", "in"},
           "Unit of mesh files that state none: mm, cm, m or in (m)");
  v.choice("format", o.format, format_names(),
           ("Format of the pieces: " + list_mesh_endings("") + " (obj)").c_str());
  v.choice(
      "colliders", o.colliders, {"hull"},
      "For glTF: add a convex hull of at most 64 vertices to each piece, with its mass properties (none)");
  v.choice("collider-names", o.collider_names, {"unreal", "godot"},
           "Names of the hulls: UCX_NODE_00 for unreal, NODE-convcolonly for godot (unreal)");
  v.choice("outlines", o.outlines, {"svg", "dxf"},
           "Also write the outline of each flat piece: svg or dxf (none)");
  v.flag("single-file", o.single_file, "For glTF and 3MF: write all pieces to one file, such as pieces.glb");
  v.flag("split-all", o.split_all,
         "Make every connected component a piece; cavities stay with the solids around them");
  v.flag("recentre", o.recentre,
         "Write coordinates relative to an origin near the meshes, stated in the report (\"origin\")");
  v.number("settle", o.settle, kFall,
           "Simulate this many seconds of falling after the last stroke before the pieces are written");
  v.number("ground", o.ground, kFinite,
           "With --settle: height of the ground in metres (the lowest point of all meshes)");
  v.number("thickness", o.thickness, kThickness.range, "Thickness of the sheets, in metres (0.001)");
  v.number("density", o.density, kDensity.range,
           "Density of the sheets in kg/m3 (that of --material, else 7850)");
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
    add_number(command, "--" + std::string(key), x, {static_cast<double>(least), static_cast<double>(most)},
               help);
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

// Checks one entry of a settings file, and reads it unless the command line has the option.
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
  void number(const char* option, std::optional<double>& x, const NumberRange& range, const char*) {
    take(option, x, [&]() -> Result<double> {
      const auto number = value.number();
      if (!number || range.contains(*number)) return number;
      return value.wrong(out_of_limits(*number, range));
    });
  }
  void whole(const char* option, std::optional<int>& x, int least, int most, const char*) {
    take(option, x, [&]() -> Result<int> {
      const double number = value.json().is_number_integer() ? value.json().get<double>() : least - 1.0;
      if (number < least || number > most) return value.wrong(must_be_whole(least, most));
      return static_cast<int>(number);
    });
  }
  void text(const char* option, std::optional<std::string>& x, const char*) {
    take(option, x, [&] { return value.text(); });
  }
  void choice(const char* option, std::optional<std::string>& x, const Names& names, const char*) {
    take(option, x, [&]() -> Result<std::string> {
      const auto name = value.text();
      if (!name || is_one_of(*name, names)) return name;
      return value.wrong(must_be_one_of(*name, names));
    });
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
    expect(!x || (*x >= least && *x <= most), key, must_be_whole(least, most));
  }
  void choice(const char* key, const std::optional<std::string>& x, const Names& names, const char*) {
    expect(!x || is_one_of(*x, names), key, x ? must_be_one_of(*x, names) : "");
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
its keys are optional; it may also contain "wavelength" and "focus" (metres),
"pulse_rate" (Hz) and "duty" (0 to 1).
  {"strokes": [{"laser": {"radius": 0.01, "range": [0, 10], "power": 2000},
                "keys": [{"t": 0, "origin": [-1.5, 3, 0.4], "direction": [0, -1, 0]},
                         {"t": 1, "origin": [1.5, 3, 0.4], "direction": [0, -1, 0]}]}]}
One key is a beam that stands still. Directions need not have unit length.)";

bool is_resolution(const std::string& key) {
  return key == "target-edge" || key == "tolerance" || key == "depth";
}

// Returns why the options leave no walls, and what to remove; "" if they leave walls.
std::string obstacle_to_walls(const CutOptions& o) {
  CutSettings settings;
  if (o.pattern == "rays4") settings.laser.pattern = Pattern::kRays4;
  if (o.model == "thermal") settings.model = Model::kThermal;
  settings.resolution.rim = o.rim == "faces" ? Rim::kFaces : Rim::kSmooth;
  const WallNeed need = settings.unmet_wall_need();
  constexpr std::array kObstacles{"", "--pattern rays4", "--model thermal", "--rim faces"};
  if (need == WallNeed::kNone) return "";
  return std::string(label(need)) + "; remove " + kObstacles.at(static_cast<size_t>(need));
}

Status check_rim(const CutOptions& o) {
  if (o.rim != "smooth") return Done{};
  if (o.pattern == "rays4")
    return bad_input("--rim: a smooth rim needs the whole volume of the beam; remove --pattern rays4");
  if (o.model == "thermal")
    return bad_input("--rim: a smooth rim needs the geometric model; remove --model thermal");
  return Done{};
}

Status check_solid(const CutOptions& o) {
  if (o.cut_material && (o.cut_material->empty() || *o.cut_material != one_line(*o.cut_material)))
    return bad_input("--cut-material: must be a name of one line, and not empty");
  const std::string obstacle = obstacle_to_walls(o);
  if (!o.solid || obstacle.empty()) return Done{};
  return bad_input("--solid: " + obstacle);
}

Status check_gltf_options(const CutOptions& o) {
  if (o.collider_names && !o.colliders) return bad_input("--collider-names: requires --colliders");
  const MeshFormat format = *mesh_format(o.format.value_or("obj"));
  if (o.colliders && !is_gltf(format))
    return bad_input("--colliders: only glTF holds colliders; add --format glb or gltf");
  if (o.single_file && !holds_several_meshes(format))
    return bad_input("--single-file: requires --format glb, gltf or 3mf");
  return Done{};
}

}  // namespace

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
  o.setup.add_to(command);
  command.add_option("-o,--out", o.out, "The folder for the pieces and report.json")->required();
  Offer offer{command};
  visit_options(o, offer);
  command.add_option("--journal", o.journal, "The file for the journal (.kerf) of the cut, for kerf replay");
  command.add_option("--provenance", o.provenance,
                     "The file (.npz) for the source face of each face of the pieces and the barycentric "
                     "coordinates of its corners there");
  command.add_option(
      "--settings", o.settings,
      "A JSON file whose keys are the options from --radius to --density; the command line wins");
}

Status merge_settings_file(CutOptions& o) {
  if (o.settings.empty()) return Done{};
  const auto text = read_text_file(o.settings);
  if (!text) return text.error();
  const auto json = parse_json(*text, o.settings);
  if (!json) return json.error();
  if (const Status unique = check_unique_keys(*text, o.settings); !unique) return unique;
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

Status check_cut_options(CutOptions o) {
  Check check;
  visit_options(o, check);
  if (!check.status) return check.status;
  if (o.target_edge.has_value() + o.tolerance.has_value() + o.depth.has_value() > 1) {
    return bad_input("--target-edge, --tolerance and --depth: give only one of them");
  }
  if (o.assist == "oxygen" && o.model != "thermal") return bad_input("--assist: requires --model thermal");
  if (o.ground && !o.settle) return bad_input("--ground: requires --settle");
  if (const Status s = check_gltf_options(o); !s) return s;
  if (const Status s = check_solid(o); !s) return s;
  return check_rim(o);
}

Status prepare_for_walls(CutOptions& o, const std::string& where) {
  if (const std::string obstacle = obstacle_to_walls(o); !obstacle.empty())
    return bad_input(where + ": " + obstacle);
  o.rim = "smooth";
  return Done{};
}

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

}  // namespace kerf
