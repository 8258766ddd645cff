#include "core/document/files/edit_path.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/tick.h"
#include "core/base/unit_vector.h"

namespace kerf {

namespace {

constexpr double kLongestMove = 1e6;  // s, so that times stay far from where doubles end

double seconds_between(const Pose& a, const Pose& b, double speed) {
  const double seconds = glm::length(b.origin - a.origin) / speed;
  return std::clamp(seconds, seconds_of_ticks(1), kLongestMove);
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
  const double speed = mean_speed(stroke);
  stroke.times.insert(stroke.times.begin() + static_cast<std::ptrdiff_t>(at), time_at(stroke, at, pose));
  stroke.keys.insert(stroke.keys.begin() + static_cast<std::ptrdiff_t>(at), pose);
  if (!ascends(stroke.times)) retime(stroke, speed);
}

void erase_key(StrokePath& stroke, size_t at) {
  KERF_ASSERT(at < stroke.keys.size());
  stroke.keys.erase(stroke.keys.begin() + static_cast<std::ptrdiff_t>(at));
  stroke.times.erase(stroke.times.begin() + static_cast<std::ptrdiff_t>(at));
}

std::optional<std::string> why_no_cut(std::span<const StrokePath> strokes) {
  if (strokes.empty()) return "The path has no points.";
  for (size_t i = 0; i < strokes.size(); ++i) {
    const std::vector<Pose>& keys = strokes[i].keys;
    for (size_t k = 1; k < keys.size(); ++k) {
      if (!are_opposite(keys[k - 1].direction, keys[k].direction)) continue;
      return "Points " + std::to_string(k) + " and " + std::to_string(k + 1) + " of stroke " +
             std::to_string(i + 1) + " aim in opposite directions: put a point between them.";
    }
  }
  return std::nullopt;
}

}  // namespace kerf
