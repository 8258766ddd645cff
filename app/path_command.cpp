#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/console.h"
#include "app/job_input.h"
#include "core/base/platform.h"
#include "core/document/drawing_layers.h"
#include "core/document/job_files.h"
#include "core/document/save.h"

namespace kerf {

namespace {

struct PathOptions {
  std::string file, out, compensate = "none", tabs, post, layers, axes;
  std::optional<double> radius, lead_in, tolerance, power_at_s1000;

  PathSide side() const {
    return compensate == "left"    ? PathSide::kLeft
           : compensate == "right" ? PathSide::kRight
                                   : PathSide::kNone;
  }
  // Returns true if the lines are changed, not only converted.
  bool works() const { return side() != PathSide::kNone || !tabs.empty(); }
};

// Parses "N,M": a number of tabs and their width in metres.
Status parse_tabs(const std::string& text, ToolpathOptions& options) {
  const auto wrong =
      bad_input("--tabs: must be N,M: a number of tabs from 1 to 1000 and their width in metres");
  const size_t comma = text.find(',');
  double count = 0;
  if (comma == std::string::npos || !parse_number(std::string_view(text).substr(0, comma), count) ||
      !parse_number(std::string_view(text).substr(comma + 1), options.tab_width))
    return wrong;
  if (!(count >= 1 && count <= 1000) || count != static_cast<int>(count) || !(options.tab_width > 0))
    return wrong;
  options.tabs = static_cast<int>(count);
  return Done{};
}

// One run of `kerf path`, from file to file.
class PathRun {
 public:
  explicit PathRun(PathOptions options) : options_(std::move(options)) {}

  Status run() {
    if (const Status s = check(); !s) return s;
    if (!options_.post.empty()) {
      if (const Status s = unpack(read_post_processor(options_.post), post_); !s) return s;
    }
    if (!options_.layers.empty()) {
      if (const Status s = unpack(read_layers(options_.layers), layers_); !s) return s;
    }
    RotaryAxes rotary;
    if (!options_.axes.empty()) {
      if (const Status s = unpack(read_rotary_axes(options_.axes), rotary); !s) return s;
    }
    auto job = read_job(options_.file, *job_kind(options_.file),
                        options_.tolerance.value_or(curve_tolerance(options_.radius, layers_)), rotary);
    if (!job) return job.error();
    arrange_layers(layers_, job->drawing.lines, job->notes);
    for (const std::string& note : job->notes) warn(options_.file + ": " + note);
    std::vector<StrokePath> strokes;
    if (const Status s = unpack(strokes_of(*job), strokes); !s) return s;
    if (strokes.empty())
      return bad_input(options_.file + ": the laser is never on while it moves; nothing is left to write");
    warn_of_dwells(strokes);
    const auto text = written(strokes);
    if (!text) return bad_input(options_.file + ": " + text.error().message);
    if (const Status s = write_file_atomically(options_.out, *text); !s) return s;
    summarize(summary(strokes, *job));
    return Done{};
  }

 private:
  Status check() {
    if (options_.compensate != "none" && options_.side() == PathSide::kNone)
      return bad_input("--compensate: \"" + options_.compensate +
                       "\" is not a valid value; the values are: left, right, none");
    if (!job_kind(options_.file)) return bad_input(options_.file + ": must end in .json, .svg, .dxf or .nc");
    const auto kind = job_kind(options_.out);
    if (!kind || kind == JobFile::Kind::kDxf)
      return bad_input("--out: " + options_.out + " must end in .json, .svg or .nc");
    if (options_.lead_in && options_.side() == PathSide::kNone)
      return bad_input("--lead-in: requires --compensate left or right");
    if (!options_.tabs.empty()) {
      if (const Status s = parse_tabs(options_.tabs, toolpath_); !s) return s;
    }
    if (!options_.post.empty() && kind != JobFile::Kind::kProgram)
      return bad_input("--post: requires an --out that ends in .nc");
    if (!options_.layers.empty() && !is_drawing_file(options_.file))
      return bad_input("--layers: requires a drawing, .svg or .dxf");
    if (!options_.axes.empty() && job_kind(options_.file) != JobFile::Kind::kProgram)
      return bad_input("--axes: requires a program, .nc");
    if (options_.power_at_s1000 && job_kind(options_.file) != JobFile::Kind::kProgram &&
        kind != JobFile::Kind::kProgram)
      return bad_input("--power-at-s1000: requires a program, .nc, as FILE or --out");
    InputFiles inputs;
    for (const std::string& file : {options_.file, options_.post, options_.layers, options_.axes})
      inputs.add(file);
    return inputs.check("--out", options_.out);
  }

