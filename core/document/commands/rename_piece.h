#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Gives a piece a name, after which pieces that come off it later are named. It becomes a body of its own
// first, where it is not one already.
struct RenamePiece {
  PieceId piece;
  std::string name;

  static constexpr const char* kName = "rename-piece";
  std::string words() const;
  size_t weight() const { return name.size(); }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, RenamePiece& c);

}  // namespace kerf
