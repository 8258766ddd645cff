#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/document/cut_report.h"
#include "core/document/stroke_path.h"
#include "core/laser/nozzle.h"

namespace kerf {

// The options of `kerf cut` for the setup of a part in a machine: how strokes are fitted to the part as
// measured, and the nozzle round the beam.
struct SetupOptions {
  std::string fit, nozzle;

  // Adds the options to the subcommand. Parsing fills this object.
  void add_to(CLI::App& command);
  // Checks the options and reads the datum points. The error names the first wrong option. `has_strokes`: the
  // job has strokes that the options apply to.
  Status read(bool has_strokes);
  // Moves the strokes onto the part as measured, and records the motion with its residuals. Precondition:
  // read() succeeded.
  Status fit_strokes(const World& world, const MeshReading& reading, std::vector<StrokePath>& strokes,
                     CutJob& job) const;
  // Returns the line of the program that leads to a key of a stroke, if there is one.
  using LineOf = std::function<std::optional<size_t>(size_t stroke, size_t key)>;
  // Records the standoff of the nozzle and its collisions along each segment, before anything is cut. Returns
  // stopped() after Ctrl-C.
  Status check_nozzle(const World& world, const std::vector<StrokePath>& strokes, const LineOf& line_of,
                      CutJob& job) const;

 private:
  std::vector<std::pair<Vec3, Vec3>> datums_;
  std::optional<Nozzle> nozzle_;
};

}  // namespace kerf
