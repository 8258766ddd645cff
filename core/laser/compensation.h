#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/laser/drawing.h"

namespace kerf {

// The side of a line, seen along it.
enum class PathSide { kNone, kLeft, kRight };

// Returns the lines at the distance `radius` [m, > 0] on one side of a line, where a beam of this radius
// touches the line and nowhere crosses it: corners are round, and parts that come nearer to the line
// elsewhere are removed. The lines keep the direction of the source. Nothing is left of a hole that is
// narrower than the beam. Chords of round corners lie within kOffsetChord radii of the circle. Fails with bad
// input if the line has too many crossings. About O(n log n) for n points that are spread evenly.
// Precondition: side is not kNone.
Result<std::vector<DrawnLine>> offset_line(const DrawnLine& line, PathSide side, double radius);
inline constexpr double kOffsetChord = 1e-3;

// Sorts lines so that those inside others come before them; otherwise keeps their order. O(n^2) for n lines,
// O(n m) for their m points.
void order_inner_first(std::vector<DrawnLine>& lines);

// Reverses closed lines so that each runs against the line around it, so the waste of holes and outlines is
// on one side. Outermost lines keep their direction. Likewise O(n^2).
void alternate_directions(std::vector<DrawnLine>& lines);

struct ToolpathOptions {
  PathSide side = PathSide::kNone;
  double radius = 0;     // m; > 0 with a side or tabs
  double lead_in = 0;    // m; length of the straight entry from the waste; 0: none. Needs a side.
  int tabs = 0;          // bridges left in each closed line
  double tab_width = 0;  // m
};

struct Toolpath {
  std::vector<DrawnLine> strokes;  // open lines, in order; a closed line ends at its first point
  std::vector<std::string> notes;  // sentences on entries and tabs without room
};

// Turns the lines of a drawing into strokes: inner lines before outer ones, in alternating directions, offset
// to a side, with entries and tabs. Fails like offset_line(), or if there are more than 50 000 lines.
Result<Toolpath> make_toolpath(std::vector<DrawnLine> lines, const ToolpathOptions& options);

}  // namespace kerf
