#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/mesh/openmesh/subdivide.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Subdivides every face of a piece once (see subdivide). It becomes a body of its own (see remake_piece).
struct SubdividePiece {
  PieceId piece;
  Subdivision scheme = Subdivision::kLoop;

  static constexpr const char* kName = "subdivide";
  static constexpr std::array<const char*, 2> kKeys{"piece", "scheme"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<SubdividePiece> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
