#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Hides a piece, or shows it again. It becomes a body of its own first, where it is not one already.
struct HidePiece {
  PieceId piece;
  bool hidden = true;

  static constexpr const char* kName = "hide-piece";
  static constexpr std::array<const char*, 2> kKeys{"piece", "hidden"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<HidePiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
