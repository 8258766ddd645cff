#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cut/knife.h"
#include "core/document/commands.h"
#include "core/world/world.h"

namespace kerf {

// The options of `kerf cut` for cuts along planes and for printing the pieces.
class KnifeOptions {
 public:
  void add_to(CLI::App& command);
  // Parses the options. Fails with bad input that names the option.
  Status read();

  // Executes the commands of all planes by `run`, which returns false if a command met nothing, and then of
  // those that make the pieces fit the bed. `world` is the one that `run` changes. Appends notes on planes
  // that met nothing. Precondition: read() succeeded.
  Status cut(const World& world, const std::function<Result<bool>(const Command&)>& run,
             std::vector<std::string>& notes) const;
  // Returns the commands that lay the pieces on the plane z = 0, each on its largest cut face, in a row along
  // x; empty without --lay-flat. O(faces log faces).
  std::vector<Command> lay_flat(const World& world) const;

 private:
  std::vector<std::string> plane_texts_;
  std::optional<std::string> bed_text_, pegs_text_;
  bool lay_flat_ = false;
  std::vector<KnifePlane> planes_;
  Pegs pegs_;
  std::optional<Vec3> bed_;  // m
};

// Returns the fewest planes, perpendicular to the axes and evenly spaced, that divide a box [m] into cells
// that fit a bed of this size [m]; bad input if there are more than 100 along an axis.
Result<std::vector<KnifePlane>> bed_planes(const Bounds& box, const Vec3& bed);

}  // namespace kerf
