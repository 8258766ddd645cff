#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/job_input.h"
#include "app/knife_options.h"
#include "app/setup_options.h"
#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/document/stroke_path.h"

namespace kerf {

// Options of `kerf cut`. The default of an empty option depends on the meshes and the path file.
struct CutOptions {
  std::vector<std::string> meshes;
  KnifeOptions knife;
  std::string path, out, settings, journal, provenance;
  JobInput job;  // a drawing or a program instead of the path
  SetupOptions setup;
  std::optional<double> radius, target_edge, tolerance, power;
  std::optional<double> settle, ground, thickness, density;
  std::optional<std::string> range, pattern, scheme, rim, model, material, format, assist, cut_material;
  std::optional<std::string> colliders, collider_names, outlines, unit;
  std::optional<int> depth;
  std::optional<int> steps;
  bool split_all = false;
  bool single_file = false;
  bool solid = false;
  bool recentre = false;
  bool turn_shells = false;
};

// Adds the options to the subcommand. Parsing fills `options`, which must outlive it.
void add_cut_options(CLI::App& command, CutOptions& options);

// Fills empty options from the file of --settings, a JSON object with the keys of its help. The error names
// the file and the key; some options may be filled then.
Status merge_settings_file(CutOptions& options);

// Checks the values in the order of the options. The error names the first wrong option.
Status check_cut_options(CutOptions options);

// Makes the rim smooth, as walls of solids require. Fails with bad input if an option names a rim, a model or
// a pattern without walls; `where` names the solid in the error.
Status prepare_for_walls(CutOptions& options, const std::string& where);

// Returns the settings of one stroke. Options take precedence over the laser of the path file, and that over
// the defaults for a bounding box with this diagonal [m]. Precondition: check_cut_options() succeeded.
CutSettings stroke_settings(const CutOptions& options, const StrokePath& stroke, double diagonal);

}  // namespace kerf
