#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands.h"
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

// Returns the text of a path file, one line per key.
std::string path_file_text(std::span<const StrokePath> strokes);
// Parses such a text. Fails like read_path_file(); `where` is the name of the text in errors.
Result<std::vector<StrokePath>> read_path_text(std::string_view text, const std::string& where);
// Parses the text of a path that is still being edited: its strokes may be those of rejection_reason(), but
// have a key.
Result<std::vector<StrokePath>> read_path_draft(std::string_view text, const std::string& where);

// Functions for editing a stroke by hand. Precondition of all: it has one time per key.

// Return the length of the path of the beam's origin [m], and the duration of the stroke [s].
double way_of(const StrokePath& stroke);
double duration_of(const StrokePath& stroke);

// Sets the times so that the origin moves at a constant speed [m/s, > 0], starting at time 0. If only the
// direction changes between two keys, the second follows one tick later.
void retime(StrokePath& stroke, double speed);

// Inserts a key before index `at`, or at the end. Its time is the middle of its neighbours; at an end of
// the stroke it continues the mean speed of the stroke. Preconditions: at <= keys, the direction is a unit
// vector.
void insert_key(StrokePath& stroke, size_t at, const Pose& pose);
// Removes a key with its time. Precondition: at < keys.
void erase_key(StrokePath& stroke, size_t at);

// Returns why a path file with these strokes would be rejected, as a sentence; nullopt if it would be
// accepted.
std::optional<std::string> rejection_reason(std::span<const StrokePath> strokes);

// Clamps a derived length, which may be zero or infinite, to the positive range that a journal can store.
double positive(double length);

// Returns the settings of a stroke: those in its file, and for the others defaults derived from the diagonal
// D of the bounding box of all meshes [m]: radius D/400, range 0 to 10 D, target edge a quarter of the
// radius.
CutSettings default_settings(const StrokePath& stroke, double diagonal);

// Returns the default width of the heat-affected zone of geometric cuts in the editor [m] (see
// CutSettings::heat_width) for a beam of this radius [m]: twice the geometric mean of the radius and 6 mm, a
// width over which steel glows for a few seconds, but at most eight radii. It grows with the radius, so that
// the glowing rim of a wide beam stays visible from a distance that shows the whole cut. `metre`: a metre in
// the unit of the radius and of the result, such as 1000 for millimetres.
double default_heat_width(double radius, double metre = 1);

// Returns the commands that draw a stroke, with times relative to its first key. Precondition: it has a key.
std::vector<Command> stroke_commands(const StrokePath& stroke, const CutSettings& settings);

// Returns the commands that draw the strokes of a path in order, with default_settings(), like `kerf cut
// --path` without further options. `resolution`, a function of the beam radius [m], overrides their
// resolution. Precondition: each stroke has a key.
std::vector<Command> path_commands(std::span<const StrokePath> strokes, double diagonal,
                                   const std::function<Resolution(double)>& resolution = {});

// Returns the commands that draw a stroke of a scene with its default settings and a hot smooth rim, as in
// the editor. Empty if the stroke has no key.
std::vector<Command> scene_stroke_commands(const StrokePath& stroke, double diagonal);

}  // namespace kerf
