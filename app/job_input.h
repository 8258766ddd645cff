#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/document/cut_report.h"
#include "core/document/drawing_layers.h"
#include "core/document/job_files.h"

namespace kerf {

// The options of `kerf cut` for a drawing or a program instead of a path file.
struct JobInput {
  std::string drawing, gcode, layers, axes;  // files; empty: not given
  std::optional<std::string> onto, at, eye;
  std::optional<double> turn, scale, wrap, power_at_s1000;

  // Adds the options to the subcommand. Parsing fills this object.
  void add_to(CLI::App& command);
  // Returns the file that was given; empty if none was.
  const std::string& file() const { return drawing.empty() ? gcode : drawing; }

  // Checks the options and reads the file, with curves flattened within a fiftieth of the beam radius [m].
  // The error names the first wrong option, or the place in the file. `has_path`: a path file was given.
  Status read(bool has_path, std::optional<double> radius);
  // Replaces the strokes by those of the file that was read, placed for meshes with these bounds, and adds
  // notes and duration to the job. Does nothing if there is no file. Fails if the eye is in the drawing.
  Status add_strokes(const Bounds& bounds, std::vector<StrokePath>& strokes, CutJob& job) const;
  // Returns the line of the program whose move leads to a key of a stroke; nullopt if there is none.
  std::optional<size_t> line_of(size_t stroke, size_t key) const;

 private:
  JobPlane placed(const Bounds& bounds) const;

  JobFile job_;
  LayerTable layers_;
  JobPlane plane_;
  Vec3 eye_{0};  // of --eye
};

// Help of --axes.
inline constexpr const char* kAxesHelp =
    "A JSON file that describes what the rotary axes A, B and C of the program turn: table or head, axis, "
    "pivot; the zero of the program is then that of the world";

// Distance from curves within which they are flattened without a radius [m].
inline constexpr double kCurveTolerance = 1e-5;
// Returns the distance from curves within which they are flattened [m]: a fiftieth of the radius of the beam
// or, without it, of the smallest radius of a layer; at most kCurveTolerance without a radius.
double curve_tolerance(std::optional<double> radius, const LayerTable& layers);

}  // namespace kerf
