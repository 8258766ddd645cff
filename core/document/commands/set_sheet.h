#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Says what the sheet of a piece is: its thickness, its density and the constants of its material. The piece
// becomes a body of its own first, where it is not one already. Its faces keep their energy.
struct SetSheet {
  PieceId piece;
  Sheet sheet;

  static constexpr const char* kName = "set-sheet";
  static constexpr std::array<const char*, 13> kKeys{
      "piece",        "thickness",  "density", "material-density", "heat-solid",         "heat-liquid",
      "conductivity", "transition", "latent",  "emissivity",       "absorptivity-fibre", "absorptivity-co2",
      "wavelength"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<SetSheet> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
