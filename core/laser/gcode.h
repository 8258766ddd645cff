#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/laser/rotary_axes.h"

namespace kerf {

// A part of a program during which the laser is on with one power. Coordinates are those of the machine in
// metres, Z up; the beam points down, along -Z, unless rotary axes turn it.
struct ProgramStroke {
  std::vector<Vec3> points;   // at least one
  std::vector<double> times;  // s since the start of the program, one per point, ascending
  double power_word = 0;      // S, > 0
  size_t line = 0;            // of the file, where it begins
  // Without rotary axes, `angles` is empty.
  std::vector<Vec3> angles{};   // of A, B and C in degrees, one per point
  std::vector<size_t> lines{};  // of the file, of the move to each point
};

struct Program {
  std::vector<ProgramStroke> strokes;  // in order
  double duration = 0;                 // s, with rapid moves at kRapidSpeed and pauses of 0 s
  std::vector<std::string> notes;      // sentences on words whose effect depends on the machine
  RotaryAxes rotary;                   // of the machine
};

// Speeds of rapid moves, which a program does not state [m/s, degrees/s]. A rapid move takes the longer of
// the two times.
inline constexpr double kRapidSpeed = 10.0 / 60, kRapidTurn = 60;

// Reads a program of GRBL or LinuxCNC: G0 to G4, G17 to G21, G28, G43, G53 to G59, G64, G90 to G92, G90.1,
// G91.1, G93, G94, F, S, M0 to M5, M7 to M9, M30, X, Y, Z, I, J, K, R, P, H, line numbers, comments and %,
// and A, B, C of `rotary`. Any other word is bad input. The laser is on in feed moves while S > 0, except
// after M5; with M3 it is also on in dwells that follow a feed move. Offsets of tools and workpieces count as
// zero, and G28 goes to the zero of the machine. Arcs become chords within `tolerance` [m, > 0], and moves
// with rotations are divided (see RotaryAxes::parts). F is the speed along X, Y and Z, or that of the
// rotation in degrees per minute if only rotary axes move. Errors name the file, the line and the column.
// Linear in the file and the points.
Result<Program> read_gcode(std::string_view text, const std::string& file, double tolerance,
                           const RotaryAxes& rotary = {});

// The dialect of a controller. The default suits GRBL and LinuxCNC.
struct PostProcessor {
  bool percent = true;                                      // lines "%" around the program
  std::vector<std::string> begin{"G21 G90 G91.1 G94 G17"};  // select millimetres and absolute distances
  std::vector<std::string> end{"M2"};
  std::string laser_on = "M3", laser_off = "M5";  // of each stroke
  double full_power = 1000;                       // S of the largest power, > 0
  std::optional<int> decimals;                    // 0 .. 17; nullopt: as many as restore each number
};

// Formats a program in millimetres: each stroke is laser_on with its S, feed moves whose F gives the times,
// and laser_off. `power_word` of a stroke is in thousandths of the largest power. Without `decimals`, reading
// it back restores points and durations of the strokes to rounding. Precondition: strokes as in Program.
std::string gcode_text(std::span<const ProgramStroke> strokes, const std::string& comment,
                       const PostProcessor& post = {});

}  // namespace kerf
