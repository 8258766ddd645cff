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

// A stroke as read from a file: the laser settings that the file gives, and the keys in the order of time.
// Directions are unit vectors.
struct StrokePath {
  std::optional<double> radius;             // m
  std::optional<Interval> range;            // m
  std::optional<double> power;              // W
  std::optional<double> wavelength, focus;  // m
  std::optional<double> pulse_rate;         // Hz
  std::optional<double> duty;               // 0 .. 1
  std::vector<Pose> keys;
  std::vector<double> times;  // s, one per key, ascending
};

// The strokes of a path file: {"strokes": [{"laser": {...}, "keys": [{"t", "origin", "direction"}, ...]}]}.
// The error names the first wrong value by its JSON pointer.
Result<std::vector<StrokePath>> read_path_file(const std::filesystem::path& file);

// Returns true if a file is JSON with strokes and without bodies, i.e. a path and not a scene.
bool is_path_file(const std::filesystem::path& file);

// Normalises a direction of a path file without overflow. Precondition: v is finite and not zero.
Vec3 beam_direction(const Vec3& v);

class Fields;

// The fields of a stroke in path files and scenes. Reading restores a written stroke to the bit.
void describe(Fields& f, StrokePath& stroke);

// The text of a path file, one line per key.
std::string path_file_text(std::span<const StrokePath> strokes);
// Parses such a text. Fails like read_path_file(); `where` is the name of the text in errors.
Result<std::vector<StrokePath>> read_path_text(std::string_view text, const std::string& where);

// Manual edits of a stroke, which has one time per key.

// The path length of the beam's origin [m], and its duration [s].
double way_of(const StrokePath& stroke);
double duration_of(const StrokePath& stroke);

// Sets the times so that the origin moves at a constant speed [m/s, > 0] from time 0 on. Where only the
// direction changes, the next key follows a tick later.
void retime(StrokePath& stroke, double speed);

// Inserts a key before index `at`, or at the end. Its time is the middle of its neighbours; at an end of
// the stroke it continues the mean speed of the stroke. Preconditions: at <= keys, the direction is a unit
// vector.
void insert_key(StrokePath& stroke, size_t at, const Pose& pose);
// Removes a key with its time. Precondition: at < keys.
void erase_key(StrokePath& stroke, size_t at);

// The reason why a path file with these strokes would be rejected, one sentence; nullopt if there is none.
std::optional<std::string> rejection_reason(std::span<const StrokePath> strokes);

}  // namespace kerf
