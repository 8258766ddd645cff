#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Gives a piece a name, after which pieces that come off it later are named. It becomes a body of its own
// first, where it is not one already.
struct RenamePiece {
  PieceId piece;
  std::string name;

  static constexpr const char* kName = "rename-piece";
  static constexpr std::array<const char*, 2> kKeys{"piece", "name"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return name.size(); }
  void write(CommandWriter& line) const;
  static Result<RenamePiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
