#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/stroke_path.h"
#include "core/laser/compensation.h"
#include "core/laser/drawing.h"
#include "core/laser/gcode.h"

namespace kerf {

// Drawings and programs as strokes, and strokes as files.

// The plane of a drawing or a program in the world. The beam goes along one axis. Seen along the beam,
// `right` and `up` are the axes of the drawing.
struct JobPlane {
  Vec3 right{1, 0, 0}, up{0, 0, -1}, beam{0, -1, 0};  // unit vectors; right x up = -beam
  Vec3 at{0};       // where the middle of the drawing, or the zero of the program lies [m]
  double turn = 0;  // rad, counter-clockwise as seen along the beam
  double scale = 1;
  // Radius of the cylinder around which the plane is wrapped [m]; 0: none. The cylinder touches the plane
  // along the line through `at` in the direction `up`, behind the plane. The beam then goes towards its axis.
  double wrap = 0;
  // If set, the beam goes from here through the points of the plane, as in a perspective view [m]. It lies
  // before the plane. Without effect if the plane is wrapped.
  std::optional<Vec3> eye;

  // Maps a point of the plane, which lies `height` metres before it against the beam.
  Vec3 point(Vec2 p, double height) const;
  // Maps a unit vector with such coordinates.
  Vec3 direction(const Vec3& d) const;
  // Maps a point of the wrapped plane to a beam that starts one radius above the cylinder and reaches its
  // surface there. Precondition: wrap > 0.
  Pose wrapped_beam(Vec2 p) const;
  // Returns the beam to a point of the plane: wrapped_beam(), from the eye, or from the point along `beam`.
  Pose beam_to(Vec2 p) const;
  // Maps a point of the world to the plane, with the height as its third coordinate. Precondition: turn 0,
  // scale 1.
  Vec3 coordinates(const Vec3& point) const;
};

// Returns the plane for a beam along "+x", "-x", "+y", "-y", "+z" or "-z", with the other members at their
// defaults. Upright drawings stand upright: their up is +y for horizontal beams, -z for -y and +z for +y.
// Fails for other names.
Result<JobPlane> plane_onto(std::string_view axis);

// Speed of the beam along a drawing, which has none [m/s].
inline constexpr double kDrawingSpeed = 0.02;

// Largest turn of the beam between two keys along a wrapped drawing [rad].
inline constexpr double kWrapStep = 0.035;

// A file that describes strokes: a path (.json), a drawing (.svg, .dxf) or a program (.nc).
struct JobFile {
  enum class Kind { kPath, kSvg, kDxf, kProgram };
  Kind kind = Kind::kPath;
  std::vector<StrokePath> path;
  Drawing drawing;
  Program program;
  std::vector<std::string> notes;  // on parts of the file that have no effect

  bool is_drawing() const { return kind == Kind::kSvg || kind == Kind::kDxf; }
};

// Returns the kind of a file by its extension: .json, .svg, .dxf, or .nc, .ngc, .gcode, .tap; nullopt for
// others.
std::optional<JobFile::Kind> job_kind(const std::filesystem::path& file);
// Returns true if the kind is a drawing.
bool is_drawing_file(const std::filesystem::path& file);

// Read a file or its text. Curves are flattened within `tolerance` [m, > 0]; `where` names the text in
// errors; `rotary` holds the rotary axes of programs. Fail with bad input like read_svg(), read_dxf(),
// read_gcode() and read_path_file(), and for drawings without lines.
Result<JobFile> read_job(const std::filesystem::path& file, JobFile::Kind kind, double tolerance,
                         const RotaryAxes& rotary = {});
Result<JobFile> read_job_text(std::string_view text, const std::string& where, JobFile::Kind kind,
                              double tolerance, const RotaryAxes& rotary = {});

// Reads the JSON of the rotary axes of a machine. Lists with a letter twice or without axes are bad input.
//
//   {"axes": [{"letter": "A", "turns": "table", "axis": [1, 0, 0], "pivot": [0, 0, -0.025]}], "height":
//   0.005}
//
// `pivot` and `height` are zero by default.
Result<RotaryAxes> read_rotary_axes(const std::filesystem::path& file);

// Returns the strokes of lines of a drawing, in order, at kDrawingSpeed. A closed line ends at its first
// point. On a wrapped plane the beam turns by at most kWrapStep between two keys, and its range ends at the
// axis. From an eye the beam only turns.
std::vector<StrokePath> drawing_strokes(std::span<const DrawnLine> lines, Vec2 middle, const JobPlane& plane);

// Returns the strokes of a program. X is to the right, Y up and Z against the beam, before rotary axes turn
// it. Times are those of the program. With `power_at_s1000` [W], S sets the power.
std::vector<StrokePath> program_strokes(const Program& program, const JobPlane& plane,
                                        std::optional<double> power_at_s1000);

// Returns the strokes as lines of the plane of plane_onto("-y"), or their program. Strokes with another
// direction, or lines that are not level, are bad input. A closed line is one that ends at its first point.
// The layer of a line is the index of its stroke; strokes of one point have none.
Result<std::vector<DrawnLine>> plane_lines(std::span<const StrokePath> strokes);
// Returns the strokes as a G-code program. PostProcessor::full_power stands for `power_at_s1000` [W]; by
// default for the largest power of the strokes, or for 1000 W if none has a power. Strokes without a power
// use full power.
Result<std::string> strokes_gcode(std::span<const StrokePath> strokes, std::optional<double> power_at_s1000,
                                  const PostProcessor& post = {});
// Returns strokes of a program, read with 1000 W at S1000, as a program with the same S.
Result<std::string> strokes_gcode_with_same_s(std::span<const StrokePath> strokes, PostProcessor post);
// Reads the JSON of a post-processor, whose keys are the members of PostProcessor; missing ones keep their
// defaults.
Result<PostProcessor> read_post_processor(const std::filesystem::path& file);
// The page is centred at the zero of the world, so that reading the file restores positions.
Result<std::string> strokes_svg(std::span<const StrokePath> strokes);

}  // namespace kerf
