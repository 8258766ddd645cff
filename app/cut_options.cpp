#include "app/cut_options.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/parse_values.h"
#include "core/document/files/stroke_settings.h"
#include "core/document/text/json_value.h"

namespace kerf {

namespace {

constexpr double kLongestFall = 3600;  // s

Status only(const std::optional<std::string>& value, const char* option,
            const std::vector<std::string>& offered) {
  if (!value || std::find(offered.begin(), offered.end(), *value) != offered.end()) return Done{};
  std::string list;
  for (const std::string& name : offered) list += (list.empty() ? "" : ", ") + name;
  return bad_input(std::string(option) + ": \"" + *value +
                   "\" is not offered by this version; there is: " + list);
}

Status positive(const std::optional<double>& value, const char* option) {
  if (!value || (*value > 0 && std::isfinite(*value))) return Done{};
  return bad_input(std::string(option) + ": must be a length in metres greater than zero");
}

Status positive_number(const std::optional<double>& value, const char* option, const char* unit) {
  if (!value || (*value > 0 && std::isfinite(*value))) return Done{};
  return bad_input(std::string(option) + ": must be a number of " + unit + " greater than zero");
}

Status check_fall(const CutOptions& o) {
  if (o.settle && !(*o.settle > 0 && *o.settle <= kLongestFall))
    return bad_input("--settle: must be a number of seconds greater than zero, at most 3600");
  if (o.ground && !o.settle) return bad_input("--ground: needs --settle, without which nothing falls");
  if (o.ground && !std::isfinite(*o.ground)) return bad_input("--ground: must be a height in metres");
  if (const auto s = positive(o.thickness, "--thickness"); !s) return s;
  return positive_number(o.density, "--density", "kilograms per cubic metre");
}

Status within(const std::optional<int>& value, int least, int most, const char* option) {
  if (!value || (*value >= least && *value <= most)) return Done{};
  return bad_input(std::string(option) + ": must be a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most));
}

template <typename T>
Status take(const JsonValue& value, std::optional<T>& option) {
  if constexpr (std::is_same_v<T, double>) {
    const auto number = value.number();
    if (!number) return number.error();
    if (!option) option = *number;
  } else if constexpr (std::is_same_v<T, int>) {
    if (!value.json().is_number_integer()) return value.wrong("must be a whole number");
    const auto number = value.json().get<int64_t>();
    if (number < -1'000'000'000 || number > 1'000'000'000) return value.wrong("is out of range");
    if (!option) option = static_cast<int>(number);
  } else {
    const auto text = value.text();
    if (!text) return text.error();
    if (!option) option = *text;
  }
  return Done{};
}

Status take_range(const JsonValue& value, std::optional<std::string>& option) {
  const auto range = value.interval();
  if (!range) return range.error();
  if (!option) option = value.json()[0].dump() + "," + value.json()[1].dump();
  return Done{};
}

Status take_key(const std::string& key, const JsonValue& value, CutOptions& o) {
  if (key == "radius") return take(value, o.radius);
  if (key == "range") return take_range(value, o.range);
  if (key == "pattern") return take(value, o.pattern);
  if (key == "scheme") return take(value, o.scheme);
  if (key == "rim") return take(value, o.rim);
  if (key == "target-edge") return take(value, o.target_edge);
  if (key == "tolerance") return take(value, o.tolerance);
  if (key == "depth") return take(value, o.depth);
  if (key == "steps") return take(value, o.steps);
  if (key == "settle") return take(value, o.settle);
  if (key == "ground") return take(value, o.ground);
  if (key == "thickness") return take(value, o.thickness);
  if (key == "density") return take(value, o.density);
  if (key == "model") return take(value, o.model);
  if (key == "material") return take(value, o.material);
  if (key == "power") return take(value, o.power);
  if (key == "format") return take(value, o.format);
  if (key == "split-all") {
    if (!value.json().is_boolean()) return value.wrong("must be true or false");
    o.split_all = o.split_all || value.json().get<bool>();
    return Done{};
  }
  return value.wrong("is not a setting that this version has");
}

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

}  // namespace

void add_cut_options(CLI::App& command, CutOptions& o) {
  command.footer(kPathFile);
  command.add_option("MESH", o.meshes, "Mesh files (OBJ, STL, PLY, OFF), cut together, or a scene (.json)")
      ->required();
  command.add_option("--path", o.path, "The strokes of the laser (JSON); without it nothing is cut");
  command.add_option("--out", o.out, "The folder for the pieces and report.json")->required();
  command.add_option("--radius", o.radius,
                     "Radius of the beam in metres (diagonal/400, or what the path file says)");
  command.add_option("--range", o.range,
                     "MIN,MAX: where along the beam it cuts, in metres (0 to 10 diagonals)");
  command.add_option("--pattern", o.pattern, "volume or rays4 (volume)");
  command.add_option("--scheme", o.scheme, "How faces are split: one-to-four or longest-edge (longest-edge)");
  command.add_option("--rim", o.rim, "How the rim is left: faces or smooth (faces)");
  command.add_option("--target-edge", o.target_edge,
                     "Longest edge under the beam in metres (radius/4; thermal: radius)");
  command.add_option("--tolerance", o.tolerance,
                     "Instead: how far what is removed may overshoot the beam, in metres");
  command.add_option("--depth", o.depth, "Instead: levels under the base face");
  command.add_option("--steps", o.steps,
                     "How many steps each stroke is walked in (as many as the sweep needs)");
  command.add_option(
      "--model", o.model,
      "What the beam does to a face: geometric removes it at once, thermal heats it until it has "
      "the energy that its material needs (geometric)");
  command.add_option("--material", o.material,
                     "What the sheets are made of (mild-steel); kerf materials lists what there is");
  command.add_option("--power", o.power, "Of the beam in watts (2000, or what the path file says)");
  command.add_option("--format", o.format, "Of the pieces: obj, ply, stl or off (obj)");
  command.add_flag("--split-all", o.split_all, "Every connected component is a piece");
  command.add_option("--settle", o.settle,
                     "For how many seconds the pieces fall after the last stroke; they are written where "
                     "they are then");
  command.add_option("--ground", o.ground,
                     "With --settle: height of the ground in metres (the lowest point of all meshes)");
  command.add_option("--thickness", o.thickness,
                     "Thickness of the sheets that the faces stand for, in metres (0.001)");
  command.add_option("--density", o.density, "Density of the sheets in kg/m3 (7850, that of mild steel)");
  command.add_option("--journal", o.journal,
                     "Where to write the journal (.kerf) of the cut, for kerf replay");
  command.add_option("--settings", o.settings, "A JSON file with the same keys; the command line wins");
}

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
  for (const auto& item : json->items()) {
    if (has_resolution && is_resolution(item.key())) continue;
    if (const auto taken = take_key(item.key(), root[item.key()], o); !taken) return taken;
  }
  return Done{};
}

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

Status check_cut_options(const CutOptions& o) {
  if (const auto s = positive(o.radius, "--radius"); !s) return s;
  if (o.range) {
    if (const auto range = parse_range(*o.range); !range) return range.error();
  }
  if (const auto s = only(o.pattern, "--pattern", {"volume", "rays4"}); !s) return s;
  if (const auto s = only(o.scheme, "--scheme", {"one-to-four", "longest-edge"}); !s) return s;
  if (const auto s = only(o.rim, "--rim", {"faces", "smooth"}); !s) return s;
  if (const auto s = positive(o.target_edge, "--target-edge"); !s) return s;
  if (const auto s = positive(o.tolerance, "--tolerance"); !s) return s;
  if (const auto s = within(o.depth, 0, Resolution::kLargestDepth, "--depth"); !s) return s;
  if (o.target_edge.has_value() + o.tolerance.has_value() + o.depth.has_value() > 1) {
    return bad_input("--target-edge, --tolerance and --depth: choose one of them");
  }
  if (const auto s = within(o.steps, 1, 1'000'000, "--steps"); !s) return s;
  if (const auto s = only(o.model, "--model", {"geometric", "thermal"}); !s) return s;
  if (const auto s = positive_number(o.power, "--power", "watts"); !s) return s;
  if (const auto s = check_fall(o); !s) return s;
  return only(o.format, "--format", {"obj", "ply", "stl", "off"});
}

CutSettings stroke_settings(const CutOptions& o, const StrokePath& stroke, double diagonal) {
  CutSettings settings = default_settings(stroke, diagonal);
  if (o.radius) settings.laser.radius = *o.radius;
  if (o.range) settings.laser.range = *parse_range(*o.range);
  if (o.power) settings.laser.power = *o.power;
  if (o.model == "thermal") settings.model = Model::kThermal;
  if (o.pattern == "rays4") settings.laser.pattern = Pattern::kRays4;
  Resolution& resolution = settings.resolution;
  if (o.rim == "smooth") resolution.rim = Rim::kSmooth;
  if (o.scheme) resolution.scheme = o.scheme == "one-to-four" ? Scheme::kOneToFour : Scheme::kLongestEdge;
  const double finest = settings.model == Model::kThermal ? settings.laser.radius : settings.laser.radius / 4;
  resolution.target_edge = o.target_edge.value_or(finest);
  resolution.tolerance = o.tolerance.value_or(settings.laser.radius / 8);
  resolution.depth = o.depth.value_or(resolution.depth);
  if (o.tolerance) resolution.rule = Resolution::Rule::kTolerance;
  if (o.depth) resolution.rule = Resolution::Rule::kDepth;
  return settings;
}

}  // namespace kerf
