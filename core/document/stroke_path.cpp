#include "core/document/stroke_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/json.h"
#include "core/base/number_format.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"

namespace kerf {

static void describe(Fields& f, std::vector<StrokePath>& strokes) { f.list("strokes", "strokes", strokes); }

Vec3 beam_direction(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  KERF_ASSERT(largest > 0);
  return glm::normalize(v / largest);
}

Result<std::vector<StrokePath>> read_path_file(const std::filesystem::path& file) {
  return read_described<std::vector<StrokePath>>(file);
}

Result<std::vector<StrokePath>> read_path_text(std::string_view text, const std::string& where) {
  std::vector<StrokePath> strokes;
  const Status read = read_text_fields(text, where, {}, [&](Fields& f) { describe(f, strokes); });
  if (!read) return read.error();
  return strokes;
}

bool is_path_file(const std::filesystem::path& file) {
  if (file.extension() != ".json") return false;
  const auto text = read_text_file(file);
  if (!text) return false;
  const auto json = parse_json(*text, file.string());
  return json && json->is_object() && json->contains("strokes") && !json->contains("bodies");
}

namespace {

// Returns numbers that are read back as this unit vector to the bit. Normalising a unit vector again may
// change its last bits; for one of its multiples it does not.
Vec3 readable_direction(const Vec3& unit) {
  constexpr int kTries = 4096;
  for (int i = 0; i < kTries; ++i) {
    const Vec3 multiple = unit * (2.0 * i + 1);
    if (beam_direction(multiple) == unit) return multiple;
  }
  return unit;
}

constexpr NumberRange kRadius{0, std::numeric_limits<double>::max(), "m"};

void laser_fields(Fields& f, StrokePath& stroke) {
  f.number("radius", stroke.radius, kRadius);
  f.interval("range", stroke.range);
  f.number("power", stroke.power, kPositive);
  f.number("wavelength", stroke.wavelength, kPositive);
  f.number("focus", stroke.focus, kPositive);
  f.number("pulse_rate", stroke.pulse_rate, kPositive);
  f.number("duty", stroke.duty, kPositiveShare);
}

void key_fields(Fields& f, StrokePath& stroke, size_t k) {
  stroke.times.resize(stroke.keys.size());
  const double &t = stroke.times[k], before = k > 0 ? stroke.times[k - 1] : 0;
  Pose& pose = stroke.keys[k];
  f.number("t", stroke.times[k], kFinite);
  f.check(k == 0 || t > before, "t", "must be greater than the previous one: times must ascend");
  f.check(k == 0 || std::isfinite(t - stroke.times.front()), "t", "is too far from the first time");
  f.vector("origin", pose.origin);
  Vec3 direction = f.reading() ? pose.direction : readable_direction(pose.direction);
  f.vector("direction", direction, VectorRule::kNotZero);
  if (f.reading()) pose.direction = beam_direction(direction);
}

// `is_draft`: see read_path_draft().
void stroke_fields(Fields& f, StrokePath& stroke, bool is_draft) {
  f.member("laser", kOptional, [&](Fields& laser) { laser_fields(laser, stroke); });
  f.elements("keys", "keys", kNeeded, stroke.keys, [&](size_t k, Fields& key) {
    key_fields(key, stroke, k);
    key.check(is_draft || k == 0 || !are_opposite(stroke.keys[k - 1].direction, stroke.keys[k].direction),
              "direction", "is opposite to the previous one: insert a key between them");
  });
  f.check(!stroke.keys.empty(), "keys", "must contain at least one key");
  f.check(is_draft || stroke.radius != 0.0 || stroke.keys.size() > 1, "keys",
          "must contain two keys for a knife of radius 0");
}

constexpr double kMaxMove = 1e6;  // s, far below the limit of doubles

double seconds_between(const Pose& a, const Pose& b, double speed) {
  const double seconds = glm::length(b.origin - a.origin) / speed;
  return std::clamp(seconds, seconds_of_ticks(1), kMaxMove);
}

double mean_speed(const StrokePath& stroke) {
  const double way = way_of(stroke), duration = duration_of(stroke);
  return way > 0 && duration > 0 ? way / duration : 1;
}

double time_at(const StrokePath& stroke, size_t at, const Pose& pose) {
  const std::vector<double>& times = stroke.times;
  if (times.empty()) return 0;
  if (at == 0) return times.front() - seconds_between(pose, stroke.keys.front(), mean_speed(stroke));
  if (at == times.size()) return times.back() + seconds_between(stroke.keys.back(), pose, mean_speed(stroke));
  return 0.5 * times[at - 1] + 0.5 * times[at];
}

bool ascends(const std::vector<double>& times) {
  return std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); }) ==
         times.end();
}

}  // namespace

void describe(Fields& f, StrokePath& stroke) { stroke_fields(f, stroke, false); }

Result<std::vector<StrokePath>> read_path_draft(std::string_view text, const std::string& where) {
  std::vector<StrokePath> strokes;
  const Status read = read_text_fields(text, where, {}, [&](Fields& f) {
    f.elements("strokes", "strokes", kNeeded, strokes,
               [&](size_t i, Fields& stroke) { stroke_fields(stroke, strokes[i], true); });
  });
  if (!read) return read.error();
  return strokes;
}

