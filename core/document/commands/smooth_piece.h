#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/mesh/openmesh/smooth.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Smooths a piece (see smooth). It becomes a body of its own (see remake_piece).
struct SmoothPiece {
  PieceId piece;
  size_t times = 1;

  static constexpr const char* kName = "smooth";
  static constexpr std::array<const char*, 2> kKeys{"piece", "times"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<SmoothPiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
