#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Puts a piece at a placement. It becomes a body of its own first, where it is not one already.
struct MovePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "move-piece";
  static constexpr std::array<const char*, 3> kKeys{"piece", "position", "orientation"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<MovePiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
