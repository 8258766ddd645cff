#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/laser/laser.h"

namespace kerf {

// A stroke as a file holds it: what it says of the laser, and its keys in the order of time. Directions are
// unit.
struct StrokePath {
  std::optional<double> radius;   // m
  std::optional<Interval> range;  // m
  std::optional<double> power;    // W
  std::vector<Pose> keys;
  std::vector<double> times;  // s, one a key, ascending
};

// The strokes of a path file: {"strokes": [{"laser": {...}, "keys": [{"t", "origin", "direction"}, ...]}]}.
// Anything that is wrong is one sentence with a JSON pointer.
Result<std::vector<StrokePath>> read_path_file(const std::filesystem::path& file);

}  // namespace kerf
