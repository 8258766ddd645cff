#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/laser/laser.h"

namespace kerf {

// A stroke as read from a file: the settings of the laser that the file gives, and the keys in the order of
// time. Directions are unit vectors.
struct StrokePath {
  std::optional<double> radius;             // m
  std::optional<Interval> range;            // m
  std::optional<double> power;              // W
  std::optional<double> wavelength, focus;  // m
  std::optional<double> pulse_rate;         // Hz
  std::optional<double> duty;               // 0 .. 1
  std::vector<Pose> keys;
  std::vector<double> times;  // s, one a key, ascending
};

// The strokes of a path file: {"strokes": [{"laser": {...}, "keys": [{"t", "origin", "direction"}, ...]}]}.
// The error names the first wrong value by its JSON pointer.
Result<std::vector<StrokePath>> read_path_file(const std::filesystem::path& file);

// Whether a file is JSON with strokes and without bodies, i.e. a path and not a scene.
bool is_path_file(const std::filesystem::path& file);

// The unit vector that a direction in a path file stands for, computed without overflow. Precondition: v is
// finite and not zero.
Vec3 beam_direction(const Vec3& v);

}  // namespace kerf
