#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Puts a piece at a placement. It becomes a body of its own first, where it is not one already.
struct MovePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "move-piece";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, MovePiece& c);

}  // namespace kerf
