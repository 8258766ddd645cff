#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Removes a piece from the world.
struct DeletePiece {
  PieceId piece;

  static constexpr const char* kName = "delete-piece";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DeletePiece& c);

}  // namespace kerf
