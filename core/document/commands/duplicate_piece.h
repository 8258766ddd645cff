#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Adds a copy of a piece as a body of its own, at a placement. The piece itself is not changed.
struct DuplicatePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "duplicate-piece";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DuplicatePiece& c);

}  // namespace kerf
