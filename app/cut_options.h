#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/document/stroke_path.h"
#include "core/mesh/mesh_file.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace kerf {

// Options of `kerf cut`. The default of an empty option depends on the meshes and the path file.
struct CutOptions {
  std::vector<std::string> meshes;
  std::string path, out, settings, journal, provenance;
  std::optional<double> radius, target_edge, tolerance, power;
  std::optional<double> settle, ground, thickness, density;
  std::optional<std::string> range, pattern, scheme, rim, model, material, format, assist, cut_material;
  std::optional<int> depth;
  std::optional<int> steps;
  bool split_all = false;
  bool solid = false;
  bool recentre = false;
  bool turn_shells = false;
};

// Adds the options to the subcommand. Parsing fills `options`, which must outlive it.
void add_cut_options(CLI::App& command, CutOptions& options);

// Fills empty options from the file of --settings, a JSON object with the same keys. The error names the file
// and the key; some options may be filled then.
Status merge_settings_file(CutOptions& options);

// Checks the values in the order of the options. The error names the first wrong option.
Status check_cut_options(CutOptions options);

// Makes the rim smooth, as walls require, unless the options name a rim or a beam that leaves none.
void prefer_smooth_rim(CutOptions& options);

// Returns the settings of one stroke. Options take precedence over the laser of the path file, and that over
// the defaults for a bounding box with this diagonal [m]. Precondition: check_cut_options() succeeded.
CutSettings stroke_settings(const CutOptions& options, const StrokePath& stroke, double diagonal);

// Parses "MIN,MAX", an interval in metres.
Result<Interval> parse_range(const std::string& text);

}  // namespace kerf
