#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

class Fields;

// The fields of a stroke in path files and scenes. A stroke that is written is read back to the bit.
void describe(Fields& f, StrokePath& stroke);

// The text of a path file, with one line for each key.
std::string path_file_text(std::span<const StrokePath> strokes);
// The strokes of such a text. Fails as read_path_file() does; `where` is the name of the text in errors.
Result<std::vector<StrokePath>> read_path_text(std::string_view text, const std::string& where);

// Edits of the strokes of a path by hand. A stroke has one time for each key.

// The length of the way of the beam's origin (m), and the time that it takes (s).
double way_of(const StrokePath& stroke);
double duration_of(const StrokePath& stroke);

// Sets the times so that the origin moves at a constant speed (m/s, > 0) from time 0 on. Where it stays in
// its place and the beam only turns, the next key comes a tick later.
void retime(StrokePath& stroke, double speed);

// Inserts a key before number `at`, or at the end. It comes halfway between its neighbours in time; at an end
// of the stroke it keeps up the mean speed of the stroke. Precondition: at <= keys, the direction is a unit
// vector.
void insert_key(StrokePath& stroke, size_t at, const Pose& pose);
// Removes a key with its time. Precondition: at < keys.
void erase_key(StrokePath& stroke, size_t at);

// The sentence why a path file with these strokes would be refused, or nothing.
std::optional<std::string> why_no_cut(std::span<const StrokePath> strokes);

}  // namespace kerf
