#include "app/job_input.h"

#include <algorithm>

#include "app/arguments.h"
#include "core/base/deterministic_math.h"
#include "ui/render/view/camera.h"

namespace kerf {

namespace {

constexpr NumberRange kTurn{-1e6, 1e6, "degrees"};
constexpr NumberRange kWrapRadius{1e-6, 1e6, "m"};
constexpr NumberRange kJobScale{1e-6, 1e6, "", true};

// Returns the number of keys of all lines round the cylinder of a wrapped plane, but for rounding.
double wrapped_keys(const std::vector<DrawnLine>& lines, const JobPlane& plane) {
  double way = 0;
  for (const DrawnLine& line : lines) {
    for (size_t i = 1; i < line.points.size(); ++i) way += glm::length(line.points[i] - line.points[i - 1]);
    if (line.closed) way += glm::length(line.points.front() - line.points.back());
  }
  return plane.scale * way / plane.wrap / kWrapStep;
}

}  // namespace

void JobInput::add_to(CLI::App& command) {
  command.add_option("--drawing", drawing, "Cut along the lines of a drawing instead: SVG or DXF");
  command.add_option("--gcode", gcode, "Cut along a program of GRBL or LinuxCNC instead (.nc)");
  command.add_option(
      "--layers", layers,
      "With --drawing: a JSON file with radius, speed, power and order of its layers or colours");
  command.add_option(
      "--onto", onto,
      "Direction of the beam for a drawing or a program: +x, -x, +y, -y, +z or -z (-y); seen along it, "
      "the drawing stands upright");
  command.add_option(
      "--at", at,
      "X,Y,Z: position of the middle of the drawing, or the zero of the program, in metres (above the "
      "middle of the meshes; the program above the zero of the world)");
  command.add_option("--eye", eye,
                     "With --drawing: X,Y,Z, from which the beam goes through the drawing, which faces this "
                     "point; instead of --onto");
  add_number(command, "--turn", turn, kTurn,
             "Turn of the drawing, counter-clockwise as seen along the beam (0)");
  add_number(command, "--scale", scale, kJobScale, "Factor on the size of the drawing (1)");
  add_number(
      command, "--wrap", wrap, kWrapRadius,
      "With --drawing: wrap the drawing round a cylinder of this radius, whose axis is upright in it and "
      "goes through the middle of the meshes; --at is then a point of the cylinder");
  add_number(command, "--power-at-s1000", power_at_s1000, kPositive,
             "With --gcode: beam power at S1000, in watts (S sets no power)");
  command.add_option("--axes", axes, kAxesHelp);
}

Status JobInput::read(bool has_path, std::optional<double> radius) {
  if (file().empty()) {
    if (wrap) return bad_input("--wrap: requires --drawing");
    if (eye) return bad_input("--eye: requires --drawing");
    if (onto || at || turn || scale)
      return bad_input("--onto, --at, --turn and --scale: require --drawing or --gcode");
    if (power_at_s1000) return bad_input("--power-at-s1000: requires --gcode");
    if (!layers.empty()) return bad_input("--layers: requires --drawing");
    if (!axes.empty()) return bad_input("--axes: requires --gcode");
    return Done{};
  }
  if (has_path + !drawing.empty() + !gcode.empty() > 1)
    return bad_input("--path, --drawing and --gcode: give only one of them");
  if (power_at_s1000 && gcode.empty()) return bad_input("--power-at-s1000: requires --gcode");
  if (!axes.empty() && gcode.empty()) return bad_input("--axes: requires --gcode");
  if (wrap && drawing.empty()) return bad_input("--wrap: requires --drawing");
  if (eye && drawing.empty()) return bad_input("--eye: requires --drawing");
  if (eye && (onto || wrap)) return bad_input("--eye: cannot be combined with --onto or --wrap");
  if (!layers.empty() && drawing.empty()) return bad_input("--layers: requires --drawing");
  const auto plane = plane_onto(onto.value_or("-y"));
  if (!plane) return bad_input("--onto: " + plane.error().message);
  plane_ = *plane;
  plane_.turn = radians_of(turn.value_or(0));
  plane_.scale = scale.value_or(1);
  plane_.wrap = wrap.value_or(0);
  if (at) {
    if (const Status s = unpack(parse_point("--at", *at), plane_.at); !s) return s;
  }
  if (eye) {
    if (const Status s = unpack(parse_point("--eye", *eye), eye_); !s) return s;
  }
  auto kind = job_kind(file());
  if (!gcode.empty()) kind = JobFile::Kind::kProgram;
  if (kind != JobFile::Kind::kSvg && kind != JobFile::Kind::kDxf && gcode.empty())
    return bad_input("--drawing: " + drawing + " must end in .svg or .dxf");
  if (!layers.empty()) {
    if (const Status s = unpack(read_layers(layers), layers_); !s) return s;
  }
  const double tolerance = curve_tolerance(radius, layers_);
  RotaryAxes rotary;
  if (!axes.empty()) {
    if (const Status s = unpack(read_rotary_axes(axes), rotary); !s) return s;
  }
  if (const Status s = unpack(read_job(file(), *kind, tolerance / plane_.scale, rotary), job_); !s) return s;
  arrange_layers(layers_, job_.drawing.lines, job_.notes);
  return Done{};
}

// Without --at the plane lies before the meshes, against the beam. With rotary axes the heights of the
// program count, and its zero is that of the world. With --eye it faces the eye.
JobPlane JobInput::placed(const Bounds& bounds) const {
  JobPlane plane = plane_;
  if (eye) {
    if (!at) plane.at = bounds.centre();
    const CameraView view = look_at(eye_, plane.at, 1);
    plane.right = view.right;
    plane.up = view.up;
    plane.beam = view.forward;
    plane.eye = view.eye;
    return plane;
  }
  if (at || !axes.empty()) return plane;
  if (wrap) {
    plane.at = bounds.centre() - *wrap * plane.beam;
    return plane;
  }
  const Vec3 half = 0.5 * bounds.max - 0.5 * bounds.min;
  const double top = glm::dot(bounds.centre(), -plane.beam) + glm::dot(half, glm::abs(plane.beam));
  double height = top + 0.1 * bounds.diagonal();
  if (job_.is_drawing()) {
    plane.at = bounds.centre() - (height - glm::dot(bounds.centre(), -plane.beam)) * plane.beam;
    return plane;
  }
  double lowest = 0;
  for (const ProgramStroke& stroke : job_.program.strokes) {
    for (const Vec3& point : stroke.points) lowest = std::min(lowest, point.z);
  }
  height -= plane.scale * lowest;
  plane.at = -height * plane.beam;
  return plane;
}

double curve_tolerance(std::optional<double> radius, const LayerTable& layers) {
  double smallest = radius.value_or(50 * kCurveTolerance);
  if (!radius) {
    for (const auto& [name, layer] : layers.layers)
      smallest = std::min(smallest, layer.radius.value_or(smallest));
  }
  return std::max(smallest / 50, 1e-9);
}

Status JobInput::add_strokes(const Bounds& bounds, std::vector<StrokePath>& strokes, CutJob& job) const {
  if (file().empty()) return Done{};
  const JobPlane plane = placed(bounds);
  if (eye && plane.at == eye_)
    return bad_input("--eye: is the middle of the drawing; give another point, or --at");
  if (wrap && wrapped_keys(job_.drawing.lines, plane) > double{DrawingLimits::kMaxPoints})
    return bad_input("--wrap: " + file() + " has too many turns; use a larger radius or a smaller --scale");
  for (const std::string& note : job_.notes) job.notes.push_back(file() + ": " + note);
  if (job_.is_drawing()) {
    strokes = drawing_strokes(job_.drawing.lines, job_.drawing.middle, plane);
    set_lasers(layers_, job_.drawing.lines, strokes);
    return Done{};
  }
  strokes = program_strokes(job_.program, plane, power_at_s1000);
  job.program_s = job_.program.duration;
  return Done{};
}

std::optional<size_t> JobInput::line_of(size_t stroke, size_t key) const {
  if (stroke >= job_.program.strokes.size()) return std::nullopt;
  const std::vector<size_t>& lines = job_.program.strokes[stroke].lines;
  return key < lines.size() ? std::optional(lines[key]) : std::nullopt;
}

}  // namespace kerf
