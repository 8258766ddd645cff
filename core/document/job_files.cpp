#include "core/document/job_files.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/number_format.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"

namespace kerf {

namespace {

struct NamedPlane {
  std::string_view name;
  Vec3 right, up;
};
constexpr std::array<NamedPlane, 6> kPlanes{{{"+x", {0, 0, 1}, {0, 1, 0}},
                                             {"-x", {0, 0, -1}, {0, 1, 0}},
                                             {"+y", {1, 0, 0}, {0, 0, 1}},
                                             {"-y", {1, 0, 0}, {0, 0, -1}},
                                             {"+z", {-1, 0, 0}, {0, 1, 0}},
                                             {"-z", {1, 0, 0}, {0, 1, 0}}}};

struct JobEnding {
  std::string_view ending;
  JobFile::Kind kind;
};
constexpr std::array<JobEnding, 7> kJobEndings{{{".json", JobFile::Kind::kPath},
                                                {".svg", JobFile::Kind::kSvg},
                                                {".dxf", JobFile::Kind::kDxf},
                                                {".nc", JobFile::Kind::kProgram},
                                                {".ngc", JobFile::Kind::kProgram},
                                                {".gcode", JobFile::Kind::kProgram},
                                                {".tap", JobFile::Kind::kProgram}}};

// Returns an error about a stroke of a path that a flat file cannot hold.
Error cannot_hold(size_t stroke, const std::string& why) {
  return bad_input("stroke " + std::to_string(stroke) + ": " + why);
}

// Converts the strokes to coordinates of the plane of plane_onto("-y").
Result<std::vector<std::vector<Vec3>>> plane_points(std::span<const StrokePath> strokes) {
  const JobPlane plane = *plane_onto("-y");
  std::vector<std::vector<Vec3>> all;
  for (size_t i = 0; i < strokes.size(); ++i) {
    std::vector<Vec3>& points = all.emplace_back();
    for (const Pose& key : strokes[i].keys) {
      const Vec3 tilt = key.direction - plane.beam;
      if (glm::dot(tilt, tilt) > kUnitSlack)
        return cannot_hold(i, "only a beam along -y can be converted; keep the path as JSON");
      points.push_back(plane.coordinates(key.origin));
    }
  }
  return all;
}

// Returns the times of points that are passed at kDrawingSpeed. They ascend even where points coincide.
std::vector<double> drawing_times(const std::vector<Vec3>& points) {
  std::vector<double> times{0};
  for (size_t k = 1; k < points.size(); ++k) {
    const double time = times.back() + glm::length(points[k] - points[k - 1]) / kDrawingSpeed;
    times.push_back(std::max(time, std::nextafter(times.back(), 1e300)));
  }
  return times;
}

// Lays a line round the cylinder of a wrapped plane, at kDrawingSpeed on its surface.
void wrap_line(const DrawnLine& line, Vec2 middle, const JobPlane& plane, StrokePath& stroke) {
  std::vector<Vec2> points = line.points;
  if (line.closed) points.push_back(points.front());
  stroke.range = Interval{0, 2 * plane.wrap};
  stroke.keys.push_back(plane.wrapped_beam(points.front() - middle));
  stroke.times.push_back(0);
  for (size_t i = 1; i < points.size(); ++i) {
    const Vec2 from = points[i - 1] - middle, to = points[i] - middle;
    const double length = plane.scale * glm::length(to - from);
    const auto steps = static_cast<size_t>(std::ceil(std::max(1.0, length / plane.wrap / kWrapStep)));
    for (size_t k = 1; k <= steps; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(steps);
      stroke.keys.push_back(plane.wrapped_beam(from + share * (to - from)));
      const double time = stroke.times.back() + length / static_cast<double>(steps) / kDrawingSpeed;
      stroke.times.push_back(std::max(time, std::nextafter(stroke.times.back(), 1e300)));
    }
  }
}

double largest_power(std::span<const StrokePath> strokes) {
  double power = 0;
  for (const StrokePath& stroke : strokes) power = std::max(power, stroke.power.value_or(0));
  return power > 0 ? power : 1000;
}

// Returns true if F can state the speed of all moves, in mm/min.
bool has_feeds(const std::vector<Vec3>& points, const std::vector<double>& times) {
  constexpr double kMaxFeed = 1e9;
  for (size_t k = 1; k < points.size(); ++k) {
    if (!(60'000 * glm::length(points[k] - points[k - 1]) <= kMaxFeed * (times[k] - times[k - 1])))
      return false;
  }
  return true;
}

Result<std::vector<ProgramStroke>> program_of(std::span<const StrokePath> strokes, double power_at_s1000) {
  auto all = plane_points(strokes);
  if (!all) return all.error();
  std::vector<ProgramStroke> program;
  for (size_t i = 0; i < strokes.size(); ++i) {
    const double power = 1000 * strokes[i].power.value_or(power_at_s1000) / power_at_s1000;
    if (!(power <= 1e9)) return cannot_hold(i, "S is too large; use a larger --power-at-s1000");
    for (const Vec3& point : (*all)[i]) {
      if (!(glm::length(point) <= 1e5)) return cannot_hold(i, "a point is farther than 100 km from the zero");
    }
    if (!has_feeds((*all)[i], strokes[i].times))
      return cannot_hold(i, "a move is faster than 1e9 mm/min; give its keys times that are farther apart");
    if (power > 0) program.push_back({std::move((*all)[i]), strokes[i].times, power, 0});
  }
  return program;
}

}  // namespace

Vec3 JobPlane::point(Vec2 p, double height) const {
  const auto [sin, cos] = sin_cos(turn);
  const Vec2 q = scale * Vec2(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
  return at + q.x * right + q.y * up - scale * height * beam;
}

Vec3 JobPlane::direction(const Vec3& d) const {
  const auto [sin, cos] = sin_cos(turn);
  return glm::normalize((cos * d.x - sin * d.y) * right + (sin * d.x + cos * d.y) * up - d.z * beam);
}

Pose JobPlane::wrapped_beam(Vec2 p) const {
  KERF_ASSERT(wrap > 0);
  const auto [turn_sin, turn_cos] = sin_cos(turn);
  const Vec2 q = scale * Vec2(turn_cos * p.x - turn_sin * p.y, turn_sin * p.x + turn_cos * p.y);
  const auto [sin, cos] = sin_cos(q.x / wrap);
  const Vec3 outward = sin * right - cos * beam, axis = at + wrap * beam;
  return {axis + q.y * up + 2 * wrap * outward, -outward};
}

Pose JobPlane::beam_to(Vec2 p) const {
  if (wrap > 0) return wrapped_beam(p);
  const Vec3 target = point(p, 0);
  return eye ? Pose{*eye, glm::normalize(target - *eye)} : Pose{target, beam};
}

Vec3 JobPlane::coordinates(const Vec3& point) const {
  KERF_ASSERT(turn == 0 && scale == 1);
  return {glm::dot(point - at, right), glm::dot(point - at, up), -glm::dot(point - at, beam)};
}

Result<JobPlane> plane_onto(std::string_view axis) {
  for (const NamedPlane& row : kPlanes) {
    if (row.name != axis) continue;
    JobPlane plane;
    plane.right = row.right;
    plane.up = row.up;
    plane.beam = -glm::cross(row.right, row.up) + Vec3(0);
    return plane;
  }
  return bad_input("\"" + std::string(axis) +
                   "\" is not a valid value; the values are: +x, -x, +y, -y, +z, -z");
}

std::optional<JobFile::Kind> job_kind(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const JobEnding& row : kJobEndings) {
    if (row.ending == ending) return row.kind;
  }
  return std::nullopt;
}

bool is_drawing_file(const std::filesystem::path& file) {
  const auto kind = job_kind(file);
  return kind == JobFile::Kind::kSvg || kind == JobFile::Kind::kDxf;
}

Result<JobFile> read_job_text(std::string_view text, const std::string& where, JobFile::Kind kind,
                              double tolerance, const RotaryAxes& rotary) {
  JobFile job;
  job.kind = kind;
  if (kind == JobFile::Kind::kPath) {
    if (const Status s = unpack(read_path_text(text, where), job.path); !s) return s.error();
  } else if (kind == JobFile::Kind::kProgram) {
    if (const Status s = unpack(read_gcode(text, where, tolerance, rotary), job.program); !s)
      return s.error();
    job.notes = job.program.notes;
  } else {
    auto drawing =
        kind == JobFile::Kind::kSvg ? read_svg(text, where, tolerance) : read_dxf(text, where, tolerance);
    if (!drawing) return drawing.error();
    job.drawing = std::move(*drawing);
    const auto left_out = left_out_text(job.drawing);
    if (job.drawing.lines.empty())
      return bad_input(where + ": the drawing has no lines" + (left_out ? "; " + *left_out : ""));
    if (left_out) job.notes.push_back(*left_out);
  }
  return job;
}

Result<JobFile> read_job(const std::filesystem::path& file, JobFile::Kind kind, double tolerance,
                         const RotaryAxes& rotary) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return read_job_text(*text, file.string(), kind, tolerance, rotary);
}

static void describe(Fields& f, RotaryAxis& axis) {
  constexpr std::array kTurns{"table", "head"};
  std::string letter(1, axis.letter);
  f.text("letter", letter);
  f.check(letter == "A" || letter == "B" || letter == "C", "letter", "must be \"A\", \"B\" or \"C\"");
  if (f.reading() && !letter.empty()) axis.letter = letter.front();
  f.choice("turns", axis.turns, kTurns);
  f.vector("axis", axis.axis, VectorRule::kNotZero);
  f.vector("pivot", axis.pivot, VectorRule::kNearby, Vec3(0));
  if (f.reading() && f.good()) axis.axis = beam_direction(axis.axis);
}

static void describe(Fields& f, RotaryAxes& rotary) {
  constexpr NumberRange kHeight{0, 1e3, "m"};
  f.elements("axes", "axes", kNeeded, rotary.axes, [&](size_t i, Fields& axis) {
    describe(axis, rotary.axes[i]);
    const char letter = rotary.axes[i].letter;
    for (size_t k = 0; k < i; ++k)
      axis.check(rotary.axes[k].letter != letter, "letter", "is in the list twice");
  });
  f.check(!rotary.axes.empty(), "axes", "must list an axis");
  f.number("height", rotary.height, kHeight, 0.0);
}

Result<RotaryAxes> read_rotary_axes(const std::filesystem::path& file) {
  return read_described<RotaryAxes>(file);
}

std::vector<StrokePath> drawing_strokes(std::span<const DrawnLine> lines, Vec2 middle,
                                        const JobPlane& plane) {
  std::vector<StrokePath> strokes;
  for (const DrawnLine& line : lines) {
    StrokePath& stroke = strokes.emplace_back();
    if (plane.wrap > 0) {
      wrap_line(line, middle, plane, stroke);
      continue;
    }
    std::vector<Vec3> passed;
    for (const Vec2& point : line.points) {
      stroke.keys.push_back(plane.beam_to(point - middle));
      passed.push_back(plane.point(point - middle, 0));
    }
    if (line.closed) {
      stroke.keys.push_back(stroke.keys.front());
      passed.push_back(passed.front());
    }
    stroke.times = drawing_times(passed);
  }
  return strokes;
}

std::vector<StrokePath> program_strokes(const Program& program, const JobPlane& plane,
                                        std::optional<double> power_at_s1000) {
  std::vector<StrokePath> strokes;
  for (const ProgramStroke& lit : program.strokes) {
    StrokePath& stroke = strokes.emplace_back();
    for (size_t k = 0; k < lit.points.size(); ++k) {
      const Vec3& point = lit.points[k];
      if (lit.angles.empty()) {
        stroke.keys.push_back({plane.point({point.x, point.y}, point.z), plane.beam});
        continue;
      }
      const Pose beam = program.rotary.beam({point, lit.angles[k]});
      stroke.keys.push_back({plane.point(Vec2(beam.origin), beam.origin.z), plane.direction(beam.direction)});
    }
    stroke.times = lit.times;
    if (power_at_s1000) stroke.power = lit.power_word / 1000 * *power_at_s1000;
  }
  return strokes;
}

Result<std::vector<DrawnLine>> plane_lines(std::span<const StrokePath> strokes) {
  const auto all = plane_points(strokes);
  if (!all) return all.error();
  std::vector<DrawnLine> lines;
  for (size_t i = 0; i < all->size(); ++i) {
    DrawnLine line;
    line.layer = std::to_string(i);
    const std::vector<Vec3>& points = (*all)[i];
    for (const Vec3& point : points) {
      if (std::abs(point.z - points.front().z) > 1e-9 * (1 + std::abs(point.z)))
        return cannot_hold(i, "the path is not level; only flat paths can be converted");
      if (line.points.empty() || Vec2(point) != line.points.back()) line.points.emplace_back(point);
    }
    if (line.points.size() > 3 && line.points.front() == line.points.back()) {
      line.points.pop_back();
      line.closed = true;
    }
    if (line.points.size() > 1) lines.push_back(std::move(line));
  }
  return lines;
}

Result<std::string> strokes_gcode(std::span<const StrokePath> strokes, std::optional<double> power_at_s1000,
                                  const PostProcessor& post) {
  const double power = power_at_s1000.value_or(largest_power(strokes));
  const auto program = program_of(strokes, power);
  if (!program) return program.error();
  std::string comment = "Kerf, " + count_text(strokes.size(), "stroke") + ", S";
  append_number(comment, post.full_power);
  comment += " is ";
  append_number(comment, power);
  return gcode_text(*program, comment + " W", post);
}

Result<std::string> strokes_gcode_with_same_s(std::span<const StrokePath> strokes, PostProcessor post) {
  post.full_power = 1000;
  const auto program = program_of(strokes, post.full_power);
  if (!program) return program.error();
  return gcode_text(*program, "Kerf, " + count_text(strokes.size(), "stroke"), post);
}

namespace {

void code_lines_field(Fields& f, const char* key, std::vector<std::string>& lines) {
  f.value(
      key,
      [&](const JsonValue& value) -> Status {
        if (const Status list = value.array("lines of G-code"); !list) return list;
        lines.clear();
        for (size_t i = 0; i < value.json().size(); ++i) {
          if (const Status s = assign(value[i].text(), lines.emplace_back()); !s) return s;
        }
        return Done{};
      },
      [&] { return nlohmann::ordered_json(lines); }, kOptional);
}

}  // namespace

static void describe(Fields& f, PostProcessor& post) {
  constexpr NumberRange kFullPower{1e-6, 1e6, ""};
  f.flag("percent", post.percent, post.percent);
  code_lines_field(f, "begin", post.begin);
  code_lines_field(f, "end", post.end);
  f.filled_text("laser_on", post.laser_on, post.laser_on);
  f.filled_text("laser_off", post.laser_off, post.laser_off);
  f.number("full_power", post.full_power, kFullPower, post.full_power);
  if (f.present("decimals", post.decimals.has_value()))
    f.whole("decimals", f.reading() ? post.decimals.emplace() : *post.decimals, 0, 17);
}

Result<PostProcessor> read_post_processor(const std::filesystem::path& file) {
  return read_described<PostProcessor>(file);
}

Result<std::string> strokes_svg(std::span<const StrokePath> strokes) {
  const auto lines = plane_lines(strokes);
  if (!lines) return lines.error();
  return svg_text(*lines);
}

}  // namespace kerf
