#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Sets gravity and the ground.
struct SetSurroundings {
  Surroundings around;

  static constexpr const char* kName = "surroundings";
  static constexpr std::array<const char*, 1> kKeys{"gravity"};
  static constexpr std::array<const char*, 2> kOptionalKeys{"ground", "metre"};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<SetSurroundings> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
