#include "ui/editor/path/path_entry.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/document/files/path_text.h"

namespace kerf {

namespace {

constexpr const char* kDistancesKey = "distances";
constexpr const char* kSpeedKey = "speed";

// One positive number for each point, or nothing.
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
