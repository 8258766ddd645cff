#include "ui/editor/path/path_work.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/json.h"
#include "core/document/stroke_path.h"
#include "ui/render/passes/beam_effects.h"

namespace kerf {

namespace {

constexpr size_t kMaxSteps = 200;  // undo steps

// Returns the distance to the first surface that the beam hits, else to the plane through the centre of the
// world perpendicular to it.
double distance_to_surface(const World& world, const Pose& pose) {
  if (const auto hit = first_hit(world, pose)) return *hit;
  const World::Bounds bounds = world.bounds();
  const double middle = glm::dot(0.5 * (bounds.min + bounds.max) - pose.origin, pose.direction);
  return middle > 0 ? middle : std::max(bounds.diagonal(), 1e-9) / 16;
}

}  // namespace

size_t PathWork::points() const {
  size_t points = 0;
  for (const StrokePath& stroke : strokes()) points += stroke.keys.size();
  return points;
}

double PathWork::speed() const {
  if (now_.speed) return *now_.speed;
  double way = 0, duration = 0;
  for (const StrokePath& stroke : strokes()) {
    way += way_of(stroke);
    duration += duration_of(stroke);
  }
  return duration > 0 ? way / duration : 0;
}

void PathWork::begin_edit() {
  undone_to_.push_back(now_);
  if (undone_to_.size() > kMaxSteps) undone_to_.erase(undone_to_.begin());
  redone_to_.clear();
  ++changes_;
  run_at_.reset();
}

void PathWork::keep_speed(size_t stroke) {
  if (now_.speed) retime(now_.strokes[stroke], *now_.speed);
}

void PathWork::add(const Pose& pose, double distance, bool new_stroke, double radius, double speed) {
  if (empty()) now_.speed = speed;
  size_t stroke = selected_ ? selected_->stroke : now_.strokes.size() - 1;
  if (empty() || new_stroke) {
    stroke = now_.strokes.size();
    now_.strokes.emplace_back().radius = radius;
    now_.distances.emplace_back();
  }
  const size_t keys = now_.strokes[stroke].keys.size();
  const size_t at = selected_ && selected_->stroke == stroke ? selected_->key + 1 : keys;
  insert_key(now_.strokes[stroke], at, pose);
  std::vector<double>& distances = now_.distances[stroke];
  distances.insert(distances.begin() + static_cast<std::ptrdiff_t>(at), distance);
  keep_speed(stroke);
  selected_ = PathPoint{stroke, at};
}

void PathWork::set(PathPoint p, const Pose& pose, double distance) {
  KERF_ASSERT(has(p) && is_unit(pose.direction));
  now_.strokes[p.stroke].keys[p.key] = pose;
  now_.distances[p.stroke][p.key] = distance;
  ++changes_;
  keep_speed(p.stroke);
}

void PathWork::remove(PathPoint p) {
  KERF_ASSERT(has(p));
  StrokePath& stroke = now_.strokes[p.stroke];
  std::vector<double>& distances = now_.distances[p.stroke];
  erase_key(stroke, p.key);
  distances.erase(distances.begin() + static_cast<std::ptrdiff_t>(p.key));
  if (!stroke.keys.empty()) {
    keep_speed(p.stroke);
    selected_ = PathPoint{p.stroke, p.key > 0 ? p.key - 1 : 0};
    return;
  }
  now_.strokes.erase(now_.strokes.begin() + static_cast<std::ptrdiff_t>(p.stroke));
  now_.distances.erase(now_.distances.begin() + static_cast<std::ptrdiff_t>(p.stroke));
  selected_.reset();
  if (empty()) return;
  const size_t before = p.stroke > 0 ? p.stroke - 1 : 0;
  selected_ = PathPoint{before, now_.strokes[before].keys.size() - 1};
}

void PathWork::set_radius(size_t stroke, double radius) {
  KERF_ASSERT(stroke < now_.strokes.size() && radius > 0);
  now_.strokes[stroke].radius = radius;
}

void PathWork::set_speed(double speed) {
  now_.speed = speed;
  for (size_t i = 0; i < now_.strokes.size(); ++i) keep_speed(i);
}

void PathWork::add_strokes(const std::vector<StrokePath>& strokes, const World& world, double distance,
                           double speed) {
  if (selected_ && now_.strokes[selected_->stroke].keys.size() == 1) remove(*selected_);
  if (empty()) now_.speed = speed;
  for (const StrokePath& stroke : strokes) {
    now_.strokes.push_back(stroke);
    std::vector<double>& distances = now_.distances.emplace_back();
    for (const Pose& pose : stroke.keys) distances.push_back(first_hit(world, pose).value_or(distance));
    keep_speed(now_.strokes.size() - 1);
  }
  selected_.reset();
}

void PathWork::load(std::vector<StrokePath> strokes, const World& world) {
  Version version;
  for (const StrokePath& stroke : strokes) {
    std::vector<double>& distances = version.distances.emplace_back();
    for (const Pose& pose : stroke.keys) distances.push_back(distance_to_surface(world, pose));
  }
  version.strokes = std::move(strokes);
  replace(std::move(version));
}

void PathWork::replace(Version version) {
  now_ = std::move(version);
  selected_.reset();
}

void PathWork::undo() {
  KERF_ASSERT(can_undo());
  ++changes_;
  redone_to_.push_back(std::exchange(now_, std::move(undone_to_.back())));
  undone_to_.pop_back();
  selected_.reset();
}

void PathWork::redo() {
  KERF_ASSERT(can_redo());
  ++changes_;
  undone_to_.push_back(std::exchange(now_, std::move(redone_to_.back())));
  redone_to_.pop_back();
  selected_.reset();
}

namespace {

constexpr const char* kDistancesKey = "distances";
constexpr const char* kSpeedKey = "speed";

// Returns one positive number per point, or nullopt if the entry is invalid.
std::optional<std::vector<std::vector<double>>> distances_of(const nlohmann::json& json,
                                                             const std::vector<StrokePath>& strokes) {
  if (!json.is_array() || json.size() != strokes.size()) return std::nullopt;
  std::vector<std::vector<double>> distances;
  for (size_t i = 0; i < strokes.size(); ++i) {
    if (!json[i].is_array() || json[i].size() != strokes[i].keys.size()) return std::nullopt;
    std::vector<double>& of_stroke = distances.emplace_back();
    for (const nlohmann::json& number : json[i]) {
      if (!number.is_number() || !std::isfinite(number.get<double>()) || number.get<double>() <= 0)
        return std::nullopt;
      of_stroke.push_back(number.get<double>());
    }
  }
  return distances;
}

std::optional<double> speed_of(const nlohmann::json& json) {
  if (!json.is_number() || !std::isfinite(json.get<double>()) || json.get<double>() <= 0) return std::nullopt;
  return json.get<double>();
}

}  // namespace

nlohmann::json path_entry(const PathWork& path) {
  if (path.empty()) return nullptr;
  nlohmann::json entry = nlohmann::json::parse(path_file_text(path.strokes()));
  entry[kDistancesKey] = path.distances();
  if (!path.has_times_of_file()) entry[kSpeedKey] = path.speed();
  return entry;
}

PathWork path_of_entry(const nlohmann::json& entry, const World& world) {
  PathWork path;
  if (!entry.is_object()) return path;
  nlohmann::json file{{"strokes", entry.value("strokes", nlohmann::json())}};
  Result<std::vector<StrokePath>> strokes = read_path_text(file.dump(), "path");
  if (!strokes) return path;
  const auto distances = distances_of(entry.value(kDistancesKey, nlohmann::json()), *strokes);
  const auto speed = speed_of(entry.value(kSpeedKey, nlohmann::json()));
  if (distances) {
    path.restore(std::move(*strokes), *distances, speed);
  } else {
    path.load(std::move(*strokes), world);
  }
  return path;
}

}  // namespace kerf