  // From program to program, S stays as it is.
  bool keeps_power() const {
    return !options_.power_at_s1000 && job_kind(options_.file) == JobFile::Kind::kProgram &&
           job_kind(options_.out) == JobFile::Kind::kProgram;
  }
  std::optional<double> power_at_s1000() const { return keeps_power() ? 1000 : options_.power_at_s1000; }

  Result<std::vector<StrokePath>> strokes_of(const JobFile& job) {
    const JobPlane plane = *plane_onto("-y");
    std::vector<StrokePath> strokes = job.path;
    if (job.kind == JobFile::Kind::kProgram) strokes = program_strokes(job.program, plane, power_at_s1000());
    if (job.is_drawing() && !options_.works()) {
      strokes = drawing_strokes(job.drawing.lines, job.drawing.middle, plane);
      set_lasers(layers_, job.drawing.lines, strokes);
    }
    if (options_.works() || job_kind(options_.out) == JobFile::Kind::kSvg) leave_out_still(strokes);
    if (!options_.works()) {
      for (StrokePath& stroke : strokes) {
        if (options_.radius) stroke.radius = *options_.radius;
      }
      return strokes;
    }
    return worked(job, strokes, plane);
  }

  // Removes the strokes that stand still, which are no lines.
  void leave_out_still(std::vector<StrokePath>& strokes) const {
    const size_t count = std::erase_if(strokes, [](const StrokePath& stroke) {
      const Pose& first = stroke.keys.front();
      return std::ranges::all_of(stroke.keys, [&](const Pose& key) {
        return key.origin == first.origin && key.direction == first.direction;
      });
    });
    if (count > 0)
      warn(options_.file + ": left out: " + count_text(count, "stroke") +
           (count == 1 ? " that stands still" : " that stand still"));
  }

  // Returns the strokes with compensation, entries and tabs. They have the laser, the mean speed and the
  // height of the strokes of the file that they were made from, and one radius.
  Result<std::vector<StrokePath>> worked(const JobFile& job, const std::vector<StrokePath>& strokes,
                                         const JobPlane& plane) {
    std::vector<DrawnLine> lines = job.drawing.lines;
    if (!job.is_drawing()) {
      auto flat = plane_lines(strokes);
      if (!flat) return bad_input(options_.file + ": " + flat.error().message);
      lines = std::move(*flat);
    }
    const auto radius = options_.radius || strokes.empty() ? options_.radius : strokes.front().radius;
    if (!radius) return bad_input("--compensate and --tabs: require --radius, the radius of the beam");
    toolpath_.side = options_.side();
    toolpath_.radius = *radius;
    toolpath_.lead_in = options_.lead_in.value_or(0);
    auto toolpath = make_toolpath(std::move(lines), toolpath_);
    if (!toolpath) return bad_input(options_.file + ": " + toolpath.error().message);
    for (const std::string& note : toolpath->notes) warn(options_.file + ": " + note);
    arrange_by_layers(toolpath->strokes);
    auto made = drawing_strokes(toolpath->strokes, job.drawing.middle, plane);
    std::vector<double> speeds;
    for (const StrokePath& stroke : strokes) speeds.push_back(speed_of(stroke));
    for (size_t i = 0; i < made.size() && !job.is_drawing(); ++i) {
      const size_t source = std::stoul(toolpath->strokes[i].layer);
      take_laser(strokes[source], speeds[source], made[i]);
      for (Pose& key : made[i].keys) key.origin.y = strokes[source].keys.front().origin.y;
    }
    set_lasers(layers_, toolpath->strokes, made);
    for (StrokePath& stroke : made) stroke.radius = *radius;
    return made;
  }

  // Restores the order of the layers, which precedes that of nested lines.
  void arrange_by_layers(std::vector<DrawnLine>& lines) const {
    std::vector<std::string> notes_of_reading;
    arrange_layers(layers_, lines, notes_of_reading);
  }

  // Returns the mean speed of the beam while it moves; 0 if it does not.
  static double speed_of(const StrokePath& stroke) {
    double way = 0, seconds = 0;
    for (size_t k = 1; k < stroke.keys.size(); ++k) {
      const double length = glm::length(stroke.keys[k].origin - stroke.keys[k - 1].origin);
      if (!(length > 0)) continue;
      way += length;
      seconds += stroke.times[k] - stroke.times[k - 1];
    }
    return seconds > 0 ? way / seconds : 0;
  }

