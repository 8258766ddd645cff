#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/document/path_file.h"
#include "core/mesh/write_mesh.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace kerf {

// What `kerf cut` was asked for; what is empty has a default that depends on the meshes and the path.
struct CutOptions {
  std::vector<std::string> meshes;
  std::string path, out, settings, journal;
  std::optional<double> radius, target_edge, tolerance;
  std::optional<std::string> range, pattern, scheme, rim, model, format;
  std::optional<int> depth;
  std::optional<int> steps;
  bool split_all = false;
};

void add_cut_options(CLI::App& command, CutOptions& options);

// Fills what the command line left empty from the file of --settings (a JSON object with the same keys).
Status merge_settings_file(CutOptions& options);

// Checks the values, in the order of the options; the sentence names the option.
Status check_cut_options(const CutOptions& options);

// The settings of one stroke: options, then the path file's laser, then the defaults for meshes whose
// bounding box has this diagonal. The options have been checked.
CutSettings stroke_settings(const CutOptions& options, const StrokePath& stroke, double diagonal);

// "MIN,MAX" in metres.
Result<Interval> parse_range(const std::string& text);

}  // namespace kerf
