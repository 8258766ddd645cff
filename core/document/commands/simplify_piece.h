#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/mesh/openmesh/simplify.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Simplifies a piece to a number of faces or to an error in metres (see simplify). It becomes a body of its
// own (see remake_piece).
struct SimplifyPiece {
  PieceId piece;
  SimplifyTarget target;

  static constexpr const char* kName = "simplify";
  static constexpr std::array<const char*, 1> kKeys{"piece"};
  static constexpr std::array<const char*, 2> kOptionalKeys{"faces", "error"};  // one of them
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<SimplifyPiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