  // Gives a stroke of kDrawingSpeed the laser of another, and its speed [m/s] if that is positive.
  static void take_laser(const StrokePath& source, double speed, StrokePath& stroke) {
    if (speed > 0) {
      for (double& time : stroke.times) time *= kDrawingSpeed / speed;
    }
    stroke.range = source.range;
    stroke.power = source.power;
    stroke.wavelength = source.wavelength;
    stroke.focus = source.focus;
    stroke.pulse_rate = source.pulse_rate;
    stroke.duty = source.duty;
  }

  // Warns of strokes with dwells in which the laser is off: M4 adapts the power to the speed.
  void warn_of_dwells(const std::vector<StrokePath>& strokes) const {
    if (post_.laser_on != "M4" && !post_.laser_on.starts_with("M4 ")) return;
    const auto count = std::ranges::count_if(strokes, [](const StrokePath& stroke) {
      const auto is_same = [](const Pose& a, const Pose& b) { return a.origin == b.origin; };
      return stroke.keys.size() == 1 || std::ranges::adjacent_find(stroke.keys, is_same) != stroke.keys.end();
    });
    if (count > 0)
      warn(options_.out + ": with M4 of --post the laser is off in the dwells of " +
           count_text(static_cast<size_t>(count), "stroke") + "; use M3 there");
  }

  Result<std::string> written(const std::vector<StrokePath>& strokes) const {
    switch (*job_kind(options_.out)) {
      case JobFile::Kind::kSvg:
        return strokes_svg(strokes);
      case JobFile::Kind::kProgram:
        return keeps_power() ? strokes_gcode_with_same_s(strokes, post_)
                             : strokes_gcode(strokes, options_.power_at_s1000, post_);
      default:
        return path_file_text(strokes);
    }
  }

  std::string summary(const std::vector<StrokePath>& strokes, const JobFile& job) const {
    double way = 0, seconds = 0;
    for (const StrokePath& stroke : strokes) {
      way += way_of(stroke);
      seconds += duration_of(stroke);
    }
    if (job.kind == JobFile::Kind::kProgram && !options_.works()) seconds = job.program.duration;
    return count_text(strokes.size(), "stroke") + " of " + length_text(way) + ", " +
           general_text(std::ceil(seconds), 15) + " s, are in " + options_.out;
  }

  PathOptions options_;
  ToolpathOptions toolpath_;
  PostProcessor post_;
  LayerTable layers_;
};

}  // namespace

void add_path_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "path", "Convert paths, drawings and programs, and compensate the width of the kerf");
  auto o = std::make_shared<PathOptions>();
  command->footer(
      "Drawings and programs lie in the plane y = 0, under a beam along -y: their x is +x and their y is -z. "
      "The\n"
      "middle of a drawing and the zero of a program are the zero of the world. Drawings are cut at 0.02 "
      "m/s.");
  command->add_option("FILE", o->file, "A path (.json), a drawing (.svg, .dxf) or a program (.nc)")
      ->required();
  command->add_option("-o,--out", o->out, "The file to write: .json, .svg or .nc")->required();
  command->add_option(
      "--compensate", o->compensate,
      "Side of the waste along the outermost lines, to which the beam is offset: left, right or none (none); "
      "inner lines are reversed");
  add_number(*command, "--radius", o->radius, kPositive, "Beam radius in metres (that of the path file)");
  add_number(*command, "--lead-in", o->lead_in, kPositive,
             "With --compensate: length of a straight entry from the side of the beam, in metres");
  command->add_option("--tabs", o->tabs, "N,M: leave N tabs of M metres in each closed line");
  add_number(*command, "--tolerance", o->tolerance, kPositive,
             "Largest distance of chords from curves, in metres (radius/50, or 0.00001)");
  add_number(*command, "--power-at-s1000", o->power_at_s1000, kPositive,
             "Beam power at S1000 in programs, in watts (the largest of the path; from program to program S "
             "is kept)");
  command->add_option(
      "--post", o->post,
      "A JSON file with the dialect of the controller that reads the program (one for GRBL and "
      "LinuxCNC)");
  command->add_option(
      "--layers", o->layers,
      "A JSON file with radius, speed, power and order of the layers or colours of a drawing");
  command->add_option("--axes", o->axes, kAxesHelp);
  on_call(
      *command, invocation, [o] { return PathRun(*o).run(); },
      "kerf path assets/drawings/flange.dxf --compensate right --radius 0.0001 --lead-in 0.001 --out "
      "flange.nc");
}

}  // namespace kerf