std::string path_file_text(std::span<const StrokePath> strokes) {
  std::string text = "{\"strokes\": [";
  for (size_t i = 0; i < strokes.size(); ++i) {
    StrokePath stroke = strokes[i];
    const auto laser = visited_json({}, [&](Fields& f) { laser_fields(f, stroke); });
    text += (i > 0 ? ",\n  " : "\n  ") + ("{\"laser\": " + laser.dump()) + ", \"keys\": [";
    for (size_t k = 0; k < stroke.keys.size(); ++k) {
      const auto key = visited_json({}, [&](Fields& f) { key_fields(f, stroke, k); });
      text += (k > 0 ? ",\n    " : "\n    ") + key.dump();
    }
    text += "]}";
  }
  return text + "]}\n";
}

double way_of(const StrokePath& stroke) {
  double way = 0;
  for (size_t k = 1; k < stroke.keys.size(); ++k)
    way += glm::length(stroke.keys[k].origin - stroke.keys[k - 1].origin);
  return way;
}

double duration_of(const StrokePath& stroke) {
  return stroke.times.empty() ? 0 : stroke.times.back() - stroke.times.front();
}

void retime(StrokePath& stroke, double speed) {
  KERF_ASSERT(speed > 0);
  stroke.times.assign(stroke.keys.size(), 0);
  for (size_t k = 1; k < stroke.keys.size(); ++k)
    stroke.times[k] = stroke.times[k - 1] + seconds_between(stroke.keys[k - 1], stroke.keys[k], speed);
}

void insert_key(StrokePath& stroke, size_t at, const Pose& pose) {
  KERF_ASSERT(at <= stroke.keys.size() && is_unit(pose.direction));
  KERF_ASSERT(stroke.times.size() == stroke.keys.size());
  const double speed = mean_speed(stroke);
  stroke.times.insert(stroke.times.begin() + static_cast<std::ptrdiff_t>(at), time_at(stroke, at, pose));
  stroke.keys.insert(stroke.keys.begin() + static_cast<std::ptrdiff_t>(at), pose);
  if (!ascends(stroke.times)) retime(stroke, speed);
}

void erase_key(StrokePath& stroke, size_t at) {
  KERF_ASSERT(stroke.times.size() == stroke.keys.size());
  KERF_ASSERT(at < stroke.keys.size());
  stroke.keys.erase(stroke.keys.begin() + static_cast<std::ptrdiff_t>(at));
  stroke.times.erase(stroke.times.begin() + static_cast<std::ptrdiff_t>(at));
}

std::optional<std::string> rejection_reason(std::span<const StrokePath> strokes) {
  if (strokes.empty()) return "The path has no points.";
  for (size_t i = 0; i < strokes.size(); ++i) {
    const std::vector<Pose>& keys = strokes[i].keys;
    if (keys.empty()) return "Stroke " + std::to_string(i + 1) + " has no points.";
    if (strokes[i].radius == 0.0 && keys.size() < 2)
      return "Stroke " + std::to_string(i + 1) + " is cut by the knife: add a second point.";
    for (size_t k = 1; k < keys.size(); ++k) {
      if (!are_opposite(keys[k - 1].direction, keys[k].direction)) continue;
      return "Points " + std::to_string(k) + " and " + std::to_string(k + 1) + " of stroke " +
             std::to_string(i + 1) + " aim in opposite directions: insert a point between them.";
    }
  }
  return std::nullopt;
}

double positive(double length) { return std::clamp(length, kPositive.least, kPositive.most); }

CutSettings default_settings(const StrokePath& stroke, double diagonal) {
  CutSettings settings;
  settings.laser.radius = stroke.radius.value_or(positive(diagonal / 400));
  settings.laser.range = stroke.range.value_or(Interval{0, positive(10 * diagonal)});
  settings.laser.power = stroke.power.value_or(settings.laser.power);
  settings.laser.wavelength = stroke.wavelength.value_or(0);
  settings.laser.focus = stroke.focus;
  settings.laser.pulse_rate = stroke.pulse_rate.value_or(0);
  settings.laser.duty = stroke.duty.value_or(1);
  settings.resolution.target_edge = positive(settings.laser.radius / 4);
  settings.resolution.tolerance = positive(settings.laser.radius / 8);
  return settings;
}

double default_heat_width(double radius, double metre) {
  constexpr double kGlowsForSeconds = 0.006;  // m, of steel
  return std::min(8 * radius, 2 * std::sqrt(kGlowsForSeconds * metre * radius));
}

std::vector<Command> stroke_commands(const StrokePath& stroke, const CutSettings& settings) {
  KERF_ASSERT(!stroke.keys.empty() && stroke.keys.size() == stroke.times.size());
  if (settings.laser.radius == 0)
    return {CutPath{{stroke.keys, settings.laser.range}, settings.bodies, settings.max_faces}};
  std::vector<Command> commands{BeginStroke{settings, stroke.keys.front()}};
  for (size_t k = 1; k < stroke.keys.size(); ++k)
    commands.emplace_back(MoveBeam{stroke.keys[k], stroke.times[k] - stroke.times.front()});
  commands.emplace_back(EndStroke{});
  return commands;
}

std::vector<Command> path_commands(std::span<const StrokePath> strokes, double diagonal,
                                   const std::function<Resolution(double)>& resolution) {
  std::vector<Command> all;
  for (const StrokePath& stroke : strokes) {
    CutSettings settings = default_settings(stroke, diagonal);
    if (resolution) settings.resolution = resolution(settings.laser.radius);
    const std::vector<Command> own = stroke_commands(stroke, settings);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

std::vector<Command> scene_stroke_commands(const StrokePath& stroke, double diagonal) {
  if (stroke.keys.empty()) return {};
  CutSettings settings = default_settings(stroke, diagonal);
  settings.resolution.rim = Rim::kSmooth;
  settings.heat_width = default_heat_width(settings.laser.radius);
  return stroke_commands(stroke, settings);
}

}  // namespace kerf
