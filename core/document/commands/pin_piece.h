#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Pins a piece where it is, so that nothing moves it while bodies move, or lets it move again. It becomes a
// body of its own first, where it is not one already.
struct PinPiece {
  PieceId piece;
  bool pinned = true;

  static constexpr const char* kName = "pin-piece";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, PinPiece& c);

}  // namespace kerf
