#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Says what the sheet of a piece is: its thickness, its density and the constants of its material. The piece
// becomes a body of its own first, where it is not one already. Its faces keep their energy.
struct SetSheet {
  PieceId piece;
  Sheet sheet;

  static constexpr const char* kName = "set-sheet";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSheet& c);

}  // namespace kerf
