#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Adds a copy of a piece as a body of its own, at a placement. The piece itself is not changed.
struct DuplicatePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "duplicate-piece";
  static constexpr std::array<const char*, 3> kKeys{"piece", "position", "orientation"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<DuplicatePiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
